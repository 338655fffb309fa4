#include "piece/place.h"

namespace drape {

Vec3 place_point(const PlaceSpec& place, Vec2 q) {
  Vec3 r;
  for (std::size_t k = 0; k < 3; ++k)
    r[k] = place.origin[k] + q[0] * place.axis_x[k] + q[1] * place.axis_y[k];
  return r;
}

Vec3 place_start(const Scene& scene, int piece, Vec2 point) {
  return place_point(scene.pieces[std::size_t(piece)].place, point);
}

}  // namespace drape
