// A piece in space: flat or on a cylinder, round or elliptic, with its imperfection. core/README.md,
// section 1.
#pragma once
#include "scene/scene.h"

namespace drape::piece {

// A point of the piece's plane in space, without imperfection.
Vec3 place_point(const scene::PlaceSpec& place, Vec2 point);

// The imperfection of a piece: h = sum_k height sin(x[k] x + y[k] y + shift[k]).
struct Waves {
  double height = 0;  // m; 0: flat
  double x[8], y[8], shift[8];
};
Waves waves_make(const Scene& scene, int piece);

// Where a point of a piece starts.
Vec3 place_start(const scene::PlaceSpec& place, const Waves& waves, Vec2 point);
Vec3 place_start(const Scene& scene, int piece, Vec2 point);

}  // namespace drape::piece
