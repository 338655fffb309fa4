// Projection onto the constraints: of each step, and of accelerations and velocities for output.
//
// At the beginning of an advance the kick of the step, from t_n - h_o/2 to t_n + h/2, belongs to two
// advances. The one before has reported the impulse that turns its last half kick into the prescribed
// velocity,
//
//     m [v_{n-1/2} + h_o a/2 - (1 + c h_o/2) v_n];
//
// the new one gets the rest. So impulses and the momenta of synchronous velocities balance exactly.
#pragma once
#include "dynamics/held_motion.h"
#include "model/field.h"
#include "model/scheme.h"

namespace drape::dynamics {

// Puts held nodes where the motions of the pins (at t_{n+1}) place them after the free step, and adds to the
// impulses of the pins. With system.energy (and held_store_velocities), adds their work on the cloth to
// state.input. The first step of an advance needs held_store_velocities, and held_rates of velocities.
void constraints_project_step(const System& system, const constraint::Constraints& constraints,
                              const model::Scheme& scheme, HeldMotion& held, State& state);

// The same of what contact has added since. `touched` [nodes / kRowUnit]: where it has; null: anywhere.
void constraints_project_again(const System& system, const constraint::Constraints& constraints,
                               const model::Scheme& scheme, const char* touched, HeldMotion& held,
                               State& state);

// Ends a step: the targets of t_{n+1} become those of t_n.
void constraints_end_step(const constraint::Constraints& constraints, const State& state, HeldMotion& held);

// Projects a field of accelerations or velocities onto held.rate; `load` [pins], where it is not null,
// receives m times what was taken out: for accelerations, the forces of the pins on the outside world.
void constraints_project(const System& system, const constraint::Constraints& constraints, HeldMotion& held,
                         model::Field field, std::vector<math::Wrench>* load);

// Moves held points at positions r to their targets at t_n by the smallest change in the norm of the masses.
void constraints_place(const System& system, const constraint::Constraints& constraints, HeldMotion& held,
                       model::Field r);

}  // namespace drape::dynamics
