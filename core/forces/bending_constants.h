// psi(y) = theta/sin theta and its derivatives at a fold of 120 degrees, where its continuation begins:
// core/README.md, section 3.
#pragma once

namespace drape::forces {

inline constexpr double kSharp = -0.5;                     // cos 120 degrees
inline constexpr double kSharpPsi = 2.4183991523122903;    // 4 pi / (3 sqrt 3)
inline constexpr double kSharpPsi1 = -2.9455994348748598;  // (y psi - 1)/(1 - y^2)
inline constexpr double kSharpPsi2 = 9.115731072832773;    // (psi + 3 y psi_1)/(1 - y^2)

}  // namespace drape::forces
