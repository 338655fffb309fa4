// The parts of scene_check, and texts shared by messages.
#pragma once
#include <string>
#include <vector>

#include "scene/diagnostics.h"
#include "scene/scene.h"

namespace drape::validation {

using Problems = std::vector<Problem>;

// Checks the diagrams of a fabric and the data from which they are computed.
void fabric_check(const Scene& scene, const scene::FabricSpec& fabric, Problems& problems);

// Checks seams against their pieces and each other. `valid` [pieces]: the piece has an outline without fault.
void seams_check(const Scene& scene, const std::vector<bool>& valid, Problems& problems);

// The text on what is allowed of a force that depends on velocity, in schemes of order above 2.
std::string order_allows(int order);

// Checks pins and probes against their pieces and each other. `valid` [pieces]: the piece has an outline
// without fault.
void pins_check(const Scene& scene, const std::vector<bool>& valid, Problems& problems);

}  // namespace drape::validation
