#include "body/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/surface_walk.h"
#include "math/closest_points.h"
#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

constexpr double kFullTurn =
    std::numbers::pi / 2;               // of a bar's edge, and what a cube's corner lacks of a circle
constexpr double kMaxBuckets = 2e5;     // along all sharp edges
constexpr double kFlatTip = 1e-3;       // sine of its fall, below which a vertex is no tip at all
constexpr double kBucketFar = 1 << 20;  // buckets from the origin; points farther away share keys

// Sets `sharp`: how far all sides fall away from `out`.
void sharp_set(SharpFeature& r) {
  r.sharp = 1;
  for (const Vec3& f : r.fall) r.sharp = std::min(r.sharp, -dot(r.out, f));
}

// Sets `out` and `sharp`. Where the `normal` of a solid points the other way, the edge or vertex is a
// groove, which falls away from nothing.
void out_set(SharpFeature& r, const Vec3* normal) {
  r.out = {0, 0, 0};
  for (const Vec3& f : r.fall) r.out -= f;
  r.out = unit(r.out);
  sharp_set(r);
  if (normal && dot(r.out, *normal) <= 0) r.sharp = -1;
}

// Turns `out` until all sides fall away from it as far as they can, step by step against the one that falls
// least.
void out_improve(SharpFeature& r) {
  constexpr int kSteps = 64;
  SharpFeature best = r;
  for (int k = 1; k <= kSteps; ++k) {
    const Vec3& least = *std::max_element(r.fall.begin(), r.fall.end(), [&](const Vec3& a, const Vec3& b) {
      return dot(r.out, a) < dot(r.out, b);
    });
    r.out = unit(r.out - (1.0 / (k + 1)) * (least - dot(r.out, least) * r.out));
    sharp_set(r);
    if (r.sharp > best.sharp) best.out = r.out, best.sharp = r.sharp;
  }
  r.out = best.out;
  r.sharp = best.sharp;
}

// How far (m) the surface goes on straight.
double straight_of(const BodySurface& s, int triangle, const Vec3& from, const Vec3& along,
                   const SharpBounds& bounds) {
  const double longest = std::isfinite(bounds.longest) ? bounds.longest : s.size;
  return surface_walk(s, {triangle, from, along, {0, 0, 0}}, longest, bounds.bend).straight;
}

// How deep (m) a link would sink in, whose middle is over that of the edge, and whose ends are on the
// surface: the surface drops as much on both sides.
double edge_sink(const BodySurface& s, const SurfaceEdge& e, const SharpFeature& r, double half) {
  if (e.triangle.size() < 2) return 0;
  const Vec3 middle = 0.5 * (r.from + r.to);
  double least = INFINITY;
  for (std::size_t k = 0; k < e.triangle.size(); ++k)
    least = std::min(least, surface_walk(s, {e.triangle[k], middle, e.into[k], r.out}, half, half).drop);
  return least;
}

void sink_add(const SurfaceEdge& e, double sink, std::size_t triangles, std::vector<double>& to) {
  to.resize(triangles, 0.0);
  for (int t : e.triangle) to[std::size_t(t)] = std::max(to[std::size_t(t)], sink);
}

void edges_add(const BodySurface& s, const SharpBounds& bounds, SharpFeatures& to) {
  for (std::size_t k = 0; k < s.edges.size(); ++k) {
    const SurfaceEdge& e = s.edges[k];
    if (e.flat) continue;
    SharpFeature r{s.point[std::size_t(e.corner[0])],
                   s.point[std::size_t(e.corner[1])],
                   false,
                   int(k),
                   e.into,
                   {},
                   {},
                   0,
                   1,
                   true};
    out_set(r, s.solid && e.triangle.size() == 2 ? &e.normal : nullptr);
    if (!(r.sharp > 0)) continue;
    if (!(r.sharp > bounds.sine)) {
      if (!std::isfinite(bounds.sink)) continue;
      const double sink = edge_sink(s, e, r, bounds.half);
      if (!(sink > bounds.sink)) {
        if (bounds.keeps_off) sink_add(e, sink, s.corner.size(), to.sink);
        continue;
      }
    }
    const Vec3 middle = 0.5 * (r.from + r.to);
    for (std::size_t f = 0; f < e.triangle.size(); ++f)
      r.length.push_back(straight_of(s, e.triangle[f], middle, e.into[f], bounds));
    r.turn = std::min(2 * std::asin(std::min(r.sharp, 1.0)) / kFullTurn, 1.0);
    to.feature.push_back(r);
  }
}

// The directions from a vertex into one of its triangles: along both edges, hardly turned inwards, and
// between them.
std::array<Vec3, 3> directions_into(const BodySurface& s, int triangle, int vertex) {
  constexpr double kTurned = 0.01;
  const std::array<int, 3>& c = s.corner[std::size_t(triangle)];
  const std::size_t k = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
  const Vec3& p = s.point[std::size_t(vertex)];
  const Vec3 a = unit(s.point[std::size_t(c[(k + 1) % 3])] - p),
             b = unit(s.point[std::size_t(c[(k + 2) % 3])] - p);
  return {unit(a + kTurned * b), unit(a + b), unit(b + kTurned * a)};
}

// The corners of the surface at a vertex: its triangles, each once.
std::vector<int> triangles_at(const BodySurface& s, std::size_t vertex) {
  std::vector<int> found;
  for (int k : s.edges_at[vertex])
    for (int t : s.edges[std::size_t(k)].triangle) found.push_back(t);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Whether the surface falls away from a vertex by more than bounds.sink on all sides, half a link from it.
bool sinks_round(const BodySurface& s, const SharpFeature& r, const SharpBounds& bounds) {
  for (int t : triangles_at(s, std::size_t(r.edge)))
    for (const Vec3& along : directions_into(s, t, r.edge))
      if (!(surface_walk(s, {t, r.from, along, r.out}, bounds.half, bounds.half).drop > bounds.sink))
        return false;
  return true;
}

// What the corners at a vertex lack of a full circle.
double angle_missing(const BodySurface& s, int vertex) {
  double sum = 2 * std::numbers::pi;
  for (int t : triangles_at(s, std::size_t(vertex))) {
    const std::array<int, 3>& c = s.corner[std::size_t(t)];
    const std::size_t k = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
    const Vec3& p = s.point[std::size_t(vertex)];
    const Vec3 a = unit(s.point[std::size_t(c[(k + 1) % 3])] - p),
               b = unit(s.point[std::size_t(c[(k + 2) % 3])] - p);
    sum -= std::acos(std::clamp(dot(a, b), -1.0, 1.0));
  }
  return sum;
}

// A vertex on a sharp edge that the surface does not fall away from on all sides is a tip too, but a cell is
// only stopped there.
void tips_add(const BodySurface& s, const SharpBounds& bounds, SharpFeatures& to) {
  std::vector<char> on_edge(s.point.size(), 0);
  for (const SharpFeature& r : to.feature)
    for (int c : s.edges[std::size_t(r.edge)].corner) on_edge[std::size_t(c)] = 1;
  for (std::size_t p = 0; p < s.point.size(); ++p) {
    if (s.edges_at[p].empty() || s.flat_at[p]) continue;
    SharpFeature r{s.point[p], s.point[p], true, int(p), {}, {}, {}, 0, 1, true};
    for (int k : s.edges_at[p]) {
      const SurfaceEdge& e = s.edges[std::size_t(k)];
      const int other = e.corner[0] == int(p) ? e.corner[1] : e.corner[0];
      r.fall.push_back(unit(s.point[std::size_t(other)] - s.point[p]));
    }
    out_set(r, s.solid ? &s.normal_at[p] : nullptr);
    if (!(r.sharp > bounds.sine)) {
      if (!s.solid || !s.convex_at[p] || !std::isfinite(bounds.sink)) continue;
      r.out = s.normal_at[p];
      sharp_set(r);
      out_improve(r);
      const bool blunt = !(r.sharp > 0 && sinks_round(s, r, bounds));
      if (blunt && !(r.sharp > kFlatTip && on_edge[p])) continue;
      r.bears = !blunt;
    }
    for (std::size_t f = 0; f < r.fall.size(); ++f) {
      const SurfaceEdge& e = s.edges[std::size_t(s.edges_at[p][f])];
      const std::array<Vec3, 3> into = directions_into(s, e.triangle[0], int(p));
      const Vec3& along = dot(into[0], r.fall[f]) > dot(into[2], r.fall[f]) ? into[0] : into[2];
      r.length.push_back(straight_of(s, e.triangle[0], s.point[p], along, bounds));
    }
    if (s.solid) r.turn = std::clamp(angle_missing(s, int(p)) / kFullTurn, 0.0, 1.0);
    to.feature.push_back(r);
  }
}

using Bucket = std::array<std::int64_t, 3>;
Bucket bucket_of(const Vec3& x, double size) {
  Bucket at;
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = std::int64_t(std::clamp(std::floor(x[k] / size), -kBucketFar, kBucketFar - 1));
  return at;
}
std::uint64_t bucket_key(std::int64_t i, std::int64_t j, std::int64_t k) {
  const auto part = [](std::int64_t v) { return std::uint64_t(v + std::int64_t(kBucketFar)); };
  return (part(i) << 21 | part(j)) << 21 | part(k);
}

bool key_within(std::uint64_t key, const Bucket& low, const Bucket& high) {
  constexpr std::uint64_t kMask = (1u << 21) - 1;
  const std::uint64_t part[3] = {key >> 42, key >> 21 & kMask, key & kMask};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t at = std::int64_t(part[k]) - std::int64_t(kBucketFar);
    if (at < low[k] || at > high[k]) return false;
  }
  return true;
}

template <class Visit>
void buckets_visit(const Bucket& a, const Bucket& b, Visit visit) {
  for (std::int64_t i = a[0]; i <= b[0]; ++i)
    for (std::int64_t j = a[1]; j <= b[1]; ++j)
      for (std::int64_t k = a[2]; k <= b[2]; ++k) visit(bucket_key(i, j, k));
}

constexpr std::uint64_t kNoBucket = ~std::uint64_t(0);

// The index of a bucket in the hash table, or of the free slot where it would be inserted.
std::size_t table_index(const SharpFeatures& features, std::uint64_t key) {
  const std::size_t mask = features.table.size() - 1;
  std::size_t at = std::size_t((key * 0x9e3779b97f4a7c15u) >> 32) & mask;
  while (features.table[at].first != key && features.table[at].first != kNoBucket) at = (at + 1) & mask;
  return at;
}

// Enters each feature into its buckets. An edge is entered piece by piece, none of them longer than a bucket.
void buckets_fill(SharpFeatures& to) {
  for (std::size_t r = 0; r < to.feature.size(); ++r) {
    const Vec3 &a = to.feature[r].from, span = to.feature[r].to - a;
    const int pieces = std::max(1, int(std::ceil(norm(span) / to.bucket)));
    for (int p = 0; p < pieces; ++p) {
      const Vec3 from = a + (double(p) / pieces) * span, on = a + (double(p + 1) / pieces) * span;
      Vec3 low = from, high = from;
      for (std::size_t k = 0; k < 3; ++k)
        low[k] = std::min(from[k], on[k]), high[k] = std::max(from[k], on[k]);
      buckets_visit(bucket_of(low, to.bucket), bucket_of(high, to.bucket),
                    [&](std::uint64_t key) { to.entry.push_back({key, std::uint32_t(r)}); });
    }
  }
  std::sort(to.entry.begin(), to.entry.end());
  to.entry.erase(std::unique(to.entry.begin(), to.entry.end()), to.entry.end());
  std::size_t size = 16;
  while (size < 2 * to.entry.size()) size *= 2;
  to.table.assign(size, {kNoBucket, 0});
  for (std::size_t k = 0; k < to.entry.size(); ++k) {
    const std::uint64_t key = to.entry[k].first;
    if (k > 0 && to.entry[k - 1].first == key) continue;
    to.table[table_index(to, key)] = {key, std::uint32_t(k)};
  }
}

}  // namespace

SharpFeatures sharp_features_make(const BodySurface& surface, const SharpBounds& bounds, double bucket) {
  SharpFeatures to;
  edges_add(surface, bounds, to);
  tips_add(surface, bounds, to);
  double length = 0;
  for (const SharpFeature& r : to.feature) {
    for (double straight : r.length) to.narrow = to.narrow || straight < bounds.longest;
    length += norm(r.to - r.from);
    for (const Vec3& p : {r.from, r.to})
      for (std::size_t k = 0; k < 3; ++k)
        to.low[k] = std::min(to.low[k], p[k]), to.high[k] = std::max(to.high[k], p[k]);
  }
  to.bucket = std::max(bucket, length / kMaxBuckets);
  buckets_fill(to);
  return to;
}

void sharp_features_in(const SharpFeatures& features, const Vec3& low, const Vec3& high,
                       std::vector<std::uint32_t>& found) {
  found.clear();
  if (features.entry.empty()) return;
  Bucket a = bucket_of(low, features.bucket), b = bucket_of(high, features.bucket);
  const Bucket first = bucket_of(features.low, features.bucket),
               last = bucket_of(features.high, features.bucket);
  double buckets = 1;
  for (std::size_t k = 0; k < 3; ++k) {  // one more on each side, for the rounding of an edge's pieces
    a[k] = std::max(a[k], first[k] - 1), b[k] = std::min(b[k], last[k] + 1);
    if (a[k] > b[k]) return;
    buckets *= double(b[k] - a[k] + 1);
  }
  if (buckets >
      double(features.entry.size())) {  // a box around cloth that flies off may hold millions of them
    for (const auto& [key, feature] : features.entry)
      if (key_within(key, a, b)) found.push_back(feature);
  } else {
    buckets_visit(a, b, [&](std::uint64_t key) {
      const auto [known, entry] = features.table[table_index(features, key)];
      if (known != key) return;
      for (std::size_t k = entry; k < features.entry.size() && features.entry[k].first == key; ++k)
        found.push_back(features.entry[k].second);
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

double sharp_features_distance(const SharpFeatures& features, const Vec3& x, double largest,
                               std::vector<std::uint32_t>& found) {
  const Vec3 half_box{largest, largest, largest};
  for (std::size_t k = 0; k < 3; ++k)
    if (x[k] + largest < features.low[k] || x[k] - largest > features.high[k]) return largest;
  sharp_features_in(features, x - half_box, x + half_box, found);
  double smallest2 = largest * largest;
  for (std::uint32_t r : found)
    smallest2 =
        std::min(smallest2, math::segment_distance2(x, features.feature[r].from, features.feature[r].to));
  return std::sqrt(smallest2);
}

}  // namespace drape::body
