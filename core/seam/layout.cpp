// Both sides have the same number of particles, at equal distances along their outlines:
//
//   n = max(1, ceil(max(l1, l2)/min(b1, b2))),   R_p = l_p/n;   particle k of side p at the arc length k R_p
//
// [P, equations 1 and 2] use the spacing R_p = l_p min(b1, b2)/max(l1, l2). That is rarely l_p over an
// integer, so the ends would not coincide. Where both sides are closed, the last particle would equal the
// first and is omitted.
#include "seam/layout.h"

#include <algorithm>
#include <cmath>

#include "piece/outline/outline.h"

namespace drape::seam {
namespace {

constexpr double kWhole = 1e-9;  // of a spacing: rounding error of an integer

double distance(Vec2 p, Vec2 q) { return std::hypot(q[0] - p[0], q[1] - p[1]); }

// Appends the points at the arc lengths k length/n, k = 0 .. n, and the unit vectors to the left of the line
// there.
void points_along(const std::vector<Vec2>& line, double length, int n, std::vector<Vec2>& points,
                  std::vector<Vec2>& left) {
  std::size_t segment = 0;
  const auto left_of = [&] {
    const Vec2 p = line[segment], q = line[segment + 1];
    const double size = distance(p, q);
    left.push_back({(p[1] - q[1]) / size, (q[0] - p[0]) / size});
  };
  points.push_back(line.front());
  left_of();
  double before = 0,
         here = distance(line[0], line[1]);  // of the segment: arc length at its start; its length
  for (int k = 1; k < n; ++k) {
    const double at = length * k / n;
    while (before + here < at && segment + 2 < line.size()) {
      before += here;
      ++segment;
      here = distance(line[segment], line[segment + 1]);
    }
    const double share = here > 0 ? std::min((at - before) / here, 1.0) : 0;
    const Vec2 p = line[segment], q = line[segment + 1];
    points.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])});
    left_of();
  }
  segment = line.size() - 2;
  points.push_back(line.back());
  left_of();
}

// True if the outline, with its curves, is clockwise.
bool is_clockwise(const scene::PieceSpec& piece) {
  std::vector<Vec2> points;
  for (int e = 0; e < int(piece.outline.size()); ++e) {
    const std::vector<Vec2> edge = piece::outline_edge(piece, e);
    points.insert(points.end(), edge.begin(), edge.end() - 1);
  }
  return piece::polygon_area(points) < 0;
}

}  // namespace

std::vector<int> seam_chain(const scene::PieceSpec& piece, const scene::SeamSide& side) {
  const int count = int(piece.outline.size());
  std::vector<char> in(std::size_t(count), 0);
  for (int e : side.edges) {
    if (e < 0 || e >= count || in[std::size_t(e)]) return {};
    in[std::size_t(e)] = 1;
  }
  int first = -1;  // the edge whose predecessor is not in the side; the first edge given if all are
  for (int e : side.edges)
    if (!in[std::size_t((e + count - 1) % count)]) {
      if (first >= 0) return {};
      first = e;
    }
  if (first < 0) first = side.edges[0];
  std::vector<int> chain;
  for (int k = 0; k < int(side.edges.size()); ++k) chain.push_back((first + k) % count);
  return chain;
}

std::vector<Vec2> seam_line(const scene::PieceSpec& piece, const scene::SeamSide& side) {
  std::vector<Vec2> line;
  for (int e : seam_chain(piece, side)) {
    if (!line.empty()) line.pop_back();
    const std::vector<Vec2> edge = piece::outline_edge(piece, e);
    line.insert(line.end(), edge.begin(), edge.end());
  }
  if (side.reverse) std::reverse(line.begin(), line.end());
  return line;
}

double seam_length(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) sum += distance(line[k], line[k + 1]);
  return sum;
}

SeamLayout seam_layout(const Scene& scene, const scene::SeamSpec& seam) {
  SeamLayout layout;
  std::vector<Vec2> line[2];
  double cell = INFINITY;
  layout.closed = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const scene::PieceSpec& piece = scene.pieces[std::size_t(seam.side[k].piece)];
    line[k] = seam_line(piece, seam.side[k]);
    layout.length[k] = seam_length(line[k]);
    cell = std::min(cell, piece.cell);
    layout.closed = layout.closed && seam.side[k].edges.size() == piece.outline.size();
  }
  const double expected = std::max(layout.length[0], layout.length[1]) / cell;
  const int n = std::max(1, int(std::ceil(expected - kWhole)));
  for (std::size_t k = 0; k < 2; ++k) {
    layout.spacing[k] = layout.length[k] / n;
    points_along(line[k], layout.length[k], n, layout.point[k], layout.inward[k]);
    if (layout.closed) layout.point[k].pop_back(), layout.inward[k].pop_back();
    const scene::PieceSpec& piece = scene.pieces[std::size_t(seam.side[k].piece)];
    if (is_clockwise(piece) != seam.side[k].reverse)
      for (Vec2& v : layout.inward[k]) v = {-v[0], -v[1]};
  }
  return layout;
}

}  // namespace drape::seam
