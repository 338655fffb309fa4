// The surface of a piece as polygons that follow its outline. A whole cell is one polygon between its nodes.
// A cut cell gives the polygons of its parts, whose points are bilinear in the nodes of their cell. Where a
// merged part borders on other cells it uses their points, so the surface has no cracks.
#pragma once
#include "piece/grid/grid.h"

namespace drape::piece {

struct Surface {
  std::vector<GridPoint> points;  // corners that are not nodes, each once
  std::vector<int> corner;        // node, or Grid::nodes() + index of a point; counter-clockwise
  std::vector<int> end;           // [polygons] end of each polygon in `corner`
};
Surface surface_make(const Grid& grid);

}  // namespace drape::piece
