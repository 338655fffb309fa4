// outline = "paper": the particles of seams are on the outlines, outside the grids. Rigid links tie them to
// the edge of their grid [P section 5]. core/README.md, section 6.
//
//        o-----o-----o       particles of the grid; the lower row is its edge
//        |     |     |
//        o-----o-----o
//         \  / | \  /        rigid links from each particle of a seam to those of the edge within 1.5 b
//      ----x---+--x-----     the outline
#pragma once
#include "piece/grid/grid.h"

namespace drape::seam {

// A rigid link between two nodes of a grid.
struct GridTie {
  int node[2];    // on the outline; on the edge of the grid
  int pair;       // the first pair, counted over all seams, whose particle it ties
  double length;  // m
};

// The grids of all pieces. With outline = "paper" the particles of seams are their last twins, and `ties`
// [pieces] receives their rigid links. Otherwise `ties` stays empty for each piece.
std::vector<piece::Grid> grids_make(const Scene& scene, std::vector<std::vector<GridTie>>* ties = nullptr);

// The node of the seam particle at a point of the outline (m); -1: none.
int seam_particle(const piece::Grid& grid, Vec2 point);

// The fraction of its area that an edge particle keeps where particles of seams are tied to it.
inline constexpr double kEdgeKeeps = 0.75;

}  // namespace drape::seam
