// What a pin supports: points of the piece and, as a clamp, the slope of the yarns that leave it.
// core/README.md, section 4.
#pragma once
#include "piece/grid/grid.h"

namespace drape::piece {

// A yarn that leaves a clamp by the link from node `from` (supported, or behind the edge) to node `to`.
struct HeldSlope {
  int from, to;
  bool warp;      // along the warp, else along the weft
  double clamp;   // y: kappa_c = y 2 B w/b
  double series;  // q_c of the link in the hinge at `to`
  bool pivot;     // there is no other hinge at `from` along this yarn
};

struct Support {
  std::vector<Vec2> points;       // m, in the plane of the outline, each once; includes the nodes of a region
  std::vector<GridPoint> at;      // [points] in terms of nodes
  std::vector<HeldSlope> slopes;  // of clamps only
  Vec2 centre{0, 0};              // m, initial position of the pin, in the plane of the outline
};
Support support_make(const Grid& grid, const Scene& scene, const scene::PinSpec& pin);

}  // namespace drape::piece
