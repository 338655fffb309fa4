#include "body/closest_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

// The closest point of a triangle, by the Voronoi regions of its corners and edges (Ericson 2005, 5.1.5).
TrianglePoint closest_of(const BodySurface& s, int t, const Vec3& x) {
  const std::array<int, 3>& c = s.corner[std::size_t(t)];
  const std::array<int, 3>& e = s.edge[std::size_t(t)];
  const Vec3 &p = s.point[std::size_t(c[0])], &q = s.point[std::size_t(c[1])],
             &r = s.point[std::size_t(c[2])];
  const Vec3 pq = q - p, pr = r - p, px = x - p;
  const double d1 = dot(pq, px), d2 = dot(pr, px);
  if (d1 <= 0 && d2 <= 0) return {FeatureKind::kVertex, c[0], p};
  const Vec3 qx = x - q;
  const double d3 = dot(pq, qx), d4 = dot(pr, qx);
  if (d3 >= 0 && d4 <= d3) return {FeatureKind::kVertex, c[1], q};
  const double area_r = d1 * d4 - d3 * d2;
  if (area_r <= 0 && d1 >= 0 && d3 <= 0) return {FeatureKind::kEdge, e[0], p + (d1 / (d1 - d3)) * pq};
  const Vec3 rx = x - r;
  const double d5 = dot(pq, rx), d6 = dot(pr, rx);
  if (d6 >= 0 && d5 <= d6) return {FeatureKind::kVertex, c[2], r};
  const double area_q = d5 * d2 - d1 * d6;
  if (area_q <= 0 && d2 >= 0 && d6 <= 0) return {FeatureKind::kEdge, e[2], p + (d2 / (d2 - d6)) * pr};
  const double area_p = d3 * d6 - d5 * d4;
  if (area_p <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return {FeatureKind::kEdge, e[1], q + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (r - q)};
  return {FeatureKind::kFace, t,
          x - dot(s.facet[std::size_t(t)].normal, px) * s.facet[std::size_t(t)].normal};
}

constexpr double kSlack = 0.02;   // of the contact distance
constexpr double kBeyond = 1e-9;  // relative rounding error of the tests for a minimum

// True where a closest point on an edge or vertex is a local minimum: none of its neighbours is closer to x.
bool is_minimum(const BodySurface& s, const TrianglePoint& closest, const Vec3& x) {
  const Vec3 away = x - closest.point;
  const double rounding = kBeyond * norm(away);
  if (closest.kind == FeatureKind::kEdge) {
    for (const Vec3& into : s.edges[std::size_t(closest.index)].into)
      if (dot(away, into) > rounding) return false;
    return true;
  }
  for (int k : s.edges_at[std::size_t(closest.index)]) {
    const SurfaceEdge& e = s.edges[std::size_t(k)];
    const int other = e.corner[0] == closest.index ? e.corner[1] : e.corner[0];
    const Vec3 along = s.point[std::size_t(other)] - closest.point;
    if (dot(away, along) > rounding * norm(along)) return false;
  }
  return true;
}

// True where a closest point is on the boundary of a triangle. If x projects into that triangle, the point is
// no minimum: the face is closer.
bool on_boundary(const BodySurface& s, const TrianglePoint& closest, int triangle) {
  const auto& boundary =
      closest.kind == FeatureKind::kEdge ? s.edge[std::size_t(triangle)] : s.corner[std::size_t(triangle)];
  return boundary[0] == closest.index || boundary[1] == closest.index || boundary[2] == closest.index;
}

Vec3 normal_of(const BodySurface& s, const TrianglePoint& closest) {
  if (closest.kind == FeatureKind::kFace) return s.facet[std::size_t(closest.index)].normal;
  if (closest.kind == FeatureKind::kEdge) return s.edges[std::size_t(closest.index)].normal;
  return s.normal_at[std::size_t(closest.index)];
}

std::array<double, 6> shape_of(const BodySurface& s, const TrianglePoint& closest) {
  if (closest.kind == FeatureKind::kVertex) return {1, 0, 0, 1, 0, 1};
  if (closest.kind == FeatureKind::kFace) {
    const Vec3& n = s.facet[std::size_t(closest.index)].normal;
    return {n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2]};
  }
  const SurfaceEdge& edge = s.edges[std::size_t(closest.index)];
  const Vec3 along = s.point[std::size_t(edge.corner[1])] - s.point[std::size_t(edge.corner[0])];
  const Vec3 e = (1 / norm(along)) * along;
  return {1 - e[0] * e[0], -e[0] * e[1], -e[0] * e[2], 1 - e[1] * e[1], -e[1] * e[2], 1 - e[2] * e[2]};
}

// The feature with the side of the surface that the particle belongs to, and the signed distance.
ClosestFeature feature_of(const BodySurface& s, const TrianglePoint& closest, int triangle, const Vec3& x,
                          double contact_distance, const Vec3* side) {
  const Vec3 away = x - closest.point, normal = normal_of(s, closest);
  const double distance = norm(away), out = dot(away, normal);
  ClosestFeature feature{closest.point, shape_of(s, closest), normal, distance, triangle};
  double sign = out < 0 ? -1 : 1;  // open surface: the side that the particle is on
  if (s.solid) {
    if (out < 0) feature.distance = -distance;
  } else if (side && distance < contact_distance &&
             dot(*side, away) < 0) {  // the particle has passed through
    feature.distance = -distance;
    sign = -sign;
  }
  if (distance > 1e-12) feature.side = ((feature.distance < 0 ? -1 : 1) / distance) * away;
  else feature.side = sign * normal;
  return feature;
}

// A point on an edge or vertex within a plane is one of the face: nothing pushes along the plane.
TrianglePoint flattened(const BodySurface& s, const TrianglePoint& closest, int triangle, const Vec3& x) {
  const bool flat = closest.kind == FeatureKind::kEdge     ? s.edges[std::size_t(closest.index)].flat
                    : closest.kind == FeatureKind::kVertex ? s.flat_at[std::size_t(closest.index)]
                                                           : false;
  if (!flat) return closest;
  const Vec3& n = s.facet[std::size_t(triangle)].normal;
  return {FeatureKind::kFace, triangle, x - dot(n, x - closest.point) * n};
}

// How far (m) x may move along the triangle until a neighbour is closer by more than `slack`.
double distance_to_boundary(const BodySurface& s, int t, const Vec3& x, double slack) {
  double smallest = INFINITY;
  const std::array<int, 3>& c = s.corner[std::size_t(t)];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = s.point[std::size_t(c[k])], &b = s.point[std::size_t(c[(k + 1) % 3])],
               &opposite = s.point[std::size_t(c[(k + 2) % 3])];
    const Vec3 along = (1 / norm(b - a)) * (b - a);
    Vec3 into = opposite - a;
    into -= dot(into, along) * along;
    const double turn = s.edges[std::size_t(s.edge[std::size_t(t)][k])].turn;
    const double beyond = turn > 0 ? slack / turn : 0;
    smallest = std::min(smallest, dot(x - a, into) / norm(into) + std::min(beyond, norm(b - a)));
  }
  return smallest;
}

// True where triangle `other` is a neighbour of triangle `first` and does not rise above its plane on the
// side of the particle. Then the particle cannot touch `other` before it leaves `first`. At a vertex where
// all edges are convex, none of the triangles rises above another.
bool falls_away(const BodySurface& s, int first, int other, const Vec3& side) {
  for (int c : s.corner[std::size_t(first)])
    if (s.convex_at[std::size_t(c)])
      for (int d : s.corner[std::size_t(other)])
        if (c == d) return true;
  for (int e : s.edge[std::size_t(first)]) {
    const SurfaceEdge& edge = s.edges[std::size_t(e)];
    for (std::size_t k = 0; k < edge.triangle.size(); ++k)
      if (edge.triangle[k] == other) return dot(edge.into[k], side) <= kBeyond;
  }
  return false;
}

// The winding number of the surface around x: 1 inside, 0 outside, in between near holes. It is the sum of
// the triangles' solid angles over 4 pi. A triangle with corners a, b, c relative to x has the solid angle A
// (Van Oosterom, Strackee 1983):
//
//   tan(A/2) = a.(b x c)/(|a||b||c| + a.b |c| + b.c |a| + c.a |b|)
double winding_number(const BodySurface& s, const Vec3& x) {
  double sum = 0;
  for (std::size_t t = 0; t < s.corner.size(); ++t) {
    const std::array<int, 3>& k = s.corner[t];
    const Vec3 a = s.point[std::size_t(k[0])] - x, b = s.point[std::size_t(k[1])] - x,
               c = s.point[std::size_t(k[2])] - x;
    const double la = norm(a), lb = norm(b), lc = norm(c), volume = dot(a, cross(b, c)),
                 out = dot(cross(b - a, c - a), s.facet[t].normal);
    sum += std::atan2(out < 0 ? -volume : volume,
                      la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace

namespace {

using Candidate = ClosestFeaturesScratch::Candidate;

// Collects the triangles within `reach` of x. Returns a lower bound (m) of the distance to all others.
double candidates_collect(const BodySurface& s, const std::vector<int>& triangle,
                          const ClosestFeaturesQuery& q, std::vector<Candidate>& near) {
  near.clear();
  double clear = q.listed;
  for (int t : triangle) {
    const Facet& f = s.facet[std::size_t(t)];
    const Vec3 d = q.x - f.middle;
    const double square = dot(d, d), radius = f.radius;
    if (square >= (radius + clear) * (radius + clear)) continue;
    const double over = std::abs(dot(d, f.normal));
    if (over >= q.reach || square >= (radius + q.reach) * (radius + q.reach)) {
      clear = std::min(clear, std::max(over, std::sqrt(square) - radius));
      continue;
    }
    const TrianglePoint closest = closest_of(s, t, q.x);
    const double distance = norm(q.x - closest.point);
    if (distance >= q.reach) {
      clear = std::min(clear, distance);
      continue;
    }
    near.push_back({t, distance, closest});
  }
  return clear;
}

// Keeps the candidates that are local minima within `within`, sorted by distance.
void minima_keep(const BodySurface& s, const ClosestFeaturesQuery& q, const std::vector<Candidate>& near,
                 std::vector<Candidate>& minima) {
  minima.clear();
  for (const Candidate& c : near)
    if (c.distance <= q.within && c.closest.kind == FeatureKind::kFace) minima.push_back(c);
  const std::size_t faces = minima.size();
  for (const Candidate& c : near) {
    if (c.distance > q.within || c.closest.kind == FeatureKind::kFace) continue;
    const bool beside =
        std::any_of(minima.begin(), minima.begin() + std::ptrdiff_t(faces),
                    [&](const Candidate& f) { return on_boundary(s, c.closest, f.triangle); });
    if (!beside && is_minimum(s, c.closest, q.x)) minima.push_back(c);
  }
  std::sort(minima.begin(), minima.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
  });
}

}  // namespace

void closest_features_find(const BodySurface& s, const std::vector<int>& triangle,
                           const ClosestFeaturesQuery& q, ClosestFeaturesScratch& scratch,
                           ClosestFeatures& found) {
  found.feature.clear();
  const double clear = candidates_collect(s, triangle, q, scratch.near);
  minima_keep(s, q, scratch.near, scratch.minima);
  auto& seen = scratch.seen;
  seen.clear();
  int face = -1;  // of the closest feature, where it is on one
  for (const Candidate& c : scratch.minima) {
    const std::array<int, 2> name{int(c.closest.kind), c.closest.index};
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
    seen.push_back(name);
    const TrianglePoint closest = flattened(s, c.closest, c.triangle, q.x);
    if (seen.size() == 1 && closest.kind == FeatureKind::kFace) face = closest.index;
    const ClosestFeature feature =
        feature_of(s, closest, c.triangle, q.x, q.contact_distance, found.feature.empty() ? q.side : nullptr);
    if (!found.feature.empty() && (feature.distance < 0 || found.feature[0].distance < 0)) continue;
    found.feature.push_back(feature);
  }
  found.free_distance = clear - q.contact_distance;
  const bool one_face = found.feature.size() == 1 && seen.size() == 1 && face >= 0;
  if (!one_face) face = -1;
  if (one_face)
    found.free_distance =
        std::min(found.free_distance, distance_to_boundary(s, face, q.x, kSlack * q.contact_distance));
  else if (!found.feature.empty()) found.free_distance = 0;
  for (const Candidate& c : scratch.near) {
    if (c.distance - q.contact_distance >= found.free_distance || c.triangle == face) continue;
    if (one_face && falls_away(s, face, c.triangle, found.feature[0].side)) continue;
    found.free_distance = c.distance - q.contact_distance;
  }
}

double closest_features_distance(const BodySurface& s, int triangle, const Vec3& x) {
  return norm(x - closest_of(s, triangle, x).point);
}

double closest_features_signed(const BodySurface& s, int triangle, const Vec3& x) {
  const TrianglePoint closest = closest_of(s, triangle, x);
  const double distance = norm(x - closest.point);
  const bool inside =
      s.solid && dot(x - closest.point, normal_of(s, closest)) < 0 && winding_number(s, x) > 0.5;
  return inside ? -distance : distance;
}

}  // namespace drape::body
