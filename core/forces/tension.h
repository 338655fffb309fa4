// A curve read in lanes: the force per width (and its slope) at a strain. core/README.md, section 2.
//
// with_tension() picks the reader once per row: nothing for a law that is off, one product for a straight
// diagram, a table otherwise.
#pragma once
#include "fabric/curve.h"
#include "forces/lane.h"

namespace drape {
namespace {

struct NoTension {
  static constexpr bool kTable = false;
  template <class L>
  DRAPE_INLINE L operator()(L) const {
    return L(0.0);
  }
  template <class L>
  DRAPE_INLINE L slope(L) const {
    return L(0.0);
  }
};

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

// Where the strains of a lane lie: their bins, then their segments.
template <class L>
DRAPE_INLINE void bins_store(const Curve& curve, L x, int* bins) {
  const L bin = fma(x, L(curve.bin_scale), L(curve.bin_shift));
  L::truncate(bins, max(min(bin, L(kCurveBins - 1.0)), L(0.0)));
}
DRAPE_INLINE const double* segment_find(const Curve& curve, int bin, double x) {
  const CurveSegment* segment = curve.segment + curve.bin_begin[bin];
  segment += x >= segment->end;
  for (int k = 1; k < curve.bin_ends; ++k) segment += x >= segment->end;
  return &segment->origin;
}

// The segments of a lane: f = c0 + t (c1 + t^2 (c3 + t (c4 + t c5))).
template <class L, bool kOdd>
struct SegmentTension {
  const double* const* rows;  // [kWidth] segments
  DRAPE_INLINE L operator()(L e) const {
    L origin, c0, c1, c3, c4, c5;
    L::columns(rows, origin, c0, c1, c3, c4, c5);
    const L t = (kOdd ? abs(e) : e) - origin;
    const L f = fma(t, fma(t * t, fma(t, fma(t, c5, c4), c3), c1), c0);
    return kOdd ? copysign(f, e) : f;
  }
  DRAPE_INLINE L slope(L e) const {
    L origin, c0, c1, c3, c4, c5;
    L::columns(rows, origin, c0, c1, c3, c4, c5);
    const L t = (kOdd ? abs(e) : e) - origin;
    return fma(t * t, fma(t, fma(t, L(5.0) * c5, L(4.0) * c4), L(3.0) * c3), c1);
  }
};

template <bool kOdd_>
struct TableTension {
  static constexpr bool kTable = true, kOdd = kOdd_;
  const Curve* curve;
  template <class L>
  DRAPE_INLINE L operator()(L e) const {
    const double* rows[L::kWidth];
    find(e, rows);
    return SegmentTension<L, kOdd>{rows}(e);
  }
  template <class L>
  DRAPE_INLINE L slope(L e) const {
    const double* rows[L::kWidth];
    find(e, rows);
    return SegmentTension<L, kOdd>{rows}.slope(e);
  }

 private:
  template <class L>
  DRAPE_INLINE void find(L e, const double** rows) const {
    const L x = kOdd ? abs(e) : e;
    alignas(64) int bins[L::kWidth];
    alignas(64) double strains[L::kWidth];
    bins_store(*curve, x, bins);
    L::store(strains, x);
    for (int i = 0; i < L::kWidth; ++i) rows[i] = segment_find(*curve, bins[i], strains[i]);
  }
};

// Any curve, chosen at each call: for passes that are rare. A curve that is off reads as 0 from its first,
// empty segment.
struct AnyTension {
  const Curve* curve;
  template <class L>
  DRAPE_INLINE L operator()(L e) const {
    return curve->odd ? TableTension<true>{curve}(e) : TableTension<false>{curve}(e);
  }
  template <class L>
  DRAPE_INLINE L slope(L e) const {
    return curve->odd ? TableTension<true>{curve}.slope(e) : TableTension<false>{curve}.slope(e);
  }
};

template <class Body>
DRAPE_INLINE void with_tension(const Curve& curve, Body body) {
  if (curve.segments == 0) body(NoTension{});
  else if (curve.segments == 1) body(LineTension{curve.segment[0].c1});
  else if (curve.odd) body(TableTension<true>{&curve});
  else body(TableTension<false>{&curve});
}

}  // namespace
}  // namespace drape
