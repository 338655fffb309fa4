// What contact with bodies and of cloth with cloth share, in lanes.
#pragma once
#include "simd/lane.h"

namespace drape::contact {
namespace {

// The penalty phi and its slope phi' at a depth (m); t is the depth over the blend (m), from 0 to 1.
// math/smooth_ramp.h has the same in doubles.
template <class L>
struct RampLanes {
  L phi, slope;

  DRAPE_INLINE RampLanes(L blend, L depth, L t) {
    const L t2 = t * t;
    phi = fma(blend, t2 * t * fma(L(-0.5), t, L(1.0)), max(depth - blend, L(0.0)));
    slope = t2 * fma(L(-2.0), t, L(3.0));
  }
};

// The least normal velocity (m/s) that a stop allows, by the distance to it (m), below 0 past it. Rates: 1/s.
template <class L>
DRAPE_INLINE L stop_velocity(L clearance, L stop_rate, L push_rate) {
  return L(0.0) - clearance * select(ge(clearance, L(0.0)), stop_rate, push_rate);
}

}  // namespace
}  // namespace drape::contact
