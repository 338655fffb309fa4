// Fit: only the rest counts. core/README.md, section 4.
//
// Dynamic relaxation with the leapfrog's own step. A particle's inertia m' = m/lightness is enlarged where
// the cloth is too stiff for the step h of the interval: with omega_z^2 the bound of cell z (Irons) and S the
// safety factor,
//
//     m' = sum over its cells of (m_z/4) max(1, (h omega_z/(2 S))^2)
//
// so that h is S of the limit at most everywhere. Weight and forces stay; so do equilibria, but for how deep
// particles lie in the layer of a body, whose penalty goes with the inertia. An inertia grows
// at once and shrinks slowly: one that followed the strain of a vibration would pump it up. The damping is
// critical for the mode in motion, by Rayleigh's quotient of the way u of the last 64 steps, of fewer at
// first (adaptive dynamic relaxation, Underwood 1983):
//
//     c = 2 omega,     omega^2 = u.K u/(u.M' u),     K u = f(r) - f(r + u)
//
// Fast modes first: while they move, c is large; what is left in the end is the slowest mode, and all others
// die as it does. What chatters on a body goes nowhere, and does not count.
#pragma once
#include "dynamics/advance.h"

namespace drape::dynamics {

// Looks at inertia, for as many steps of h (s) as State is then told to wait; at damping; and whether bodies
// rub.
void relaxation_update(const System& system, Motion& motion, State& state, double h);

// The first of it alone.
void relaxation_scale_masses(const System& system, const constraint::Constraints& constraints, State& state,
                             double h);

// What is left of the forces, and whether that is rest; from then on an advance only moves the clock, until
// fit_wake.
void check_convergence(const System& system, Motion& motion, State& state);
void relaxation_resume(State& state);

// After a change of the system, across which no way is measured; the damping stays until there is a new one.
void relaxation_forget(State& state);

}  // namespace drape::dynamics
