// Assembles a System and its first State from a Scene.
#pragma once
#include "model/system.h"

namespace drape::assembly {

// Lays a grid over every piece and builds laws, masses, seams, bodies, constraints and probes. The scene must
// have passed scene_check. On a problem the result is incomplete.
System system_assemble(const Scene& scene, State& start, std::vector<Problem>& problems);

// Rebuilds laws, masses and the closing of seams from tuned fabrics; the order of fabrics and the elongations
// of their diagrams must be the same. On a problem the system is unchanged. The factor of the constraints is
// the caller's: constraints_refactor.
void system_retune(System& system, const std::vector<scene::FabricSpec>& fabrics,
                   std::vector<Problem>& problems);

}  // namespace drape::assembly
