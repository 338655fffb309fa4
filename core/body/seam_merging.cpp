#include "body/seam_merging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

namespace drape::body {
namespace {

using Voxel = std::array<std::int64_t, 3>;

std::size_t index(int k) { return std::size_t(k); }

// [points] 1 where an edge of a single triangle ends.
std::vector<char> at_open_edges(const Triangles& mesh) {
  std::map<std::array<int, 2>, int> triangles;
  const auto each_edge = [&](auto visit) {
    for (std::size_t k = 0; k < mesh.corner.size(); ++k) {
      const int a = mesh.corner[k], b = mesh.corner[k % 3 == 2 ? k - 2 : k + 1];
      visit(std::array<int, 2>{std::min(a, b), std::max(a, b)});
    }
  };
  each_edge([&](const std::array<int, 2>& edge) { ++triangles[edge]; });
  std::vector<char> open(mesh.point.size() / 3, 0);
  each_edge([&](const std::array<int, 2>& edge) {
    if (triangles[edge] == 1) open[index(edge[0])] = open[index(edge[1])] = 1;
  });
  return open;
}

double size_of(const std::vector<double>& point) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = INFINITY, high = -INFINITY;
    for (std::size_t n = k; n < point.size(); n += 3)
      low = std::min(low, point[n]), high = std::max(high, point[n]);
    square += (high - low) * (high - low);
  }
  return std::sqrt(square);
}

// The first point within `reach` of p, among those that have been entered; -1 if there is none. Voxels are as
// large as `reach`, so it lies in p's own or in one beside it.
int first_near(const std::map<Voxel, std::vector<int>>& entered, const std::vector<double>& point,
               const Voxel& own, std::size_t p, double reach) {
  int first = -1;
  for (std::int64_t i = -1; i <= 1; ++i)
    for (std::int64_t j = -1; j <= 1; ++j)
      for (std::int64_t k = -1; k <= 1; ++k) {
        const auto found = entered.find({own[0] + i, own[1] + j, own[2] + k});
        if (found == entered.end()) continue;
        for (const int q : found->second) {
          double square = 0;
          for (std::size_t c = 0; c < 3; ++c) {
            const double apart = point[3 * index(q) + c] - point[3 * p + c];
            square += apart * apart;
          }
          if (square <= reach * reach && (first < 0 || q < first)) first = q;
        }
      }
  return first;
}

// Leaves out the points that have become others.
void points_compact(Triangles& mesh, const std::vector<int>& becomes) {
  std::vector<int> place(becomes.size());
  std::size_t kept = 0;
  for (std::size_t p = 0; p < becomes.size(); ++p) {
    if (becomes[p] != int(p)) continue;
    place[p] = int(kept);
    std::copy_n(mesh.point.begin() + std::ptrdiff_t(3 * p), 3, mesh.point.begin() + std::ptrdiff_t(3 * kept));
    ++kept;
  }
  mesh.point.resize(3 * kept);
  for (int& c : mesh.corner) c = place[index(becomes[index(c)])];
}

}  // namespace

void seams_merge(Triangles& mesh) {
  const std::size_t points = mesh.point.size() / 3;
  const bool finite =
      std::all_of(mesh.point.begin(), mesh.point.end(), [](double x) { return std::isfinite(x); });
  const bool sound = finite && std::all_of(mesh.corner.begin(), mesh.corner.end(),
                                           [&](int c) { return c >= 0 && index(c) < points; });
  const double reach = kSeam * size_of(mesh.point);
  if (!sound || !(reach > 0) || !std::isfinite(reach)) return;  // surface_make says what is wrong
  const std::vector<char> open = at_open_edges(mesh);
  std::vector<int> becomes(points);
  std::iota(becomes.begin(), becomes.end(), 0);
  std::map<Voxel, std::vector<int>> entered;
  bool merged = false;
  for (std::size_t p = 0; p < points; ++p) {
    if (!open[p]) continue;
    Voxel own;
    for (std::size_t k = 0; k < 3; ++k)
      own[k] = std::int64_t(std::floor((mesh.point[3 * p + k] - mesh.point[k]) / reach));
    if (const int first = first_near(entered, mesh.point, own, p, reach); first >= 0)
      becomes[p] = first, merged = true;
    else entered[own].push_back(int(p));
  }
  if (merged) points_compact(mesh, becomes);
}

}  // namespace drape::body
