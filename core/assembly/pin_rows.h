// The pins of a scene as linear constraints on nodes. core/README.md, section 4, "Pins".
#pragma once
#include "model/system.h"

namespace drape::assembly {

// The pins at the start: name, centre, clamp and drive.
std::vector<constraint::PinBase> pins_make(const Scene& scene, const std::vector<piece::Grid>& grids);

// One row for each point that a pin holds. Its target is the start: sum_k w_k r_k over the nodes' first
// positions.
std::vector<constraint::ConstraintRow> pin_rows(const Scene& scene, const std::vector<piece::Grid>& grids,
                                                const System& system, const State& start);

}  // namespace drape::assembly
