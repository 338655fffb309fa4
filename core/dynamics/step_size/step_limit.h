// The step limit: how large a step may be. core/README.md, section 4.
#pragma once
#include <string>

#include "dynamics/kernel/kernel.h"

namespace drape::dynamics {

// The largest omega^2 (1/s^2) of a lattice, at the present positions or those extrapolated by `ahead` s with
// the present velocities; without the forces that depend on velocity.
double step_limit_lattice(const System& system, const Kernel& kernel, const model::Lattice& lattice,
                          const State& state, double ahead = 0);

// omega^2 (1/s^2) of one cell with the given corners a, b, c, d [4]; and what the clamps of a lattice add.
double step_limit_cell(const model::Lattice& lattice, const State& state, const std::size_t* corner,
                       double ahead);
double step_limit_clamps(const System& system, const model::Lattice& lattice, const State& state,
                         double ahead);

// Drag of the air, N s/m per m^2; 0 without air.
double step_limit_drag(const System& system, const State& state);

// What seams add to omega^2 and d: the closing force while a seam closes, hinges and links of what is sewn.
struct SeamsBound {
  double omega2 = 0, d = 0;  // 1/s^2, 1/s
};
SeamsBound step_limit_seams(const System& system, const State& state);

// The equivalent omega^2 (1/s^2) of a lattice: without forces that depend on velocity, it would give the
// limit that omega2 gives with them. `contact`: what contact adds to omega^2, 1/s^2.
double step_limit_rated(const System& system, const model::Lattice& lattice, double omega2, double drag,
                        const SeamsBound& seams, double contact);

// The largest equivalent omega^2 (1/s^2) of all lattices.
double step_limit_omega2(const System& system, const Kernel& kernel, const State& state, double ahead = 0);

// h omega up to which an undamped oscillator is bounded: 2 in leapfrog.
double step_limit_angle(const System& system);

// The step limit (s) that follows from omega2; infinite where nothing oscillates.
double step_limit_of(const System& system, double omega2);

// The largest ratio of the automatic step to the step limit, with damping c (1/s). Nonlinear cloth gains
// energy even from steps below the limit, but so little that light damping removes it. core/README.md,
// section 4, "Step".
inline constexpr double kSafetyUndamped = 0.4, kSafetyDamped = 0.7;
double step_safety(const System& system, double damping, double omega2);

// What sets the step limit, in words: "warp link of piece 'sheet', column 3, row 12, strain 0.0131".
std::string step_limit_link(const System& system, const Scene& scene, const State& state, double ahead = 0);

}  // namespace drape::dynamics
