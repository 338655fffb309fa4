// The allowed range of each quantity that can be set, in SI units. The keys of a scene, the checks of new
// parameter values and the ranges of the FMU variables all use this table.
#pragma once
#include <cstddef>

namespace drape::scene {

inline constexpr std::size_t kMinSamples = 3, kMaxSamples = 100000;  // of a tensile tester, a diagram

struct Quantity {
  const char* name;
  double low, high;
  bool above;  // `low` itself is not allowed
  const char* unit;
  bool whole = false;  // integers only
};

constexpr bool quantity_fits(const Quantity& q, double value) {  // false for NaN
  const bool within = (q.above ? value > q.low : value >= q.low) && value <= q.high;
  return within && (!q.whole || value == double(long(value)));
}

inline constexpr Quantity kArealDensity{"areal_density", 1e-4, 100, false, "kg/m2"};
inline constexpr Quantity kForce{"force", 0, 1e6, false, "N"};
inline constexpr Quantity kPoisson{"poisson", 0, 0.999, false, "1"};
inline constexpr Quantity kCompression{"compression", 0, 1, false, "1"};
inline constexpr Quantity kGravity{"gravity", -1e4, 1e4, false, "m/s2"};
inline constexpr Quantity kDamping{"damping", 0, 1e6, false, "1/s"};
inline constexpr Quantity kSpringDamping{"damping", 0, 1, false, "s"};
inline constexpr Quantity kFriction{"friction", 0, 10, false, "1"};
inline constexpr Quantity kAirCoefficient{"air", 0, 1000, false, "1"};
inline constexpr Quantity kRamp{"parameter_ramp", 0, 1e6, false, "s"};

inline constexpr Quantity kClose{"close", 0, 1, false, "1", true};

// Inputs.
inline constexpr Quantity kWind{"wind", -1e3, 1e3, false, "m/s"};
inline constexpr Quantity kPinPosition{"position", -1e4, 1e4, false, "m"};
inline constexpr Quantity kPinVelocity{"velocity", -1e4, 1e4, false, "m/s"};
inline constexpr Quantity kPinOrientation{"orientation", -1e6, 1e6, false, "1"};
inline constexpr Quantity kPinAngularVelocity{"angular_velocity", -1e4, 1e4, false, "rad/s"};

// The bending rigidity of the fabric is EI of a specimen over the width of the specimen.
inline constexpr Quantity kSpecimenRigidity{"bending.rigidity", 0, 0.1, false, "N.m2"};
inline constexpr Quantity kSpecimenWidth{"bending.width", 1e-4, 10, false, "m"};
inline constexpr Quantity kBending{"bending", 0, kSpecimenRigidity.high / kSpecimenWidth.low, false, "N.m"};

// A limit of the step above the longest communication interval has no effect.
inline constexpr Quantity kCommunication{"communication", 1e-9, 1e3, false, "s"};
inline constexpr Quantity kStepMax{"step.max", kCommunication.low, kCommunication.high, false, "s"};

inline constexpr const char* kModeNames[] = {"dynamic", "fit"};  // of scene.mode, in the order of Mode

inline constexpr Quantity kThreads{"threads", 1, 64, false, "1", true};

}  // namespace drape::scene
