// outline = "paper": the particles of seams lie on the outlines, beside the grids, and are tied to the edge
// of theirs [P section 5]. core/README.md, section 6.
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
  int node[2];    // on the outline, on the edge
  int pair;       // the first, of all seams in order, whose particle it ties
  double length;  // m
};

// The grids of all pieces. With outline = "paper" the particles of seams are their last twins, `ties`
// [pieces] what ties them; nothing else uses those.
std::vector<piece::Grid> grids_make(const Scene& scene, std::vector<std::vector<GridTie>>* ties = nullptr);

// The particle of a seam at a point of the outline.
int seam_particle(const piece::Grid& grid, Vec2 point);

// Of the area of an edge particle, what stays with it where particles of seams are tied to it.
inline constexpr double kEdgeKeeps = 0.75;

}  // namespace drape::seam
