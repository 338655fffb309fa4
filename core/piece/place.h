// The initial position of a piece in space: flat or on a circular or elliptic cylinder, with an imperfection.
// core/README.md, section 1.
#pragma once
#include "scene/scene.h"

namespace drape::piece {

// The position (m) in space of a point in the plane of the piece, without imperfection.
Vec3 place_point(const scene::PlaceSpec& place, Vec2 point);

// The imperfection of a piece, normal to its surface: h = sum_k height sin(x[k] x + y[k] y + shift[k]).
struct Waves {
  double height = 0;            // m; 0: no imperfection
  double x[8], y[8], shift[8];  // wave numbers, 1/m; phases, rad
};
Waves waves_make(const Scene& scene, int piece);

// The initial position (m) of a point of a piece, with imperfection.
Vec3 place_start(const scene::PlaceSpec& place, const Waves& waves, Vec2 point);
Vec3 place_start(const Scene& scene, int piece, Vec2 point);

}  // namespace drape::piece
