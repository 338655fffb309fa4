// The smooth ramp phi(e) of the contact penalty, and its integral, at the depth e > 0. The slope phi' rises
// from 0 at e = 0 to 1 at e = blend and stays 1. Depth and blend in m. core/README.md, section 7.
#pragma once
#include <algorithm>

namespace drape::math {

inline double smooth_ramp(double blend, double depth) {
  const double t = std::min(depth / blend, 1.0);
  return blend * t * t * t * (1 - t / 2) + std::max(depth - blend, 0.0);
}

inline double smooth_ramp_integral(double blend, double depth) {
  const double t = std::min(depth / blend, 1.0), on = std::max(depth - blend, 0.0);
  return blend * blend * t * t * t * t * (0.25 - t / 10) + on * (blend / 2 + on / 2);
}

}  // namespace drape::math
