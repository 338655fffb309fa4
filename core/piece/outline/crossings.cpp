// Each segment is entered into the square buckets along its path. There are about as many buckets as
// segments, and only segments in the same bucket are compared.
#include "piece/outline/crossings.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace drape::piece {
namespace {

struct Segment {
  Vec2 p, q;
  int loop, index, edge;
  double length;
};

double cross(Vec2 a, Vec2 p, Vec2 q) {  // > 0 if q lies to the left of a -> p
  return (p[0] - a[0]) * (q[1] - a[1]) - (p[1] - a[1]) * (q[0] - a[0]);
}

double end_distance(const Segment& s, Vec2 point) {
  const Vec2 d{s.q[0] - s.p[0], s.q[1] - s.p[1]}, e{point[0] - s.p[0], point[1] - s.p[1]};
  const double t = std::clamp((d[0] * e[0] + d[1] * e[1]) / (s.length * s.length), 0.0, 1.0);
  return std::hypot(e[0] - t * d[0], e[1] - t * d[1]);
}

// True if a segment is on one side of the line of `a`. p and q are the cross products of its ends with `a`.
bool is_aside(const Segment& a, double p, double q, double contact) {
  return std::min(p, q) > contact * a.length || std::max(p, q) < -contact * a.length;
}

// Finds the point where two segments cross or touch. `follows`, `precedes`: b is the successor or predecessor
// of a, and shares an end with it that does not count.
bool segments_touch(const Segment& a, const Segment& b, bool follows, bool precedes, double contact,
                    OutlineCrossing& found) {
  for (std::size_t k = 0; k < 2; ++k)
    if (std::max(a.p[k], a.q[k]) + contact < std::min(b.p[k], b.q[k]) ||
        std::max(b.p[k], b.q[k]) + contact < std::min(a.p[k], a.q[k]))
      return false;
  const double bp = cross(a.p, a.q, b.p), bq = cross(a.p, a.q, b.q);
  const double ap = cross(b.p, b.q, a.p), aq = cross(b.p, b.q, a.q);
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

struct Buckets {
  Vec2 low{INFINITY, INFINITY};
  double size = 0;
  int columns = 1, rows = 1;
  std::vector<std::vector<int>> segments;  // [rows columns]
};

int slot(const Buckets& b, double v, std::size_t k) {
  return std::clamp(int(std::floor((v - b.low[k]) / b.size)), 0, (k ? b.rows : b.columns) - 1);
}

// Adds a segment to every bucket near its path. In each column these are the rows from where the segment
// enters the column to where it leaves it.
void bucket_fill(Buckets& b, const Segment& segment, int number, double contact) {
  Vec2 p = segment.p, q = segment.q;
  if (p[0] > q[0]) std::swap(p, q);
  const auto height_at = [&](double x) {
    return p[1] + (q[1] - p[1]) * std::clamp((x - p[0]) / (q[0] - p[0]), 0.0, 1.0);
  };
  const int last = slot(b, q[0] + contact, 0);
  for (int i = slot(b, p[0] - contact, 0); i <= last; ++i) {
    const double left = b.low[0] + i * b.size - 2 * contact, right = left + b.size + 4 * contact;
    double from = p[1], to = q[1];
    if (q[0] - p[0] > contact) from = height_at(left), to = height_at(right);
    if (from > to) std::swap(from, to);
    const int top = slot(b, to + 2 * contact, 1);
    for (int j = slot(b, from - 2 * contact, 1); j <= top; ++j)
      b.segments[std::size_t(j) * std::size_t(b.columns) + std::size_t(i)].push_back(number);
  }
}

Buckets buckets_make(const std::vector<Segment>& segments, double contact) {
  Buckets b;
  Vec2 high{-INFINITY, -INFINITY};
  for (const Segment& s : segments)
    for (std::size_t k = 0; k < 2; ++k)
      b.low[k] = std::min(b.low[k], s.p[k] - 2 * contact), high[k] = std::max(high[k], s.p[k] + 2 * contact);
  const double width = high[0] - b.low[0], height = high[1] - b.low[1], count = double(segments.size());
  b.size = std::max(std::sqrt(width * height / count) / 2, std::max(width, height) / (2 * count));
  b.columns = int(width / b.size) + 1;
  b.rows = int(height / b.size) + 1;
  b.segments.resize(std::size_t(b.columns) * std::size_t(b.rows));
  for (std::size_t s = 0; s < segments.size(); ++s) bucket_fill(b, segments[s], int(s), contact);
  return b;
}

std::vector<Segment> segments_of(const std::vector<OutlineLoop>& loops) {
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t k = 0, n = loops[l].points.size(); k < n; ++k) {
      const Vec2 p = loops[l].points[k], q = loops[l].points[(k + 1) % n];
      segments.push_back({p, q, int(l), int(k), loops[l].edge[k], std::hypot(q[0] - p[0], q[1] - p[1])});
    }
  return segments;
}

}  // namespace

std::vector<OutlineCrossing> outline_crossings(const std::vector<OutlineLoop>& loops, double contact,
                                               std::size_t largest) {
  const std::vector<Segment> segments = segments_of(loops);
  std::map<std::array<int, 4>, OutlineCrossing> found;
  const auto compare = [&](const Segment& a, const Segment& b) {
    const int n = int(loops[std::size_t(a.loop)].points.size());
    const bool follows = a.loop == b.loop && (a.index + 1) % n == b.index;
    const bool precedes = a.loop == b.loop && (b.index + 1) % n == a.index;
    OutlineCrossing c{{a.loop, b.loop}, {a.edge, b.edge}, {}, false};
    if (!segments_touch(a, b, follows, precedes, contact, c)) return;
    if (a.loop == b.loop && a.edge > b.edge) std::swap(c.edge[0], c.edge[1]);
    found.insert({{c.loop[0], c.edge[0], c.loop[1], c.edge[1]}, c});
  };
  for (const std::vector<int>& bucket : buckets_make(segments, contact).segments)
    for (std::size_t u = 0; u < bucket.size() && found.size() < largest; ++u)
      for (std::size_t v = u + 1; v < bucket.size() && found.size() < largest; ++v)
        compare(segments[std::size_t(bucket[u])], segments[std::size_t(bucket[v])]);
  std::vector<OutlineCrossing> list;
  for (const auto& pair : found) list.push_back(pair.second);
  return list;
}

}  // namespace drape::piece
