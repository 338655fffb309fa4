// The automatic step of a run: by the step limit, the motion of the cloth, what is near it, and the energy
// guard. core/README.md, section 4, "Step".
#pragma once
#include "dynamics/advance.h"
#include "dynamics/step_size/step_limit.h"

namespace drape::dynamics {

// Steps of at most `longest` (s) that fill `length` (s).
std::int64_t steps_for(double length, double longest);

// Steps in an interval of q that a state with this omega^2 (1/s^2) needs; may be infinite.
double leapfrog_steps(const System& system, double omega2);

// The largest step (s) at present; and the largest one at every check since largest_begin.
double step_now(const System& system, const State& state);
double step_needed(const System& system, const State& state);

// Whether a node that moves fast near a body sets the automatic step; otherwise a link does.
bool step_set_by_contact(const System& system, const State& state);

// Begins to remember the largest omega^2 and motion of all checks, from the present ones.
void largest_begin(State& state);

// Updates how the motion bounds the step, by the last step (h > 0) or by the next (h < 0) at the present
// velocities. `weight`: of the new values in the running means.
void motion_update(const System& system, const Motion& motion, double h, double weight, State& state);

// Checks the step limit along the present velocities up to the next check.
void check_step_limit(const System& system, const Motion& motion, State& state, double h);

}  // namespace drape::dynamics
