// Damping along springs (core/README.md, section 3): what a link pulls with, at rest of its length and
// moving.
//
//   r0 o---->----o r1      T = w [p(e) + beta p'(e) e'],   e' = (u1 - u0).(r1 - r0)/(l l0)
//      u0       u1
//
// Along the link only: no net force or torque, nothing in rigid motion; it takes w l0 beta p' e'^2 from the
// cloth.
#pragma once
#include "forces/link_rows.h"

namespace drape {
namespace {

// The tension alone.
struct Elastic {
  template <class L, class Tension>
  DRAPE_INLINE L operator()(Tension tension, const LinkLane<L>& link, long) const {
    return tension(link.strain);
  }
};

template <class L, class Tension>
DRAPE_INLINE L damped_tension(Tension tension, L e, L rate, double beta) {
  return fma(L(beta) * tension.slope(e), rate, tension(e));
}

// With damping; the rows hold the velocities of the links' ends.
struct Damped {
  ConstRow from, to;
  double beta, inverse_rest;
  template <class L, class Tension>
  DRAPE_INLINE L operator()(Tension tension, const LinkLane<L>& link, long i) const {
    const Vec<L> speed = vec_load<L>(to, i) - vec_load<L>(from, i);
    const L rate = dot(speed, link.edge) * (link.inverse * L(inverse_rest));
    return damped_tension(tension, link.strain, rate, beta);
  }
};

}  // namespace
}  // namespace drape
