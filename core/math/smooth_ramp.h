// phi of the penalty and its integral, at a depth e > 0; phi' reaches 1 at e = blend. core/README.md,
// section 7.
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
