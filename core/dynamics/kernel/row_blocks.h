// Rows of all pieces shared out to threads.
#pragma once
#include "dynamics/kernel/kernel.h"

namespace drape::dynamics {

// Copies the rows that blocks read of their neighbours.
void blocks_copy(const System& system, const State& state, Workspace& workspace);

}  // namespace drape::dynamics
