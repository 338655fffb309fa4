// The force that closes an open seam [P section 5].
//
//      a o- - ->   <- - -o b      d = r_b - r_a,  n = d/|d|,  1/mu = A M^-1 A^T of the gap's row A
//
//   F = mu [w^2 (min(|d|, 2 speed/w) + s |d|/sqrt(|d|^2 + g^2)) + 2 w d'.n]     F n on a, -F n on b
//
// The force acts along the gap: no net force, no net torque. Two free particles approach with critical
// damping, |d| = d0 (1 + w t) e^{-w t}. Beyond a gap of 2 speed/w the spring force is constant, and the
// particles approach at `speed`. Where the cloth holds particles back, the force grows with time by its
// integral term s, m, which starts at 0:
//
//   s' = w min(|d|, 2 speed/w)     from 20/w after the closing began, while -d'.n < min(w |d|, 2 speed)/10,
//                    up to 2000 times 2 speed/w
//
// g is the tolerance within which a pair is welded. So s adds no more than w^2 s/g to omega^2.
#pragma once
#include "forces/irregular_elements.h"
#include "model/system.h"

namespace drape::forces {

double seam_mass(const System& system, const model::SeamPair& pair);  // mu, kg

// The closing force on side b of a pair, N, at the velocity v + extrapolation (v - w); 0 unless the pair is
// kPulled.
Vec3 seam_closing_force(const System& system, const model::Seam& seam, std::size_t pair, const State& state,
                        double extrapolation);

// Adds the closing forces of all pairs to the slots.
void seams_closing_forces(const System& system, const State& state, double extrapolation,
                          model::SlotForces to);

// Upper bound of s/g over all pairs.
double seams_integral_bound(const System& system, const State& state);

// Advances s after a step of h, s, with the gap at the middle of the step.
void seams_update_integral(const System& system, State& state, double h);

// True where a pair is kPulled.
bool seams_any_pulled(const State& state);

// Sets rates [pairs x 3], m/s: the rates at v_{n-1/2} of the gaps of pairs that are kPulled; 0 of others.
void seams_gap_rates(const System& system, const State& state, Array& rates);

}  // namespace drape::forces
