// The pairs, hinges and links of seams as weighted sums over nodes.
#pragma once
#include "model/system.h"

namespace drape::assembly {

// Adds the pairs, hinges and links of all seams. Must run before slots_number.
void seams_lay(const Scene& scene, const std::vector<piece::Grid>& grids, System& system);

// Updates the closing rates w and the bounds for the step limit, after the masses or laws have changed.
void seams_retune(System& system);

}  // namespace drape::assembly
