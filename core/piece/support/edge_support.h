// Where an outline edge meets the threads, and the links by which they leave it.
#pragma once
#include "piece/outline/outline.h"
#include "piece/support/support.h"

namespace drape::piece {

// A point of an edge on a grid line, in cells, and the direction of the edge there, with the cloth to its
// left.
struct EdgeCrossing {
  Vec2 at, along;
  bool end;  // a corner of the outline
};
std::vector<EdgeCrossing> edge_crossings(const Grid& grid, const std::vector<OutlineLoop>& loops, int edge);

// Both ends of an edge, in cells.
std::array<Vec2, 2> edge_ends(const Grid& grid, const scene::PieceSpec& piece, int edge);

void edge_slopes(const Grid& grid, const std::vector<OutlineLoop>& loops, int edge,
                 std::vector<HeldSlope>& slopes);

}  // namespace drape::piece
