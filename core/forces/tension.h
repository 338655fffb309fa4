// Evaluates a curve in lanes: force per width, N/m, and its slope, at a strain. core/README.md, section 2.
//
// A straight diagram is one product. Any other curve is a table: first find the segment that contains the
// strain, then evaluate its polynomial.
#pragma once
#include <cstddef>

#include "math/monotone_curve.h"
#include "simd/lane.h"

namespace drape::forces {
namespace {

struct LineTension {
  static constexpr bool kTable = false;
  double stiffness;  // N/m
  template <class L>
  DRAPE_INLINE L operator()(L e) const {
    return L(stiffness) * e;
  }
  template <class L>
  DRAPE_INLINE L slope(L) const {
    return L(stiffness);
  }
};

// The bins that contain the strains of a lane; then the segment within a bin.
template <class L>
DRAPE_INLINE void bins_store(const math::Curve& curve, L x, int* bins) {
  const L bin = fma(x, L(curve.bin_scale), L(curve.bin_shift));
  L::truncate(bins, max(min(bin, L(math::kCurveBins - 1.0)), L(0.0)));
}
DRAPE_INLINE const double* segment_find(const math::Curve& curve, int bin, double x) {
  const math::CurveSegment* segment = curve.segment + curve.bin_begin[bin];
  segment += x >= segment->end;
  for (int k = 1; k < curve.bin_ends; ++k) segment += x >= segment->end;
  return &segment->origin;
}

// The segments that contain the strains of a lane: origin and coefficients.
template <class L>
struct Segments {
  L origin, c0, c1, c3, c4, c5;
};

// The argument of a curve: |e| for an odd curve, e for any other. sign: the sign bit that was removed.
template <class L>
struct Read {
  L x, sign;
};
template <class L>
DRAPE_INLINE Read<L> strain_read(const math::Curve& curve, L e) {
  const L sign = bits_and(e, L(curve.odd ? -0.0 : 0.0));
  return {bits_xor(e, sign), sign};
}

// f = c0 + t (c1 + t^2 (c3 + t (c4 + t c5))), its slope, and its integral from the origin.
template <class L>
DRAPE_INLINE L segments_value(const Segments<L>& s, Read<L> at) {
  const L t = at.x - s.origin;
  return bits_xor(fma(t, fma(t * t, fma(t, fma(t, s.c5, s.c4), s.c3), s.c1), s.c0), at.sign);
}
template <class L>
DRAPE_INLINE L segments_slope(const Segments<L>& s, Read<L> at) {
  const L t = at.x - s.origin;
  return fma(t * t, fma(t, fma(t, L(5.0) * s.c5, L(4.0) * s.c4), L(3.0) * s.c3), s.c1);
}

template <class L>
DRAPE_INLINE L segments_integral(const Segments<L>& s, Read<L> at) {
  const L t = at.x - s.origin, t2 = t * t;
  const L cubic = fma(t, fma(t, s.c5 * L(1.0 / 6), s.c4 * L(0.2)), s.c3 * L(0.25));
  return fma(t2, fma(t2, cubic, s.c1 * L(0.5)), t * s.c0);
}

template <class L>
DRAPE_INLINE Segments<L> segments_load(const double* const* rows) {
  Segments<L> s;
  L::columns(rows, s.origin, s.c0, s.c1, s.c3, s.c4, s.c5);
  return s;
}

// Any curve, its segments loaded from memory.
template <class L>
DRAPE_INLINE void segments_find(const math::Curve& curve, L x, const double** rows) {
  alignas(64) int bins[L::kWidth];
  alignas(64) double strains[L::kWidth];
  bins_store(curve, x, bins);
  L::store(strains, x);
  for (int i = 0; i < L::kWidth; ++i) rows[i] = segment_find(curve, bins[i], strains[i]);
}
template <class L>
DRAPE_INLINE Segments<L> segments_search(const math::Curve& curve, L x) {
  const double* rows[L::kWidth];
  segments_find(curve, x, rows);
  return segments_load<L>(rows);
}

// Segments picked from registers. No strain may lie beyond the start of the curve.
template <class L, int kSize>
DRAPE_INLINE Segments<L> segments_pick(const math::CurveStart<kSize>& start, L x) {
  const auto bin = L::places(fma(max(x, L(start.low)), L(start.scale), L(start.shift)));
  const auto at = L::next(L::pick(start.first, bin), ge(x, L::pick(start.end, bin)));
  const auto column = [&](int k) DRAPE_INLINE_LAMBDA { return L::pick(start.column[k], at); };
  return {column(0), column(1), column(2), column(3), column(4), column(5)};
}

// Beyond the start of the curve. GCC knows which registers a function of the same file leaves alone. Clang
// takes it that a call overwrites all of them, so there only the rare path is a call.
#ifdef __clang__
template <class L>
__attribute__((noinline, cold)) void segments_far(const math::Curve& curve, L x, Segments<L>& found) {
  found = segments_search(curve, x);
}
template <class L>
DRAPE_INLINE void segments_beyond(const math::Curve& curve, L x, Segments<L>& found) {
  if (any(ge(x, L(curve.start16.limit)))) [[unlikely]]
    segments_far(curve, x, found);
  else found = segments_pick(curve.start16, x);
}
#else
template <class L>
__attribute__((noinline)) void segments_beyond(const math::Curve& curve, L x, Segments<L>& found) {
  found = any(ge(x, L(curve.start16.limit))) ? segments_search(curve, x) : segments_pick(curve.start16, x);
}
#endif

template <class L>
DRAPE_INLINE Segments<L> segments_of(const math::Curve& curve, L x) {
  if constexpr (L::kPermutes) {
    if (!any(ge(x, L(curve.start8.limit)))) return segments_pick(curve.start8, x);
    Segments<L> found;
    segments_beyond(curve, x, found);
    return found;
  } else {
    return segments_search(curve, x);
  }
}

// Any curve. A direction without a law evaluates to 0, from its first, empty segment.
struct CurveTension {
  static constexpr bool kTable = true;
  const math::Curve* curve;
  template <class L>
  DRAPE_INLINE L operator()(L e) const {
    const Read<L> at = strain_read(*curve, e);
    return segments_value(segments_of(*curve, at.x), at);
  }
  template <class L>
  DRAPE_INLINE L slope(L e) const {
    const Read<L> at = strain_read(*curve, e);
    return segments_slope(segments_of(*curve, at.x), at);
  }
  // The integral from 0 to e.
  template <class L>
  DRAPE_INLINE L energy(L e) const {
    constexpr std::ptrdiff_t kEnergy = offsetof(math::CurveSegment, energy) / sizeof(double);
    const Read<L> at = strain_read(*curve, e);
    const double* rows[L::kWidth];
    alignas(64) double before[L::kWidth];
    segments_find(*curve, at.x, rows);
    for (int i = 0; i < L::kWidth; ++i) before[i] = rows[i][kEnergy];
    return L::load(before) + segments_integral(segments_load<L>(rows), at);
  }
};

}  // namespace
}  // namespace drape::forces
