// The paths that inputs take within an advance: core/README.md, section 4, "Inputs".
//
// Both the position and the rotation vector f, R(z) = exp(f(z)) R(0), are cubics in the share z of the
// advance's length H:  c_1 z + c_2 z^2 + c_3 z^3  from where the pin is.
#pragma once
#include <cstdint>
#include <vector>

#include "math/rigid_motion.h"
#include "model/system.h"
#include "scene/scene.h"

namespace drape::dynamics {

// Inputs at the end of an advance. Of a pin only the components that its drive names count.
struct Inputs {
  Vec3 wind{0, 0, 0};                   // m/s
  std::vector<math::RigidMotion> pin;   // [pins]
  std::vector<math::RigidMotion> body;  // [bodies]
};
Inputs inputs_at(const State& state);  // the present inputs

struct PinPath {
  int pin = 0;
  double length = 0;                 // H, s
  math::RigidMotion from, to;        // at its ends
  Vec3 translation[3], rotation[3];  // coefficients of z, z^2, z^3
  bool uniform = false;              // driven by constant velocities
  bool jumps = false;                // its first velocity is not that of `from`
};

struct Path {
  std::vector<PinPath> pins;    // of the driven ones
  std::vector<PinPath> bodies;  // of those that move; `pin` is the body
  Vec3 wind_from{0, 0, 0}, wind_to{0, 0, 0};
  std::int64_t interval = 0, intervals = 1;  // of the advance: the present one, and all
};

// What a body follows on its way to an input. Without a stated drive that is its positions, and from the
// first velocity other than 0 on its velocities too.
scene::Drive body_drive(const model::Body& body, const model::BodyContact& now, const math::RigidMotion& to);

Path path_make(const System& system, const State& state, const Inputs& inputs, double length);

// True where the velocity of a pin, or of a body, at the beginning of its path differs from the one before by
// more than rounding.
bool pins_jump(const Path& path);
bool bodies_jump(const Path& path);

// True where a pin or the wind moves; where a pin rotates.
bool path_moves(const Path& path);
bool path_rotates(const Path& path);

// Begins interval k, of `length` (s). Uniform motion restarts there, so that it does not depend on how a
// master groups its steps.
void path_interval(Path& path, const State& state, std::int64_t k, double length);

// The motion at the share z of a path.
math::RigidMotion path_frame(const PinPath& path, double z);

// Moves wind and pins of the state, or its bodies, to the share u of the present interval.
void path_follow(const Path& path, double u, State& state);
void bodies_follow(const Path& path, double u, State& state);

}  // namespace drape::dynamics
