// The nodes that a region of a piece holds, and the links by which threads leave them.
#pragma once
#include "piece/support/support.h"

namespace drape::piece {

struct RegionHold {
  std::vector<int> nodes;  // rising
  std::vector<HeldSlope> slopes;
};
RegionHold region_hold(const Grid& grid, const std::vector<Vec2>& region, bool clamp);

}  // namespace drape::piece
