#include "body/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

// Most scanned meshes have a few badly repaired edges. A body with more of them than this is an open surface,
// which cloth may touch from both sides.
constexpr double kBadEdges = 0.01;  // of all edges
constexpr double kFlat = 1e-6;      // sine of the angle between triangles that lie in one plane
constexpr double kNoArea = 1e-12;   // relative to the square of the longest edge

std::size_t index(int k) { return std::size_t(k); }

std::string corners_trouble(const std::vector<Vec3>& point, const std::vector<std::array<int, 3>>& corner) {
  for (std::size_t k = 0; k < point.size(); ++k)
    if (!std::isfinite(point[k][0] + point[k][1] + point[k][2]))
      return "has a vertex that is no number, vertex " + std::to_string(k + 1);
  for (std::size_t t = 0; t < corner.size(); ++t)
    for (int c : corner[t])
      if (c < 0 || index(c) >= point.size())
        return "has a face of a vertex that is not there, face " + std::to_string(t + 1);
  return "";
}

void triangles_collect(BodySurface& s, const std::vector<std::array<int, 3>>& corner,
                       SurfaceFindings& findings) {
  for (const std::array<int, 3>& c : corner) {
    const Vec3 &p = s.point[index(c[0])], &q = s.point[index(c[1])], &r = s.point[index(c[2])];
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
        s.edges_at[index(a)].push_back(at->second);
        s.edges_at[index(b)].push_back(at->second);
      }
      SurfaceEdge& e = s.edges[index(at->second)];
      const Vec3 along = unit(s.point[index(b)] - s.point[index(a)]);
      e.triangle.push_back(int(t));
      e.into.push_back(
          cross(s.facet[t].normal, along));  // corners run counter-clockwise: into is to the left of the edge
      s.edge[t][k] = at->second;
    }
}

void edges_classify(BodySurface& s, SurfaceFindings& findings) {
  for (SurfaceEdge& e : s.edges) {
    if (e.triangle.size() == 1) ++findings.open;
    if (e.triangle.size() > 2) ++findings.crowded;
    if (e.triangle.size() != 2) continue;
    const auto runs_forward = [&](int t) {
      const std::array<int, 3>& c = s.corner[index(t)];
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
    sum += dot(s.point[index(c[0])], cross(s.point[index(c[1])], s.point[index(c[2])])) / 6;
  return sum;
}

void normals_spread(BodySurface& s) {
  s.normal_at.assign(s.point.size(), Vec3{0, 0, 0});
  for (std::size_t t = 0; t < s.corner.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = s.point[index(s.corner[t][k])];
      const Vec3 a = unit(s.point[index(s.corner[t][(k + 1) % 3])] - p),
                 b = unit(s.point[index(s.corner[t][(k + 2) % 3])] - p);
      s.normal_at[index(s.corner[t][k])] += std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * s.facet[t].normal;
    }
  for (Vec3& n : s.normal_at) n = unit(n);
  for (SurfaceEdge& e : s.edges) {
    for (int t : e.triangle) e.normal += s.facet[index(t)].normal;
    e.normal = unit(e.normal);
  }
}

// Sets the turn of each edge and marks the points at concave edges and within planes. An edge is concave (a
// groove) where one of its triangles rises above the plane of the other.
void turns_set(BodySurface& s) {
  s.convex_at.assign(s.point.size(), 1);
  s.flat_at.assign(s.point.size(), 1);
  for (SurfaceEdge& e : s.edges) {
    const bool two = e.triangle.size() == 2;
    if (two) {
      const Vec3 &a = s.facet[index(e.triangle[0])].normal, &b = s.facet[index(e.triangle[1])].normal;
      e.turn = norm(cross(a, b));
      e.flat = e.turn <= kFlat && dot(a, b) > 0;
    }
    if (!e.flat)
      for (int c : e.corner) s.flat_at[index(c)] = 0;
    if (two && s.solid && dot(e.into[0], s.facet[index(e.triangle[1])].normal) <= 1e-9) continue;
    for (int c : e.corner) s.convex_at[index(c)] = 0;
  }
}

void sizes_set(BodySurface& s) {
  for (const SurfaceEdge& e : s.edges)
    s.edge_mean += norm(s.point[index(e.corner[1])] - s.point[index(e.corner[0])]) / double(s.edges.size());
  Vec3 low = s.facet[0].middle, high = low;
  for (const std::array<int, 3>& c : s.corner)
    for (int k : c)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], s.point[index(k)][i]);
        high[i] = std::max(high[i], s.point[index(k)][i]);
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
  if (s.solid && volume(s) < 0) {  // its normals point inwards
    for (Facet& f : s.facet) f.normal = -1.0 * f.normal;
  }
  normals_spread(s);
  turns_set(s);
  sizes_set(s);
  return s;
}

}  // namespace drape::body
