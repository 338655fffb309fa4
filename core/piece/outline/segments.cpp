#include "piece/outline/segments.h"

#include <algorithm>
#include <cmath>

namespace drape::piece {
namespace {

double end_distance(const Segment& s, Vec2 point) {
  const Vec2 d{s.q[0] - s.p[0], s.q[1] - s.p[1]}, e{point[0] - s.p[0], point[1] - s.p[1]};
  const double t = std::clamp((d[0] * e[0] + d[1] * e[1]) / (s.length * s.length), 0.0, 1.0);
  return std::hypot(e[0] - t * d[0], e[1] - t * d[1]);
}

// True if a segment is on one side of the line of `a`. p and q are the cross products of its ends with `a`.
bool is_aside(const Segment& a, double p, double q, double contact) {
  return std::min(p, q) > contact * a.length || std::max(p, q) < -contact * a.length;
}

}  // namespace

std::vector<Segment> segments_of(const std::vector<OutlineLoop>& loops) {
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t k = 0, n = loops[l].points.size(); k < n; ++k) {
      const Vec2 p = loops[l].points[k], q = loops[l].points[(k + 1) % n];
      segments.push_back(
          {p, q, int(l), int(k), loops[l].edge[k], int(n), std::hypot(q[0] - p[0], q[1] - p[1])});
    }
  return segments;
}

bool segments_touch(const Segment& a, const Segment& b, double contact, OutlineCrossing& found) {
  for (std::size_t k = 0; k < 2; ++k)
    if (std::max(a.p[k], a.q[k]) + contact < std::min(b.p[k], b.q[k]) ||
        std::max(b.p[k], b.q[k]) + contact < std::min(a.p[k], a.q[k]))
      return false;
  const bool follows = a.loop == b.loop && (a.index + 1) % a.count == b.index;  // b follows a
  const bool precedes = a.loop == b.loop && (b.index + 1) % a.count == a.index;
  const double bp = segment_side(a.p, a.q, b.p), bq = segment_side(a.p, a.q, b.q);
  const double ap = segment_side(b.p, b.q, a.p), aq = segment_side(b.p, b.q, a.q);
  if (is_aside(a, bp, bq, contact) || is_aside(b, ap, aq, contact)) return false;
  if (!follows && !precedes && bp * bq < 0 && ap * aq < 0) {
    const double t = ap / (ap - aq);
    found.at = {a.p[0] + t * (a.q[0] - a.p[0]), a.p[1] + t * (a.q[1] - a.p[1])};
    found.crosses = true;
    return true;
  }
  found.crosses = false;
  const auto near = [&](const Segment& s, Vec2 end) {
    if (end_distance(s, end) > contact) return false;
    found.at = end;
    return true;
  };
  return (!follows && near(a, b.p)) || (!precedes && near(a, b.q)) || (!precedes && near(b, a.p)) ||
         (!follows && near(b, a.q));
}

}  // namespace drape::piece
