// The elliptic integral of the second kind. C++ has it in <cmath>, but not every library does, and they round
// it differently.
#pragma once

namespace drape::math {

// E(angle, modulus) = int_0^angle sqrt(1 - modulus^2 sin^2 u) du, for any angle (rad) and 0 <= modulus <= 1.
// Its relative error is below 1e-14.
double elliptic_second(double angle, double modulus);

}  // namespace drape::math
