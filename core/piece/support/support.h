// What a pin holds: points of the piece and, as a clamp, the slope of the threads that leave it.
// core/README.md, section 4.
#pragma once
#include "piece/grid/grid.h"

namespace drape::piece {

// A thread that leaves a clamp by the link from node `from` (held or behind the edge) to node `to`.
struct HeldSlope {
  int from, to;
  bool warp;      // along the warp, else along the weft
  double clamp;   // y: kappa_c = y 2 B w/b
  double series;  // q_c of the link in the hinge at `to`
  bool pivot;     // there is no other hinge at `from` along this thread
};

struct Support {
  std::vector<Vec2> points;       // in the plane of the outline, each once; nodes of a region too
  std::vector<GridPoint> at;      // [points] where they sit
  std::vector<HeldSlope> slopes;  // only of clamps
  Vec2 centre{0, 0};              // where the pin's frame starts, in the plane of the outline
};
Support support_make(const Grid& grid, const Scene& scene, const scene::PinSpec& pin);

}  // namespace drape::piece
