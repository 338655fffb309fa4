// A piece in space: flat or on a cylinder, with its imperfection. core/README.md, section 1.
#pragma once
#include "scene/scene.h"

namespace drape {

// A point of the piece's plane in space, without imperfection.
Vec3 place_point(const PlaceSpec& place, Vec2 point);

// Where a point of a piece starts.
Vec3 place_start(const Scene& scene, int piece, Vec2 point);

}  // namespace drape
