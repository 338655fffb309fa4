// Welds: closed pairs of a seam stay closed, r_a = r_b, by constraints like those of the pins.
// core/README.md, section 6.
#pragma once
#include "dynamics/advance.h"

namespace drape::dynamics {

// Begins to close the pairs of seams whose time has come. True if there are new ones.
bool seams_pull_begin(const System& system, State& state);

// True while a pair is closing, or waits for its time.
bool seams_to_close(const System& system, const State& state);

// The closing pairs whose gap is at most the tolerance of their seam.
std::vector<std::size_t> seams_within_tolerance(const System& system, const State& state);

// Welds pairs at the synchronous velocity. Positions and velocities are projected by the smallest change in
// the norm of the masses, which keeps the momentum. Pins receive the impulse.
void seams_weld(const System& system, Motion& motion, State& state, const std::vector<std::size_t>& pairs);

// Puts the constraints of a state in force; returns at once where they are already.
void seams_restore(const System& system, Motion& motion, const State& state);

}  // namespace drape::dynamics
