// Ties the particles of seams to the cloth.
#pragma once
#include "model/system.h"

namespace drape::assembly {

// Lays the pairs of all seams: before the slots of Side are numbered.
void seams_lay(const Scene& scene, const std::vector<piece::Grid>& grids, System& system);

// The rates and bounds of the pull, after the masses or laws have changed.
void seams_retune(System& system);

}  // namespace drape::assembly
