// Parts of scene_check, and what their messages share.
#pragma once
#include <string>
#include <vector>

#include "scene/diagnostics.h"
#include "scene/scene.h"

namespace drape::validation {

using Problems = std::vector<Problem>;

// Diagrams, and what they are worked up from.
void fabric_check(const Scene& scene, const scene::FabricSpec& fabric, Problems& problems);

// Seams against their pieces and each other; `sound` as below.
void seams_check(const Scene& scene, const std::vector<bool>& valid, Problems& problems);

// What is allowed of a force that depends on velocity, above order 2.
std::string order_allows(int order);

// Pins and probes against their pieces and each other; `sound[p]`: piece p has an outline without fault.
void pins_check(const Scene& scene, const std::vector<bool>& valid, Problems& problems);

}  // namespace drape::validation
