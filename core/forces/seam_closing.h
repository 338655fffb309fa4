// What pulls an open seam together [P section 5].
//
//      a o- - ->   <- - -o b      d = r_b - r_a,  n = d/|d|,  1/mu = A M^-1 A^T of the gap's row A
//
//   F = mu [w^2 (min(|d|, 2 speed/w) + s |d|/sqrt(|d|^2 + g^2)) + 2 w d'.n]     on a along n, on b its
//   opposite
//
// Along the gap only: no net force, no torque. Two free particles close as |d| = d0 (1 + w t) e^{-w t}, the
// critical damping; from farther off than 2 speed/w the force stays what it is there, and they come at
// `speed`. Particles that the cloth holds back are pulled the harder the longer it does: s grows from 0 by
//
//   s' = w min(|d|, 2 speed/w)     once the pull is 20/w old, while -d'.n < min(w |d|, 2 speed)/10,
//                    up to 2000 times 2 speed/w
//
// g is the tolerance within which a pair is welded: s adds no more than w^2 s/g to omega^2.
#pragma once
#include "forces/irregular_elements.h"
#include "model/system.h"

namespace drape::forces {

double seam_mass(const System& system, const model::SeamPair& pair);  // mu, kg

// The pull on side b of a pair, N, at the velocity led on by `lead`; 0 where it is not pulled.
Vec3 seam_closing_force(const System& system, const model::Seam& seam, std::size_t pair, const State& state,
                        double extrapolation);

// Adds it for all pairs to the slots.
void seams_closing_forces(const System& system, const State& state, double extrapolation,
                          model::SlotForces to);

// s/g, at most.
double seams_integral_bound(const System& system, const State& state);

// After a step of h: s, by the middle of the step.
void seams_update_integral(const System& system, State& state, double h);

// The rates of the gaps (m/s, [pairs x 3]) of pulled pairs at v_{n-1/2}.
void seams_gap_rates(const System& system, const State& state, Array& rates);

}  // namespace drape::forces
