// Finds where segments of closed loops cross or touch, each pair of edges once.
#pragma once
#include "piece/outline/outline.h"

namespace drape::piece {

struct OutlineCrossing {
  int loop[2], edge[2];  // sorted by loop, then by edge
  Vec2 at;
  bool crosses;  // false: they only touch
};

// Returns at most `largest` pairs of edges that are closer than `contact` (m). The common ends of
// neighbouring segments do not count.
std::vector<OutlineCrossing> outline_crossings(const std::vector<OutlineLoop>& loops, double contact,
                                               std::size_t largest);

}  // namespace drape::piece
