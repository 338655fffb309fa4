#include "body/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

// A few bad edges are mended badly in most scans; a body with more of them is a sheet with two sides.
constexpr double kBadEdges = 0.01;  // of all
constexpr double kNoArea = 1e-12;   // of the longest edge squared

std::size_t place(int k) { return std::size_t(k); }

std::string corners_trouble(const std::vector<Vec3>& point, const std::vector<std::array<int, 3>>& corner) {
  for (std::size_t k = 0; k < point.size(); ++k)
    if (!std::isfinite(point[k][0] + point[k][1] + point[k][2]))
      return "has a vertex that is no number, vertex " + std::to_string(k + 1);
  for (std::size_t t = 0; t < corner.size(); ++t)
    for (int c : corner[t])
      if (c < 0 || place(c) >= point.size())
        return "has a face of a vertex that is not there, face " + std::to_string(t + 1);
  return "";
}

void triangles_collect(BodySurface& s, const std::vector<std::array<int, 3>>& corner,
                       SurfaceFindings& findings) {
  for (const std::array<int, 3>& c : corner) {
    const Vec3 &p = s.point[place(c[0])], &q = s.point[place(c[1])], &r = s.point[place(c[2])];
    const Vec3 area = cross(q - p, r - p);
    const double longest = std::max({norm(q - p), norm(r - q), norm(p - r)});
    if (!(norm(area) > kNoArea * longest * longest)) {
      ++findings.degenerate;
      continue;
    }
    s.corner.push_back(c);
    const Vec3 middle = (1.0 / 3) * (p + q + r);
    s.facet.push_back({middle, std::max({norm(p - middle), norm(q - middle), norm(r - middle)}), unit(area)});
  }
}

void edges_find(BodySurface& s) {
  std::map<std::array<int, 2>, int> known;
  s.edge.resize(s.corner.size());
  s.edges_at.resize(s.point.size());
  for (std::size_t t = 0; t < s.corner.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = s.corner[t][k], b = s.corner[t][(k + 1) % 3];
      const auto [at, fresh] =
          known.emplace(std::array<int, 2>{std::min(a, b), std::max(a, b)}, int(s.edges.size()));
      if (fresh) {
        s.edges.push_back({at->first, {}, {}, {0, 0, 0}});
        s.edges_at[place(a)].push_back(at->second);
        s.edges_at[place(b)].push_back(at->second);
      }
      SurfaceEdge& e = s.edges[place(at->second)];
      const Vec3 along = unit(s.point[place(b)] - s.point[place(a)]);
      e.triangle.push_back(int(t));
      e.into.push_back(
          cross(s.facet[t].normal, along));  // counter-clockwise corners: to the left of the edge
      s.edge[t][k] = at->second;
    }
}

void edges_classify(BodySurface& s, SurfaceFindings& findings) {
  for (SurfaceEdge& e : s.edges) {
    if (e.triangle.size() == 1) ++findings.open;
    if (e.triangle.size() > 2) ++findings.crowded;
    if (e.triangle.size() != 2) continue;
    const auto runs_forward = [&](int t) {
      const std::array<int, 3>& c = s.corner[place(t)];
      for (std::size_t k = 0; k < 3; ++k)
        if (c[k] == e.corner[0] && c[(k + 1) % 3] == e.corner[1]) return true;
      return false;
    };
    if (runs_forward(e.triangle[0]) == runs_forward(e.triangle[1])) ++findings.turned;
  }
  const std::size_t bad = findings.open + findings.crowded + findings.turned;
  s.solid = double(bad) <= kBadEdges * double(s.edges.size());
}

double volume(const BodySurface& s) {
  double sum = 0;
  for (const std::array<int, 3>& c : s.corner)
    sum += dot(s.point[place(c[0])], cross(s.point[place(c[1])], s.point[place(c[2])])) / 6;
  return sum;
}

void normals_spread(BodySurface& s) {
  s.normal_at.assign(s.point.size(), Vec3{0, 0, 0});
  for (std::size_t t = 0; t < s.corner.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = s.point[place(s.corner[t][k])];
      const Vec3 a = unit(s.point[place(s.corner[t][(k + 1) % 3])] - p),
                 b = unit(s.point[place(s.corner[t][(k + 2) % 3])] - p);
      s.normal_at[place(s.corner[t][k])] += std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * s.facet[t].normal;
    }
  for (Vec3& n : s.normal_at) n = unit(n);
  for (SurfaceEdge& e : s.edges) {
    for (int t : e.triangle) e.normal += s.facet[place(t)].normal;
    e.normal = unit(e.normal);
  }
}

// An edge is a groove where one triangle rises over the other.
void turns_set(BodySurface& s) {
  s.convex_at.assign(s.point.size(), 1);
  for (SurfaceEdge& e : s.edges) {
    const bool two = e.triangle.size() == 2;
    if (two) e.turn = norm(cross(s.facet[place(e.triangle[0])].normal, s.facet[place(e.triangle[1])].normal));
    if (two && s.solid && dot(e.into[0], s.facet[place(e.triangle[1])].normal) <= 1e-9) continue;
    for (int c : e.corner) s.convex_at[place(c)] = 0;
  }
}

void sizes_set(BodySurface& s) {
  for (const SurfaceEdge& e : s.edges)
    s.edge_mean += norm(s.point[place(e.corner[1])] - s.point[place(e.corner[0])]) / double(s.edges.size());
  Vec3 low = s.facet[0].middle, high = low;
  for (const std::array<int, 3>& c : s.corner)
    for (int k : c)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], s.point[place(k)][i]);
        high[i] = std::max(high[i], s.point[place(k)][i]);
      }
  s.size = norm(high - low);
}

}  // namespace

BodySurface surface_make(const std::vector<Vec3>& point, const std::vector<std::array<int, 3>>& corner,
                         SurfaceFindings& findings, std::string& trouble) {
  BodySurface s;
  trouble = corners_trouble(point, corner);
  if (!trouble.empty()) return s;
  s.point = point;
  triangles_collect(s, corner, findings);
  if (s.corner.empty()) return trouble = "has no triangle with an area", s;
  edges_find(s);
  edges_classify(s, findings);
  if (s.solid && volume(s) < 0) {  // its faces look inwards
    for (Facet& f : s.facet) f.normal = -1.0 * f.normal;
  }
  normals_spread(s);
  turns_set(s);
  sizes_set(s);
  return s;
}

}  // namespace drape::body
