// What the pins of a scene hold, as constraints on nodes. core/README.md, section 4, "Pins".
#pragma once
#include "model/system.h"

namespace drape {

// The pins as they are before they move.
std::vector<PinBase> pins_make(const Scene& scene, const std::vector<Grid>& grids);

// Points are held where they start: target = sum_k w_k r_k of the nodes' first places.
std::vector<ConstraintRow> pin_rows(const Scene& scene, const std::vector<Grid>& grids, const System& system,
                                    const State& start);

}  // namespace drape
