// Distributes the rows of all pieces over CPU threads.
#pragma once
#include "dynamics/kernel/kernel.h"

namespace drape::dynamics {

// Before a pass: copies the rows that blocks read of their neighbours.
void blocks_copy(const System& system, const State& state, Workspace& workspace);

}  // namespace drape::dynamics
