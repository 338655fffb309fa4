// The pieces of a scene, drawn flat.
#pragma once
#include <string>

#include "scene/scene.h"

namespace drape::figures {

// An SVG element: the pieces with their grids, what the outline makes of the cells, pins, probes, the
// direction of the warp, a scale and a legend. The scene must be one that can be opened.
std::string picture_svg(const Scene& scene);

}  // namespace drape::figures
