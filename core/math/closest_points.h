// The closest points of points, segments, triangles and lines.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/vector3.h"

namespace drape::math {

// The point of a triangle closest to p: sum weight[k] corner[k]. `arm` is the vector from that point to p.
struct TriangleClosest {
  double weight[3];
  Vec3 arm;
  double distance2;
};

// The point of the segment from a to b closest to p: a + s (b - a). Returns s, from 0 to 1.
inline double segment_closest(const Vec3& p, const Vec3& a, const Vec3& b) {
  using namespace vector3;
  const Vec3 e = b - a;
  const double length2 = dot(e, e);
  return length2 > 0 ? std::clamp(dot(p - a, e) / length2, 0.0, 1.0) : 0;
}

// The squared distance from p to a segment.
inline double segment_distance2(const Vec3& p, const Vec3& a, const Vec3& b) {
  using namespace vector3;
  const Vec3 arm = (p - a) - segment_closest(p, a, b) * (b - a);
  return dot(arm, arm);
}

// The foot of the perpendicular is a + u e1 + v e2 with (p - a - u e1 - v e2).e = 0. If it is inside the
// triangle, it is the closest point. Otherwise the closest point is on an edge.
inline TriangleClosest triangle_closest(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  using namespace vector3;
  const Vec3 e1 = b - a, e2 = c - a, q = p - a;
  const double g11 = dot(e1, e1), g12 = dot(e1, e2), g22 = dot(e2, e2), q1 = dot(q, e1), q2 = dot(q, e2);
  const double area2 = g11 * g22 - g12 * g12, u = q1 * g22 - q2 * g12, v = q2 * g11 - q1 * g12;
  if (area2 > 0 && u >= 0 && v >= 0 && u + v <= area2) {
    const double s = u / area2, t = v / area2;
    const Vec3 arm = q - s * e1 - t * e2;
    return {{1 - s - t, s, t}, arm, dot(arm, arm)};
  }
  const Vec3* corner[3] = {&a, &b, &c};
  TriangleClosest best{{}, {}, INFINITY};
  for (int k = 0; k < 3; ++k) {
    const Vec3 &from = *corner[k], &to = *corner[(k + 1) % 3];
    const double s = segment_closest(p, from, to);
    const Vec3 arm = (p - from) - s * (to - from);
    const double distance2 = dot(arm, arm);
    if (!(distance2 < best.distance2)) continue;
    best = {{0, 0, 0}, arm, distance2};
    best.weight[k] = 1 - s;
    best.weight[(k + 1) % 3] = s;
  }
  return best;
}

inline constexpr double kParallel = 1e-4;  // sin^2 of the angle below which lines are parallel

// The closest points of two lines along e and f; r is the vector from the start of the second line to the
// start of the first. The points are s e and t f from the starts. `skew` is false where the lines are
// parallel; then s and t have no meaning.
struct LinesClosest {
  double s, t;
  bool skew;
};
inline LinesClosest lines_closest(const Vec3& e, const Vec3& f, const Vec3& r) {
  using namespace vector3;
  const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), er = dot(e, r), fr = dot(f, r);
  const double det = ee * ff - ef * ef;
  if (!(det > kParallel * ee * ff)) return {0, 0, false};
  return {(ef * fr - ff * er) / det, (ee * fr - ef * er) / det, true};
}

// The closest points of two edges: their parameters along the edges, and the vector `arm` from the point on
// the second edge to that on the first. `crosses`: both points are inside their edges and the edges are not
// parallel. Otherwise only `distance2` has a meaning.
struct EdgesClosest {
  double share[2];
  Vec3 arm;
  double distance2;
  bool crosses;
};
inline EdgesClosest edges_closest(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  using namespace vector3;
  const Vec3 e = a1 - a0, f = b1 - b0, r = a0 - b0;
  const auto [s, t, skew] = lines_closest(e, f, r);
  if (skew && s > 0 && s < 1 && t > 0 && t < 1) {
    const Vec3 arm = r + s * e - t * f;
    return {{s, t}, arm, dot(arm, arm), true};
  }
  const double smallest = std::min(std::min(segment_distance2(a0, b0, b1), segment_distance2(a1, b0, b1)),
                                   std::min(segment_distance2(b0, a0, a1), segment_distance2(b1, a0, a1)));
  return {{0, 0}, {0, 0, 0}, smallest, false};
}

}  // namespace drape::math
