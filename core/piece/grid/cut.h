// Cuts a piece along the lines of its grid into connected parts. core/README.md, section 1. A place is one
// square of the grid. Coordinates are in cells: X, Y of the rotated plane from the origin of the grid,
// divided by b. Those of a part are relative to the low corner of its place.
#pragma once
#include "piece/outline/outline.h"

namespace drape::piece {

inline constexpr double kSnap = 1e-9;  // cells: a point closer to a grid line than this is on the line

// A stretch, along x or y, of a side of a place (0 below, 1 right, 2 above, 3 left) that belongs to a part.
struct CutSide {
  int side;
  double from, to;
};

struct CutPart {
  int place;
  double share;  // its area, of that of a cell
  std::vector<CutSide> sides;
  std::vector<std::vector<Vec2>> loops;  // outer boundary, then holes
};

enum : int { kPlaceOutside = -1, kPlaceWhole = -2 };

// The places of the piece with a margin of one place on all sides, row by row.
struct Cut {
  int i0 = 0, j0 = 0;          // grid indices of the first place
  int columns = 0, rows = 0;   // numbers of places
  std::vector<int> first;      // [rows columns] kPlaceOutside, kPlaceWhole or the first of its parts
  std::vector<CutPart> parts;  // sorted by place; a whole place has none
};

// Cuts the piece inside `loops`. Their coordinates are in cells and snapped; the cloth is to the left of each
// loop.
Cut cut_make(const std::vector<std::vector<Vec2>>& loops);

// Appends the points where p -> q (in cells) intersects grid lines, then q. The last of `points` must be p.
void cut_segment(Vec2 p, Vec2 q, std::vector<Vec2>& points);

// `v`, rounded to the exact integer where it is on a grid line.
double cut_snapped(double v);

}  // namespace drape::piece
