// Fit: only the rest counts. core/README.md, section 4.
//
// Dynamic relaxation with the leapfrog's own step. A particle's inertia m' = m/lightness is enlarged where the cloth is too stiff for
// the step h of the interval: with omega_z^2 the bound of cell z (Irons) and S the safety factor,
//
//     m' = sum over its cells of (m_z/4) max(1, (h omega_z/(2 S))^2)
//
// so that h is S of the limit at most everywhere. Weight and forces stay; so do equilibria. Whenever the kinetic energy falls after a
// rise, all velocity is taken away (kinetic damping).
#pragma once
#include "motion/leapfrog.h"

namespace drape {

// Scales the inertia for steps of h (s), for as many steps as it then tells State to wait.
void fit_scale(const System& system, State& state, double h);

// After a step: kinetic damping.
void fit_damp(const System& system, State& state);

// What is left of the forces, and whether that is rest; from then on an advance only moves the clock, until fit_wake.
void fit_judge(const System& system, Motion& motion, State& state);
void fit_wake(State& state);

}  // namespace drape
