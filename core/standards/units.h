// Units of laboratory data sheets, in SI units. The gram-force follows from the standard acceleration of
// gravity, 9.80665 m/s^2 (3rd CGPM, 1901); the pound is 0.45359237 kg (international yard and pound, 1959).
#pragma once
#include <numbers>

namespace drape::standards {

inline constexpr double kStandardGravity = 9.80665;                   // m/s^2
inline constexpr double kKilogramForce = kStandardGravity;            // N
inline constexpr double kGramForce = 1e-3 * kStandardGravity;         // N
inline constexpr double kPoundForce = 0.45359237 * kStandardGravity;  // N
inline constexpr double kGramForcePerCm = 1e2 * kGramForce;           // N/m
inline constexpr double kInch = 0.0254;                               // m
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180;

}  // namespace drape::standards
