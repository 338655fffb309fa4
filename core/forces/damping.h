// Damping along links (core/README.md, section 3): the tension of a link from its strain e and strain rate
// e'.
//
//   r0 o---->----o r1      T = w [p(e) + beta p'(e) e'],   e' = (u1 - u0).(r1 - r0)/(l l0)
//      u0       u1
//
// The force acts along the link: no net force, no net torque, and none in rigid motion. It dissipates the
// power w l0 beta p' e'^2.
#pragma once
#include "simd/lane.h"

namespace drape::forces {
namespace {

template <class L, class Tension>
DRAPE_INLINE L damped_tension(Tension tension, L e, L rate, double beta) {
  return fma(L(beta) * tension.slope(e), rate, tension(e));
}

}  // namespace
}  // namespace drape::forces
