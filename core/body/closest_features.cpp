#include "body/closest_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

enum class On { kFace, kEdge, kVertex };

struct Foot {
  On on;
  int which;  // edge or vertex of the surface
  Vec3 point;
};

// The nearest point of a triangle, by the regions of its corners and edges (Ericson 2005, 5.1.5).
Foot foot_of(const BodySurface& s, int t, const Vec3& x) {
  const std::array<int, 3>& c = s.corner[std::size_t(t)];
  const std::array<int, 3>& e = s.edge[std::size_t(t)];
  const Vec3 &p = s.point[std::size_t(c[0])], &q = s.point[std::size_t(c[1])],
             &r = s.point[std::size_t(c[2])];
  const Vec3 pq = q - p, pr = r - p, px = x - p;
  const double d1 = dot(pq, px), d2 = dot(pr, px);
  if (d1 <= 0 && d2 <= 0) return {On::kVertex, c[0], p};
  const Vec3 qx = x - q;
  const double d3 = dot(pq, qx), d4 = dot(pr, qx);
  if (d3 >= 0 && d4 <= d3) return {On::kVertex, c[1], q};
  const double area_r = d1 * d4 - d3 * d2;
  if (area_r <= 0 && d1 >= 0 && d3 <= 0) return {On::kEdge, e[0], p + (d1 / (d1 - d3)) * pq};
  const Vec3 rx = x - r;
  const double d5 = dot(pq, rx), d6 = dot(pr, rx);
  if (d6 >= 0 && d5 <= d6) return {On::kVertex, c[2], r};
  const double area_q = d5 * d2 - d1 * d6;
  if (area_q <= 0 && d2 >= 0 && d6 <= 0) return {On::kEdge, e[2], p + (d2 / (d2 - d6)) * pr};
  const double area_p = d3 * d6 - d5 * d4;
  if (area_p <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return {On::kEdge, e[1], q + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (r - q)};
  return {On::kFace, t, x - dot(s.facet[std::size_t(t)].normal, px) * s.facet[std::size_t(t)].normal};
}

constexpr double kSlack = 0.02;   // of the layer
constexpr double kBeyond = 1e-9;  // rounding in "stands beyond"

// True where no neighbour is nearer than a foot on an edge or vertex.
bool is_minimum(const BodySurface& s, const Foot& foot, const Vec3& x) {
  const Vec3 away = x - foot.point;
  const double rounding = kBeyond * norm(away);
  if (foot.on == On::kEdge) {
    for (const Vec3& into : s.edges[std::size_t(foot.which)].into)
      if (dot(away, into) > rounding) return false;
    return true;
  }
  for (int k : s.edges_at[std::size_t(foot.which)]) {
    const SurfaceEdge& e = s.edges[std::size_t(k)];
    const int other = e.corner[0] == foot.which ? e.corner[1] : e.corner[0];
    const Vec3 along = s.point[std::size_t(other)] - foot.point;
    if (dot(away, along) > rounding * norm(along)) return false;
  }
  return true;
}

// Feet on the rim of a triangle that x stands over are no minima: the triangle is nearer.
bool on_rim(const BodySurface& s, const Foot& foot, int triangle) {
  const auto& rim = foot.on == On::kEdge ? s.edge[std::size_t(triangle)] : s.corner[std::size_t(triangle)];
  return rim[0] == foot.which || rim[1] == foot.which || rim[2] == foot.which;
}

Vec3 normal_of(const BodySurface& s, const Foot& foot) {
  if (foot.on == On::kFace) return s.facet[std::size_t(foot.which)].normal;
  if (foot.on == On::kEdge) return s.edges[std::size_t(foot.which)].normal;
  return s.normal_at[std::size_t(foot.which)];
}

std::array<double, 6> shape_of(const BodySurface& s, const Foot& foot) {
  if (foot.on == On::kVertex) return {1, 0, 0, 1, 0, 1};
  if (foot.on == On::kFace) {
    const Vec3& n = s.facet[std::size_t(foot.which)].normal;
    return {n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2]};
  }
  const SurfaceEdge& edge = s.edges[std::size_t(foot.which)];
  const Vec3 along = s.point[std::size_t(edge.corner[1])] - s.point[std::size_t(edge.corner[0])];
  const Vec3 e = (1 / norm(along)) * along;
  return {1 - e[0] * e[0], -e[0] * e[1], -e[0] * e[2], 1 - e[1] * e[1], -e[1] * e[2], 1 - e[2] * e[2]};
}

// Which side the particle is on, and how far.
ClosestFeature feature_of(const BodySurface& s, const Foot& foot, const Vec3& x, double contact_distance,
                        const Vec3* side) {
  const Vec3 away = x - foot.point, normal = normal_of(s, foot);
  const double distance = norm(away), out = dot(away, normal);
  ClosestFeature feature{foot.point, shape_of(s, foot), normal, distance};
  double sign = out < 0 ? -1 : 1;  // a sheet: the side that the particle is on
  if (s.solid) {
    if (out < 0) feature.distance = -distance;
  } else if (side && distance < contact_distance && dot(*side, away) < 0) {  // it has gone through: it belongs back
    feature.distance = -distance;
    sign = -sign;
  }
  if (distance > 1e-12) feature.side = ((feature.distance < 0 ? -1 : 1) / distance) * away;
  else feature.side = sign * normal;
  return feature;
}

// How far x may go along the triangle until a neighbour is nearer by more than `slack`.
double inside_by(const BodySurface& s, int t, const Vec3& x, double slack) {
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

// Of two triangles that share an edge, true where the other one does not rise over the face of the first on
// the side of the particle: it cannot touch before the particle leaves the first.
// At a vertex without grooves all of its triangles fall away.
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

// How often the surface goes round x: 1 inside, 0 outside, between them near its holes. Sum of solid angles
// over 4 pi; of a triangle with corners a, b, c from x (Van Oosterom, Strackee 1983):
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

void closest_features_find(const BodySurface& s, const std::vector<int>& triangle, const Vec3& x,
                           double contact_distance, double within, double reach, double listed, const Vec3* side,
                           ClosestFeatures& found) {
  found.feature.clear();
  double clear = listed;  // of all triangles that are not near
  struct Candidate {
    int triangle;
    double distance;
    Foot foot;
  };
  static thread_local std::vector<Candidate> near, kept;
  near.clear();
  kept.clear();
  for (int t : triangle) {
    const Facet& f = s.facet[std::size_t(t)];
    const Vec3 d = x - f.middle;
    const double square = dot(d, d), ball = f.reach;
    if (square >= (ball + clear) * (ball + clear)) continue;
    const double over = std::abs(dot(d, f.normal));
    if (over >= reach || square >= (ball + reach) * (ball + reach)) {
      clear = std::min(clear, std::max(over, std::sqrt(square) - ball));
      continue;
    }
    const Foot foot = foot_of(s, t, x);
    const double distance = norm(x - foot.point);
    if (distance >= reach) {
      clear = std::min(clear, distance);
      continue;
    }
    near.push_back({t, distance, foot});
  }
  for (const Candidate& c : near)
    if (c.distance <= within && c.foot.on == On::kFace) kept.push_back(c);
  const std::size_t faces = kept.size();
  for (const Candidate& c : near) {
    if (c.distance > within || c.foot.on == On::kFace) continue;
    const bool beside = std::any_of(kept.begin(), kept.begin() + std::ptrdiff_t(faces),
                                    [&](const Candidate& f) { return on_rim(s, c.foot, f.triangle); });
    if (!beside && is_minimum(s, c.foot, x)) kept.push_back(c);
  }
  std::sort(kept.begin(), kept.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
  });
  static thread_local std::vector<std::array<int, 2>> seen;  // kind and number
  seen.clear();
  for (const Candidate& c : kept) {
    const std::array<int, 2> name{int(c.foot.on), c.foot.which};
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
    seen.push_back(name);
    const ClosestFeature feature = feature_of(s, c.foot, x, contact_distance, found.feature.empty() ? side : nullptr);
    if (!found.feature.empty() && (feature.distance < 0 || found.feature[0].distance < 0)) continue;
    found.feature.push_back(feature);
  }
  found.free_distance = clear - contact_distance;
  const bool one_face = found.feature.size() == 1 && seen.size() == 1 && seen[0][0] == int(On::kFace);
  const int face = one_face ? seen[0][1] : -1;
  if (one_face) found.free_distance = std::min(found.free_distance, inside_by(s, face, x, kSlack * contact_distance));
  else if (!found.feature.empty()) found.free_distance = 0;
  for (const Candidate& c : near) {
    if (c.distance - contact_distance >= found.free_distance || c.triangle == face) continue;
    if (one_face && falls_away(s, face, c.triangle, found.feature[0].side)) continue;
    found.free_distance = c.distance - contact_distance;
  }
}

double closest_features_distance(const BodySurface& s, int triangle, const Vec3& x) {
  return norm(x - foot_of(s, triangle, x).point);
}

double closest_features_signed(const BodySurface& s, int triangle, const Vec3& x) {
  const Foot foot = foot_of(s, triangle, x);
  const double distance = norm(x - foot.point);
  const bool inside = s.solid && dot(x - foot.point, normal_of(s, foot)) < 0 && winding_number(s, x) > 0.5;
  return inside ? -distance : distance;
}

}  // namespace drape::body
