// How large a step may be: core/README.md, section 4.
#pragma once
#include <string>

#include "dynamics/kernel/kernel.h"

namespace drape::dynamics {

// The largest omega^2 (1/s^2) of a lattice, at the present positions or where the present velocities lead in
// `ahead` s; without the forces that depend on velocity.
double step_limit_lattice(const System& system, const Kernel& kernel, const model::Lattice& lattice,
                          const State& state, double ahead = 0);

// omega^2 (1/s^2) of one cell with the given corners a, b, c, d, and what the clamps of a lattice add to it.
double step_limit_cell(const model::Lattice& lattice, const State& state, const std::size_t* corner,
                       double ahead);
double step_limit_clamps(const System& system, const model::Lattice& lattice, const State& state,
                         double ahead);

// What omega^2 of a lattice counts as where forces depend on velocity: without them, it would lead to the
// same limit. `drag`: that of the air, N s/m per m^2.
double step_limit_drag(const System& system, const State& state);
// What seams add to omega^2 and d: the pull while there is one, hinges and links of what is sewn.
struct SeamsBound {
  double omega2 = 0, d = 0;  // 1/s^2, 1/s
};
SeamsBound step_limit_seams(const System& system, const State& state);

// `contact`: what bodies add to omega^2.
double step_limit_rated(const System& system, const model::Lattice& lattice, double omega2, double drag,
                        const SeamsBound& seams, double contact);

// The largest of all lattices, raised to what leads to the same limit where forces depend on velocity.
double step_limit_omega2(const System& system, const Kernel& kernel, const State& state, double ahead = 0);

// h omega up to which an undamped oscillator is bounded: 2 in leapfrog.
double step_limit_angle(const System& system);

// The limit that follows from it (s); infinite where nothing oscillates.
double step_limit_of(const System& system, double omega2);

// The automatic step over the step limit, at most, with damping c (1/s): nonlinear cloth gains energy from
// steps below the limit, little enough to be taken up by light damping. core/README.md, section 4, "Step".
inline constexpr double kSafetyUndamped = 0.4, kSafetyDamped = 0.7;
double step_safety(const System& system, double damping, double omega2);

// What sets it, in words: "warp link of piece 'sheet', column 3, row 12, strain 0.0131".
std::string step_limit_link(const System& system, const Scene& scene, const State& state, double ahead = 0);

}  // namespace drape::dynamics
