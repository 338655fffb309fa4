// The straightest path on a surface: it crosses every edge at the same angle on both sides.
#pragma once
#include "body/surface.h"

namespace drape::body {

struct SurfaceWalk {
  double drop = 0;  // m, the deepest place of the path below where it began
  double straight =
      0;  // m, of the path, to the last edge where it is within `bend` of the line it began along
};

// Walks `distance` (m) from the point `from` of a triangle along the unit vector `along` in its plane; `up`
// is the unit vector against which it drops. Where the surface ends, or more than two triangles share an
// edge, the path goes on straight ahead.
struct WalkStart {
  int triangle;
  Vec3 from, along, up;
};
SurfaceWalk surface_walk(const BodySurface& surface, const WalkStart& start, double distance, double bend);

}  // namespace drape::body
