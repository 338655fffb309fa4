// Scene -> System and its first State.
#pragma once
#include "model/system.h"

namespace drape::assembly {

// Lays every piece on its grid and builds laws, masses, constraints and probes. The scene has passed
// scene_check.
System system_assemble(const Scene& scene, State& start, std::vector<Problem>& problems);

// Builds laws, masses and the constraints' factor anew from tuned fabrics (same order and diagrams'
// elongations). On a problem the system is left as it was.
void system_retune(System& system, const std::vector<scene::FabricSpec>& fabrics,
                   std::vector<Problem>& problems);

}  // namespace drape::assembly
