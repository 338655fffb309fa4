// The grid of a piece: cells along the yarns, cut by the outline, and the nodes at their corners.
// core/README.md, section 1.
#pragma once
#include <array>
#include <vector>

#include "scene/scene.h"

namespace drape::piece {

// A cell with its corners a (i,j), b (i+1,j), c (i,j+1), d (i+1,j+1).
struct GridCell {
  int i, j;
  int node[4];
  double share;  // phi, area of cloth over that of a whole cell
};

// A connected part of the piece within one place of the grid that is cut by the outline.
struct GridPart {
  int i, j;
  int cell;                              // the cell whose bilinear map its points use
  std::vector<std::vector<Vec2>> loops;  // outer boundary, then holes; in the plane of the outline, m
};

// Regular node (i,j) has the number j columns + i. Twins follow: further nodes at the same grid positions,
// for parts that are not connected there.
struct Grid {
  double cell = 0;                       // edge length b, m
  double cosine = 1, sine = 0;           // of the grain angle
  double x0 = 0, y0 = 0;                 // node (0,0) in the rotated plane, m
  int columns = 0, rows = 0;             // numbers of regular nodes along weft and warp
  std::vector<std::array<int, 2>> twin;  // [twins] (i, j)
  std::vector<GridCell> cells;   // regular ones first, row by row: at most one in a place, without twins
  int regular = 0;               // number of regular cells
  std::vector<double> area;      // [nodes] m^2 of cloth that belongs to a node; 0: no particle
  std::vector<GridPart> parts;   // of places that the outline cuts, row by row
  bool paper = false;            // outline = "paper": parts do not become cells
  std::vector<Vec2> on_outline;  // positions (m) of the last twins: particles of seams (paper)

  int nodes() const { return columns * rows + int(twin.size()); }
  std::array<int, 2> index(int node) const {
    if (node >= columns * rows) return twin[std::size_t(node - columns * rows)];
    return {node % columns, node / columns};
  }
  Vec2 place(int node) const {  // in the plane of the outline, m
    const int last = node - (nodes() - int(on_outline.size()));
    if (last >= 0) return on_outline[std::size_t(last)];
    const std::array<int, 2> at = index(node);
    const double x = x0 + at[0] * cell, y = y0 + at[1] * cell;
    return {x * cosine - y * sine, x * sine + y * cosine};
  }
};

// Makes the grid of a piece. The piece must have no outline_problems. With outline = "paper" the grid has no
// cells if no whole cell fits into the outline.
Grid grid_make(const Scene& scene, int piece);

// A point of the piece in terms of nodes: r(point) = sum_k weight[k] r(node[k]).
struct GridPoint {
  int node[4];
  double weight[4];  // sum 1; some exactly 0 where the point is on a grid line or node
};

// The GridPoint of a point in the plane of the outline (m).
GridPoint grid_locate(const Grid& grid, Vec2 point);

// The GridPoint on the bilinear map of a given cell; coordinates in cells from node (0,0).
GridPoint grid_point(const Grid& grid, int cell, Vec2 coordinates);

// Coordinates in the rotated plane, in cells from node (0,0), exact integers on grid lines; and the inverse.
Vec2 grid_coordinates(const Grid& grid, Vec2 point);
Vec2 grid_plane(const Grid& grid, Vec2 coordinates);

// True where the outline cuts the place, which then has parts.
bool grid_is_cut(const Grid& grid, int i, int j);

// True where the part is merged: its cell is at another place.
inline bool grid_is_merged(const Grid& grid, const GridPart& part) {
  const GridCell& cell = grid.cells[std::size_t(part.cell)];
  return cell.i != part.i || cell.j != part.j;
}

// The regular cell of a place, else its first cell with twins; -1: none.
int grid_cell_at(const Grid& grid, int i, int j);

// The cell whose map a point uses: that of its part, or of the closest part for a point outside the piece.
int grid_cell_of(const Grid& grid, Vec2 point);

}  // namespace drape::piece
