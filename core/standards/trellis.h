// The diagram of a strip cut at 45 degrees, without jaws, from the shear stiffness.
//
// A trellis of yarns of fixed length is sheared by the angle g. Its diagonals are then l1 = sqrt(1 + sin g)
// and l2 = sqrt(1 - sin g) times their length at rest. With the shear stress tau = G g, the work tau dg of a
// unit of area equals that of the strip, (F/width) dl1:
//
//   F/width = G g dg/dl1 = 2 G g/l2,     sin g = l1^2 - 1,     l2 = sqrt(2 - l1^2).
//
// The odd law of core/README.md, section 3, solved from this diagram is g(e) = 2 G e up to the relative error
// x^2/24 with x = sin g. Its shear stress is G [(1 - x)^-1/2 - (1 + x)^-1/2] cos g = G g (1 - x^2/24 + ...).
#pragma once
#include "standards/diagram.h"

namespace drape::standards {

Diagram trellis_bias(double shear);  // `shear` G in N/m per rad

}  // namespace drape::standards
