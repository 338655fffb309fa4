// The grid of a piece: cells along the threads, cut by the outline, and the nodes at their corners.
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
  double share;  // phi
};

// A connected part of the piece within one place of the grid, cut by the outline.
struct GridPart {
  int i, j;
  int cell;                              // whose map its points use
  std::vector<std::vector<Vec2>> loops;  // the rim, then holes; the plane of the outline, m
};

// Node (i,j) of the rows is node j columns + i; the twins follow.
struct Grid {
  double cell = 0;                       // b, m
  double cosine = 1, sine = 0;           // of the grain
  double x0 = 0, y0 = 0;                 // node (0,0) in the turned plane, m
  int columns = 0, rows = 0;             // regular nodes along weft and warp
  std::vector<std::array<int, 2>> twin;  // [twins] (i, j)
  std::vector<GridCell> cells;   // regular ones first, row by row: one at most in a place, without twins
  int regular = 0;               // their number
  std::vector<double> area;      // [columns rows + twins] m^2 that a node carries; 0: no particle
  std::vector<GridPart> parts;   // of cells that the outline cuts, row by row
  bool paper = false;            // outline = "paper": parts are no cells
  std::vector<Vec2> on_outline;  // the last twins: particles of seams (paper), where they lie, m

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

// Of a piece without outline_problems. With outline = "paper" a piece without a whole cell has no cells.
Grid grid_make(const Scene& scene, int piece);

// Where a point of the piece sits: r(point) = sum_k weight[k] r(node[k]).
struct GridPoint {
  int node[4];
  double weight[4];  // sum 1; exact zeros where the point lies on a grid line or node
};
GridPoint grid_locate(const Grid& grid, Vec2 point);

// The same on the map of a cell; the point in cells from node (0,0).
GridPoint grid_point(const Grid& grid, int cell, Vec2 coordinates);

// Of the turned plane, in cells from node (0,0), exactly whole on a grid line; and back.
Vec2 grid_coordinates(const Grid& grid, Vec2 point);
Vec2 grid_plane(const Grid& grid, Vec2 coordinates);

// True where the outline cuts the place: it holds parts.
bool grid_is_cut(const Grid& grid, int i, int j);

// True where the cell of a part has another place: it has taken the part over.
inline bool grid_is_merged(const Grid& grid, const GridPart& part) {
  const GridCell& cell = grid.cells[std::size_t(part.cell)];
  return cell.i != part.i || cell.j != part.j;
}

// The regular cell of a place, else the first with twins; -1: none.
int grid_cell_at(const Grid& grid, int i, int j);

// The cell whose map a point uses: that of its part; for a point off the piece, of the nearest part.
int grid_cell_of(const Grid& grid, Vec2 point);

}  // namespace drape::piece
