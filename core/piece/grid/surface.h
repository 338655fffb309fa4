// A piece as polygons that follow its outline: whole cells between their nodes, cut ones as their parts, the
// points of which are bilinear on the nodes of the cell that carries them. Where a merged part meets other
// cells its points are theirs, so that the surface has no cracks.
#pragma once
#include "piece/grid/grid.h"

namespace drape::piece {

struct Surface {
  std::vector<GridPoint> points;  // corners that are no nodes, each once
  std::vector<int> corner;        // nodes, then Grid::nodes() + point; counter-clockwise
  std::vector<int> end;           // [polygons] of each in `corner`
};
Surface surface_make(const Grid& grid);

}  // namespace drape::piece
