// Damping along springs (core/README.md, section 3): what a link pulls with, at rest of its length and
// moving.
//
//   r0 o---->----o r1      T = w [p(e) + beta p'(e) e'],   e' = (u1 - u0).(r1 - r0)/(l l0)
//      u0       u1
//
// Along the link only: no net force or torque, nothing in rigid motion; it takes w l0 beta p' e'^2 from the
// cloth.
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
