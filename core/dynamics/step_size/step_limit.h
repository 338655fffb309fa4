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

// Of all links in the last step, of `step` s; below 0, in the next one at the present velocities.
StepDefect step_defect(const System& system, const Kernel& kernel, const State& state, double step);

// h omega up to which an undamped oscillator is bounded: 2 in leapfrog.
double step_limit_angle(const System& system);

// The step limit (s) that follows from omega2; infinite where nothing oscillates.
double step_limit_of(const System& system, double omega2);

// How the motion and the curvature of the laws bound the step; 1/s^3. core/README.md, section 4, "Step".
struct MotionBound {
  double drift = 0;    // energy defect of a step over h^3 and the kinetic energy; means over some steps
  double flutter = 0;  // largest change of omega^2 of a cell in a step over h
};

// The automatic step (s): the share kSafety of the step limit. It is less where (h omega)^2 of a cell changes
// by more than 4 kFlutter in a step, but at least kSafetyNonlinear; and less where the energy defects of a
// second exceed kDrift (1/s) of the kinetic energy, but at least kSafetyLeast. Damping c takes energy out
// meanwhile: the bounds grow by 1 + 2 c kFlutterTime and 1 + 2 c kDriftTime.
inline constexpr double kSafety = 0.7, kSafetyNonlinear = 0.4, kSafetyLeast = 0.05;
inline constexpr double kFlutter = 0.01, kFlutterTime = 4, kDrift = 25, kDriftTime = 0.5;
double step_automatic(const System& system, double omega2, const MotionBound& motion);

// The flutter to be expected of a motion that is not known yet: infinite, but 0 in damped cloth, which has
// c >= kDampedShare omega.
inline constexpr double kDampedShare = 1e-5;
double flutter_unknown(const System& system, double omega2);

// What sets the step limit, in words: "warp link of piece 'sheet', column 3, row 12, strain 0.0131".
std::string step_limit_link(const System& system, const Scene& scene, const State& state, double ahead = 0);

}  // namespace drape::dynamics
