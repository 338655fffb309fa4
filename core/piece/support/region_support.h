// The nodes that a region of a piece supports, and the links by which yarns leave them.
#pragma once
#include "piece/support/support.h"

namespace drape::piece {

struct RegionSupport {
  std::vector<int> nodes;  // increasing
  std::vector<HeldSlope> slopes;
};
RegionSupport region_support(const Grid& grid, const std::vector<Vec2>& polygon, bool clamp);

}  // namespace drape::piece
