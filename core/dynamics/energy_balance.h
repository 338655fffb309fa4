// The energy balance, kick by kick: the energy that forces which depend on velocity dissipate, and the work
// of wind, clamps and closing seams. Only with System::energy. core/README.md, section 4.
#pragma once
#include "model/system.h"

namespace drape::dynamics {

// The workspace of one step; made once per System.
struct Balance {
  Array vx, vy, vz;              // [nodes] m/s, before the kick
  Array fx, fy, fz;              // [nodes] N, of damping along springs and air
  Vec3 air{0, 0, 0};             // N, of air alone
  Vec3 wind{0, 0, 0};            // m/s, before the step
  std::vector<Vec3> held, link;  // [clamps] R D and the link before the step
  std::vector<Vec3> pull, rate;  // [pairs of seams] N and m/s, of the gaps, before the step
};
Balance balance_make(const System& system);

// Before and after a step of h (s), with its constraints and the rotations of the pins.
void balance_begin(const System& system, Balance& balance, const State& state, double extrapolation);
void balance_end(const System& system, const Balance& balance, State& state, double h_old, double h);

// After a stage of a composition, whose drift leaves the share `decay` of v. The loss by -m c v is that of
// kinetic energy, sum m v^2 (1 - decay^2)/2.
void balance_drifted(const System& system, const Balance& balance, State& state, double decay);

// J from the start to t_n, with the half step that the sums of the state lack. v: synchronous velocities.
struct Velocities {
  const Array &x, &y, &z;  // [nodes] m/s
};
struct BalanceNow {
  double dissipated, input;
};
BalanceNow balance_now(const System& system, Balance& balance, const State& state, double extrapolation,
                       const Velocities& v);

}  // namespace drape::dynamics
