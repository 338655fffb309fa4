// The segments of closed loops, and where two of them cross or touch.
#pragma once
#include "piece/outline/crossings.h"

namespace drape::piece {

struct Segment {
  Vec2 p, q;
  int loop, index, edge;
  int count;  // segments of the loop
  double length;
};
std::vector<Segment> segments_of(const std::vector<OutlineLoop>& loops);

// > 0 if q lies to the left of a -> p.
inline double segment_side(Vec2 a, Vec2 p, Vec2 q) {
  return (p[0] - a[0]) * (q[1] - a[1]) - (p[1] - a[1]) * (q[0] - a[0]);
}

// Finds the point where two segments cross, or come closer than `contact` (m). The common ends of neighbours
// do not count.
bool segments_touch(const Segment& a, const Segment& b, double contact, OutlineCrossing& found);

}  // namespace drape::piece
