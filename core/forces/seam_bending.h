// Forces in a seam that is sewn. core/README.md, section 6.
//
//          p_a        x        p_b       Across the seam the cloth keeps its bending rigidity. A hinge
//      - - -o---------o---------o- - -   joins points one cell inside each piece and the middle x of the
//               a     :    c             pair, with half of either arm in series. Along the seam, a link
//                     o x'               leads to the next pair, where a side is gathered or taped.
//
//   kappa = 2 width/(b_a/B_a + b_b/B_b),   B_k = B_warp cos^4 + B_weft sin^4, angle between arm and warp
//
//   T = w p(l/R - 1) + tape (l/R - 1)       tension of a link
#pragma once
#include "drape/drape.h"
#include "forces/irregular_elements.h"
#include "model/system.h"

namespace drape::forces {

// The stiffness kappa of a hinge, N m, which SeamHinge stores; 0 where a side has no bending rigidity.
double seam_hinge_stiffness(const System& system, const model::Seam& seam, const model::SeamHinge& hinge);

// The tension of a link, N, and its slope at strain zero, N per strain.
double seam_link_tension(const System& system, const model::Seam& seam, double strain);
double seam_link_slope(const System& system, const model::Seam& seam);

// Adds the forces of all welded pairs to the slots.
void seams_bending_forces(const System& system, const State& state, HingeKernel hinges, model::SlotForces to);

struct SeamEnergy {
  double bending = 0, stretch = 0;  // J
};
SeamEnergy seams_energy(const System& system, const State& state);

}  // namespace drape::forces
