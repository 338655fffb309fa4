// Welds: pairs of a seam that have come together stay so, r_a = r_b, as constraints beside those of the pins.
// core/README.md, section 6.
#pragma once
#include "dynamics/advance.h"

namespace drape::dynamics {

// Begins to pull the pairs of seams whose time has come; true if there are any new ones.
bool seams_pull_begin(const System& system, State& state);

// True while a pair is being pulled, or waits for its time.
bool seams_to_close(const System& system, const State& state);

// The pulled pairs whose gap is at most their seam's tolerance.
std::vector<std::size_t> seams_within_tolerance(const System& system, const State& state);

// Welds pairs at the synchronous velocity: positions and velocities move to the weld, and to it only, by the
// least change in the norm of the masses, which keeps the momentum. Pins are told the impulse.
void seams_weld(const System& system, Motion& motion, State& state, const std::vector<std::size_t>& pairs);

// Constraints at work as the state has them; at once where they are so already.
void seams_restore(const System& system, Motion& motion, const State& state);

}  // namespace drape::dynamics
