// The energy balance, kick by kick: the work of turning clamps and closing seams; and, with System::energy,
// the energy that forces which depend on velocity dissipate, and the work of wind. core/README.md, section 4.
#pragma once
#include "model/field.h"
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

// Synchronous velocities.
struct Velocities {
  const Array &x, &y, &z;  // [nodes] m/s
};

// Before a step that turns clamps, and their work in it, J.
void clamps_begin(const System& system, Balance& balance, const State& state);
double clamps_work(const System& system, const Balance& balance, const State& state);

// Before a step, the work of closing seams in its kick over `span` (s), and their power at t_n, W.
void pull_begin(const System& system, Balance& balance, const State& state, double extrapolation);
double pull_work(const System& system, const Balance& balance, const State& state, double span);
double pull_power(const System& system, Balance& balance, const State& state, const model::Field& v);

// Before and after a step of h (s), with its constraints and the rotations of the pins.
void balance_begin(const System& system, Balance& balance, const State& state, double extrapolation);
void balance_end(const System& system, const Balance& balance, State& state, double h_old, double h);

// After a stage of a composition, whose drift leaves the share `decay` of v. The loss by -m c v is that of
// kinetic energy, sum m v^2 (1 - decay^2)/2.
void balance_drifted(const System& system, State& state, double decay);

// J from the start to t_n, with the half step that the sums of the state lack. v: synchronous velocities.
struct BalanceNow {
  double dissipated, input;
};
BalanceNow balance_now(const System& system, Balance& balance, const State& state, double extrapolation,
                       const Velocities& v);

}  // namespace drape::dynamics
