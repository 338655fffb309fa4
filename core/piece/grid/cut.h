// A piece cut along the lines of its grid into connected parts. core/README.md, section 1. Coordinates are in
// cells: X, Y of the turned plane from the grid's origin, over b; those of a part from the low corner of its
// place.
#pragma once
#include "piece/outline/outline.h"

namespace drape::piece {

inline constexpr double kSnap = 1e-9;  // cells: closer to a grid line is on it

// Where a part reaches a side of its place (0 below, 1 right, 2 above, 3 left), along x or y.
struct CutSide {
  int side;
  double from, to;
};

struct CutPart {
  int place;
  double share;  // its area
  std::vector<CutSide> sides;
  std::vector<std::vector<Vec2>> loops;  // the rim, then holes
};

enum : int { kPlaceOutside = -1, kPlaceWhole = -2 };

// Places: those of the piece and a margin of one all round, row by row.
struct Cut {
  int i0 = 0, j0 = 0;          // of the first place
  int columns = 0, rows = 0;   // of places
  std::vector<int> first;      // [rows columns] kPlaceOutside, kPlaceWhole or the first of its parts
  std::vector<CutPart> parts;  // place by place; none of a whole one
};

// Loops in cells, their coordinates snapped; the cloth to the left of each.
Cut cut_make(const std::vector<std::vector<Vec2>>& loops);

// Appends the points at which p -> q, in cells, meets a grid line, and q; p is the last of the points.
void cut_segment(Vec2 p, Vec2 q, std::vector<Vec2>& points);

// `v`, exactly whole where it lies on a grid line.
double cut_snapped(double v);

}  // namespace drape::piece
