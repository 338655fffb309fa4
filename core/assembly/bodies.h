// The bodies of a scene as surfaces with queries.
#pragma once
#include "model/contact.h"
#include "scene/scene.h"

namespace drape::assembly {

// Reads the meshes. Each invalid mesh is one problem. A missing contact library is one problem, and ends the
// reading.
std::vector<model::Body> bodies_make(const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape::assembly
