// Constraints at work: after each step, and on accelerations and velocities for output.
//
// At the beginning of an advance the step's kick, from t_n - h_o/2 to t_n + h/2, belongs to two advances. The
// one before has been told the impulse that turns its last half kick into the prescribed velocity, m
// [v_{n-1/2} + h_o a/2 - (1 + c h_o/2) v_n]; the new one gets the rest, so that impulses and the momenta of
// synchronous velocities balance exactly.
#pragma once
#include "model/field.h"
#include "model/system.h"

namespace drape::dynamics {

// Where held points are and are to be; "held" counts the fixed nodes, then the rows.
struct HeldMotion {
  Array now, next;  // [held x 3] m, targets at t_n and t_{n+1}
  Array rate;       // [held x 3] prescribed velocities (or accelerations)
  Array arm;        // [parts x 3] m, R (start - share p_0) at t_n
  Array old;        // [entries x 3] m/s, v_{n-1/2} of fixed nodes and of the rows' and links' nodes in order
  Array y, z;       // [rows x 3]
  Array out;        // [held x 3] what the last projection took out, times m
  Array taken;      // [held x 3] the sum of these since it was 0
  constraint::RigidNow rigid;  // links
  bool moves = false;          // a target does
  double work = 0;             // J, of the pins on the cloth in the half step that the state's sums lack
};
HeldMotion held_make(const constraint::Constraints& constraints);

// Targets and arms at the frames of a state.
void held_refresh(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

enum class Rate { kVelocity, kAcceleration };
void held_rates(const constraint::Constraints& constraints, const State& state, Rate which, HeldMotion& held);

// Keeps v_{n-1/2} of the held nodes.
void held_store_velocities(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

// How a step turned v_{n-1/2} into the free velocity: v <- keep v + kick a.
struct HeldStep {
  double h, keep, kick;  // h of r <- r + h v
  double impulse;        // over mass and what is taken out of v: 1 + c h/2
  bool begins;           // the first step of an advance: needs held_keep, and held_rates of velocities
  double half, centred;  // h_o/2 and 1 + c h_o/2; above order 2, what the kick has of the step before, and 1
  double before;         // above order 2, what damping has left of v before the kick; else 1
  bool again = false;    // the free step has been met; this meets what was added to it since
  const char* hit =
      nullptr;  // [nodes / kRowUnit] then: something has been added to one of the nodes; null: to any
};

// Puts held nodes where the frames of the state (at t_{n+1}) want them after the free step, and adds to the
// impulses of the pins. With system.energy (and held_keep), adds their work on the cloth to state.input.
void constraints_project_step(const System& system, const constraint::Constraints& constraints,
                              const HeldStep& step, HeldMotion& held, State& state);

// Ends a step: what is held at t_{n+1} is so now.
void constraints_end_step(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

using model::Field;

// Projects a field of accelerations or velocities onto held.rate; `load` [pins], where it is not null,
// receives m times what was taken out: for accelerations, the pins' forces on the outside world.
void constraints_project(const System& system, const constraint::Constraints& constraints, HeldMotion& held,
                         Field field, std::vector<math::Wrench>* load);

// Puts held points where they are to be at t_n, by the least change in the norm of the masses.
void constraints_place(const System& system, const constraint::Constraints& constraints, HeldMotion& held,
                       Field positions);

// The work of the pins on the cloth while a projection of `centred` m v turned `before` v_{n-1/2} into v_n.
double held_work(const constraint::Constraints& constraints, const State& state, double before,
                 double centred, const HeldMotion& held);

}  // namespace drape::dynamics
