#include "standards/trellis.h"

#include <cmath>

namespace drape::standards {

// The diagram extends to 10 % of elongation: 12 degrees of shear.
Diagram trellis_bias(double shear) {
  Diagram d;
  for (int percent = 0; percent <= 10; ++percent) {
    const double l1 = 1 + percent / 100.0, g = std::asin(l1 * l1 - 1), l2 = std::sqrt(2 - l1 * l1);
    d.percent.push_back(percent);
    d.force_per_width.push_back(2 * shear * g / l2);
  }
  return d;
}

}  // namespace drape::standards
