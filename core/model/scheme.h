// One kick and the drift that follows it, in numbers. core/README.md, section 4.
//
//     v <- decay v + kick a,     r <- r + drift v
//
// The kick of leapfrog straddles t_n: it begins at t_n - h_o/2, in the step before, and ends at t_n + h/2.
#pragma once
#include "math/vector3.h"

namespace drape::model {

// What forces, constraints and contact act on: the step itself, the synchronous velocities v_n that complete
// its last half kick, or the accelerations at t_n.
enum class Pass { kStep, kSynchronous, kAcceleration };

struct Scheme {
  Pass pass = Pass::kStep;
  double decay = 1;             // of v in the kick
  double kick = 0;              // s, over `impulse`
  double drift = 0;             // s
  double half = 0;              // s, of the kick's time, the part in the step before
  double half_new = 0;          // s, the part in this step
  double span = 0;              // s, half + half_new
  double impulse = 1;           // an impulse over its change of m v: 1 + c h/2
  double centred = 1;           // v_n = (v_{n-1/2} + half a)/centred: 1 + c h_o/2
  double decay_before = 1;      // of v in the drift before; 1 in leapfrog, whose damping is centred
  double decay_drift = 1;       // of v in this drift, likewise
  double extrapolation = 0;     // forces act at v + extrapolation (v - w), v = v_{n-1/2}, w = v_{n-3/2}
  Vec3 gravity{0, 0, 0};        // m/s^2
  bool begins_advance = false;  // the part `half` belongs to the advance before
};

}  // namespace drape::model
