// Where yarns cross an edge of the outline, and the links by which they leave a clamped edge.
#pragma once
#include "piece/outline/outline.h"
#include "piece/support/support.h"

namespace drape::piece {

// A point where an edge crosses a grid line, in cells, with the direction of the edge there. The cloth is to
// the left.
struct EdgeCrossing {
  Vec2 at, along;
  bool end;  // a corner of the outline
};
std::vector<EdgeCrossing> edge_crossings(const Grid& grid, const std::vector<OutlineLoop>& loops, int edge);

// Both ends of an edge, in cells.
std::array<Vec2, 2> edge_ends(const Grid& grid, const scene::PieceSpec& piece, int edge);

// Appends the links by which yarns leave a clamped edge.
void edge_slopes(const Grid& grid, const std::vector<OutlineLoop>& loops, int edge,
                 std::vector<HeldSlope>& slopes);

}  // namespace drape::piece
