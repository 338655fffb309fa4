// The pieces of a scene, drawn flat.
#pragma once
#include <string>

#include "scene/scene.h"

namespace drape {

// An SVG element: outlines, grids, pins (squares) and probes (circles), piece beside piece, warp upwards.
std::string picture_svg(const Scene& scene);

}  // namespace drape
