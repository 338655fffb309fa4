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

// f = c0 + t (c1 + t^2 (c3 + t (c4 + t c5)))
template <bool kOdd>
struct TableTension {
  const Curve* curve;
  template <class L>
  DRAPE_INLINE L operator()(L e) const {
    const L x = kOdd ? abs(e) : e;
    const auto k = L::find(x, curve->start, curve->segments);
    const L t = x - L::gather(curve->origin, k);
    const L cubic = fma(t, fma(t, L::gather(curve->c5, k), L::gather(curve->c4, k)), L::gather(curve->c3, k));
    const L f = fma(t, fma(t * t, cubic, L::gather(curve->c1, k)), L::gather(curve->c0, k));
    return kOdd ? copysign(f, e) : f;
  }
  template <class L>
  DRAPE_INLINE L slope(L e) const {
    const L x = kOdd ? abs(e) : e;
    const auto k = L::find(x, curve->start, curve->segments);
    const L t = x - L::gather(curve->origin, k);
    const L c3 = L(3.0) * L::gather(curve->c3, k), c4 = L(4.0) * L::gather(curve->c4, k),
            c5 = L(5.0) * L::gather(curve->c5, k);
    return fma(t * t, fma(t, fma(t, c5, c4), c3), L::gather(curve->c1, k));
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
  else if (curve.segments == 1) body(LineTension{curve.c1[0]});
  else if (curve.odd) body(TableTension<true>{&curve});
  else body(TableTension<false>{&curve});
}

}  // namespace
}  // namespace drape
