// From the bodies of a scene to surfaces that can be asked.
#pragma once
#include "model/contact.h"
#include "scene/scene.h"

namespace drape::assembly {

// Reads the meshes.
std::vector<model::Body> bodies_make(const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape::assembly
