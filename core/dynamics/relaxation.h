// Fit mode: computes only the equilibrium. core/README.md, section 4.
//
// Dynamic relaxation with the step of leapfrog. Where the cloth is too stiff for the step h of the interval,
// the inertia of a particle is enlarged to m' = m/inverse_mass_scale. With omega_z^2 the bound of cell z
// (Irons) and S the safety factor,
//
//     m' = sum over its cells of (m_z/4) max(1, (h omega_z/(2 S))^2)
//
// so that h is at most S of the limit everywhere. Weight and forces stay, and so do equilibria. Only the
// depth of particles in contact changes, because their penalty goes with the inertia. An inertia grows at
// once and shrinks slowly: if it followed the strain of a vibration, it would feed the vibration. The damping
// is critical for the mode in motion. Its frequency is Rayleigh's quotient of the displacement u of the last
// 64 steps, of fewer at first (adaptive dynamic relaxation, Underwood 1983):
//
//     c = 2 omega,     omega^2 = u.K u/(u.M' u),     K u = f(r) - f(r + u)
//
// Fast modes decay first: while they move, c is large. The slowest mode remains, and all others decay with
// it. Displacement is used rather than velocity, because chattering particles have velocity without net
// motion.
#pragma once
#include "dynamics/advance.h"

namespace drape::dynamics {

// Updates the inertia, for as many steps of h (s) as state.steps_to_limit_check is then set to; the damping;
// and whether friction acts.
void relaxation_update(const System& system, Motion& motion, State& state, double h);

// The inertia alone.
void relaxation_scale_masses(const System& system, const constraint::Constraints& constraints, State& state,
                             double h);

// Computes the residual, and whether the cloth is at rest. From then on an advance only moves the clock,
// until relaxation_resume.
void check_convergence(const System& system, Motion& motion, State& state);
void relaxation_resume(State& state);

// After a change of the system no displacement is measured across it. The damping stays until the next
// measure.
void relaxation_forget(State& state);

}  // namespace drape::dynamics
