// What acts in a seam that is sewn. core/README.md, section 6.
//
//          p_a        x        p_b       across it the cloth bends on: a hinge over points one cell inside
//          each
//      - - -o---------o---------o- - -   piece and the middle x of the pair, half of either arm in series
//               a     :    c
//                     o x'               along it a link to the next pair, where one side is gathered or a
//                                        tape is sewn in
//
//   kappa = 2 width/(b_a/B_a + b_b/B_b),   B_k = B_warp cos^4 + B_weft sin^4 of the angle of arm and warp
//
//   T = w p(l/R - 1) + tape (l/R - 1)       of a link
#pragma once
#include "drape/drape.h"
#include "forces/irregular_elements.h"
#include "model/system.h"

namespace drape::forces {

// N m: of a hinge, to be kept with it; 0 where a side does not bend.
double seam_hinge_stiffness(const System& system, const model::Seam& seam, const model::SeamHinge& hinge);

// Tension of a link, N, and its slope per strain at zero.
double seam_link_tension(const System& system, const model::Seam& seam, double strain);
double seam_link_slope(const System& system, const model::Seam& seam);

// Adds the forces of all welded pairs to the slots.
void seams_bending_forces(const System& system, const State& state, HingeKernel hinges, model::SlotForces to);

struct SeamEnergy {
  double bending = 0, stretch = 0;  // J
};
SeamEnergy seams_energy(const System& system, const State& state);

}  // namespace drape::forces
