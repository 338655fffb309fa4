// What the pins of a scene hold, as constraints on nodes. core/README.md, section 4, "Pins".
#pragma once
#include "model/system.h"

namespace drape::assembly {

// The pins as they are before they move.
std::vector<constraint::PinBase> pins_make(const Scene& scene, const std::vector<piece::Grid>& grids);

// Points are held where they start: target = sum_k w_k r_k of the nodes' first places.
std::vector<constraint::ConstraintRow> pin_rows(const Scene& scene, const std::vector<piece::Grid>& grids,
                                                const System& system, const State& start);

}  // namespace drape::assembly
