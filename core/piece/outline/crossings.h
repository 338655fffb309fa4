// Where segments of closed loops cross or touch each other: each pair of edges once.
#pragma once
#include "piece/outline/outline.h"

namespace drape::piece {

struct OutlineCrossing {
  int loop[2], edge[2];  // in the order of the loops, then of the edges
  Vec2 at;
  bool crosses;  // else touches
};

// The first `most` pairs of edges that come closer than `touch`, apart from the ends that neighbours share.
std::vector<OutlineCrossing> outline_crossings(const std::vector<OutlineLoop>& loops, double contact,
                                               std::size_t largest);

}  // namespace drape::piece
