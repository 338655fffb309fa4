// A sweep tells whether any two segments touch. Only then are the pairs collected: each segment is entered
// into the square buckets along its path, and segments in the same bucket are compared. There are about as
// many buckets as segments; fewer where the segments are long.
#include "piece/outline/crossings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "piece/outline/segments.h"
#include "piece/outline/sweep.h"

namespace drape::piece {
namespace {

constexpr double kMostEntries = 4;               // a segment, in the mean: the buckets along its path
constexpr std::size_t kMostCompared = 10000000;  // pairs; where they are not enough, fewer are reported

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
  double length = 0;
  for (const Segment& s : segments) length += s.length;
  b.size = std::max(b.size, length / (kMostEntries * count));
  b.columns = int(width / b.size) + 1;
  b.rows = int(height / b.size) + 1;
  b.segments.resize(std::size_t(b.columns) * std::size_t(b.rows));
  for (std::size_t s = 0; s < segments.size(); ++s) bucket_fill(b, segments[s], int(s), contact);
  return b;
}

}  // namespace

std::vector<OutlineCrossing> outline_crossings(const std::vector<OutlineLoop>& loops, double contact,
                                               std::size_t largest) {
  const std::vector<Segment> segments = segments_of(loops);
  const auto first = sweep_touch(segments, contact);
  if (!first) return {};
  std::map<std::array<int, 4>, OutlineCrossing> found;
  std::size_t left = kMostCompared;
  const auto compare = [&](int u, int v) {
    const Segment &a = segments[std::size_t(std::min(u, v))], &b = segments[std::size_t(std::max(u, v))];
    OutlineCrossing c{{a.loop, b.loop}, {a.edge, b.edge}, {}, false};
    if (left > 0) --left;
    if (!segments_touch(a, b, contact, c)) return;
    if (a.loop == b.loop && a.edge > b.edge) std::swap(c.edge[0], c.edge[1]);
    found.insert({{c.loop[0], c.edge[0], c.loop[1], c.edge[1]}, c});
  };
  for (const std::vector<int>& bucket : buckets_make(segments, contact).segments)
    for (std::size_t u = 0; u < bucket.size(); ++u)
      for (std::size_t v = u + 1; v < bucket.size() && left > 0 && found.size() < largest; ++v)
        compare(bucket[u], bucket[v]);
  if (found.empty()) compare(first->first, first->second);
  std::vector<OutlineCrossing> list;
  for (const auto& pair : found) list.push_back(pair.second);
  return list;
}

}  // namespace drape::piece
