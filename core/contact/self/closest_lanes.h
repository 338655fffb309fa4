// The points of triangles closest to particles, in lanes.
#pragma once
#include "contact/self/narrow_phase.h"
#include "simd/vector_lanes.h"

namespace drape::contact {
namespace {

// As math::TriangleClosest.
template <class L>
struct ClosestLanes {
  L weight[3];
  simd::Vec<L> arm;
  L distance2;
};

// The closest point of the side from corner k, at `from` from the first corner, to the next: `edge` is the
// vector between them; q is p less the first corner.
template <class L>
DRAPE_INLINE ClosestLanes<L> side_closest(const simd::Vec<L>& q, const simd::Vec<L>& from,
                                          const simd::Vec<L>& edge, int k) {
  const L length2 = dot(edge, edge), zero(0.0), one(1.0);
  const simd::Vec<L> p = q - from;
  const L s = min(max(dot(p, edge) / select(gt(length2, zero), length2, one), zero), one);
  ClosestLanes<L> c{{zero, zero, zero}, p - edge * s, zero};
  c.weight[k] = one - s;
  c.weight[(k + 1) % 3] = s;
  c.distance2 = dot(c.arm, c.arm);
  return c;
}

template <class L>
DRAPE_INLINE void take_where(typename L::Mask where, const ClosestLanes<L>& from, ClosestLanes<L>& to) {
  for (int k = 0; k < 3; ++k) to.weight[k] = select(where, from.weight[k], to.weight[k]);
  to.arm = {select(where, from.arm.x, to.arm.x), select(where, from.arm.y, to.arm.y),
            select(where, from.arm.z, to.arm.z)};
  to.distance2 = select(where, from.distance2, to.distance2);
}

// The foot of the perpendicular where it is inside the triangle, else the closest point of a side.
template <class L>
DRAPE_INLINE ClosestLanes<L> closest_lanes(const simd::Vec<L>& p, const simd::Vec<L>& a,
                                           const simd::Vec<L>& b, const simd::Vec<L>& c) {
  const L zero(0.0), one(1.0);
  const simd::Vec<L> e1 = b - a, e2 = c - a, q = p - a;
  const L g11 = dot(e1, e1), g12 = dot(e1, e2), g22 = dot(e2, e2), q1 = dot(q, e1), q2 = dot(q, e2);
  const L area2 = g11 * g22 - g12 * g12, u = q1 * g22 - q2 * g12, v = q2 * g11 - q1 * g12;
  const auto spans = gt(area2, zero);
  const L least = select(spans, min(min(u, v), area2 - (u + v)), L(-1.0));
  const L over = one / select(spans, area2, one), s = u * over, t = v * over;
  ClosestLanes<L> best{{one - s - t, s, t}, q - e1 * s - e2 * t, zero};
  best.distance2 = dot(best.arm, best.arm);
  const auto outside = gt(zero, least);
  if (!any(outside)) return best;
  const simd::Vec<L> first{zero, zero, zero};
  ClosestLanes<L> side = side_closest(q, first, e1, 0);
  const ClosestLanes<L> second = side_closest(q, e1, e2 - e1, 1), third = side_closest(q, e2, first - e2, 2);
  take_where(gt(side.distance2, second.distance2), second, side);
  take_where(gt(side.distance2, third.distance2), third, side);
  take_where(outside, side, best);
  return best;
}

template <class L>
void self_points_lanes(const double* const r[3], SelfPointBlock* begin, SelfPointBlock* end) {
  for (SelfPointBlock* b = begin; b != end; ++b)
    for (std::size_t i = 0; i < math::kRowUnit; i += L::kWidth) {
      simd::Vec<L> at[4];
      for (int k = 0; k < 4; ++k)
        at[k] = {L::gather(r[0], b->node[k] + i), L::gather(r[1], b->node[k] + i),
                 L::gather(r[2], b->node[k] + i)};
      const ClosestLanes<L> c = closest_lanes(at[0], at[1], at[2], at[3]);
      for (int k = 0; k < 3; ++k) L::store(b->weight[k] + i, c.weight[k]);
      L::store(b->arm[0] + i, c.arm.x), L::store(b->arm[1] + i, c.arm.y), L::store(b->arm[2] + i, c.arm.z);
      L::store(b->distance + i, sqrt(c.distance2));
    }
}

}  // namespace
}  // namespace drape::contact
