#include "body/sharp_edges.h"

#include <algorithm>
#include <cmath>

#include "math/closest_points.h"
#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

constexpr double kMaxBuckets = 2e5;     // along all sharp edges
constexpr double kBucketFar = 1 << 20;  // buckets from the origin; points farther away share keys

// Sets `out` and `sharp`. Where the `normal` of a solid points the other way, the edge or vertex is a
// groove, which is not sharp.
bool is_sharp(SharpFeature& r, double sine, const Vec3* normal) {
  if (r.fall.empty()) return false;
  r.out = {0, 0, 0};
  for (const Vec3& f : r.fall) r.out -= f;
  r.out = unit(r.out);
  r.sharp = 1;
  for (const Vec3& f : r.fall) r.sharp = std::min(r.sharp, -dot(r.out, f));
  return r.sharp > sine && !(normal && dot(r.out, *normal) <= 0);
}

// The extent (m) of a triangle along `into` from an edge through `from`.
double height_over(const BodySurface& s, const Vec3& from, int triangle, const Vec3& into) {
  double largest = 0;
  for (int c : s.corner[std::size_t(triangle)])
    largest = std::max(largest, dot(s.point[std::size_t(c)] - from, into));
  return largest;
}

void edges_add(const BodySurface& s, double sine, SharpFeatures& to) {
  for (std::size_t k = 0; k < s.edges.size(); ++k) {
    const SurfaceEdge& e = s.edges[k];
    if (s.solid && e.triangle.size() != 2) continue;  // a bad edge
    SharpFeature r{s.point[std::size_t(e.corner[0])],
                   s.point[std::size_t(e.corner[1])],
                   false,
                   int(k),
                   e.into,
                   {},
                   {},
                   0};
    for (std::size_t f = 0; f < e.triangle.size(); ++f)
      r.length.push_back(height_over(s, r.from, e.triangle[f], e.into[f]));
    if (is_sharp(r, sine, s.solid ? &e.normal : nullptr)) to.feature.push_back(r);
  }
}

void tips_add(const BodySurface& s, double sine, SharpFeatures& to) {
  for (std::size_t p = 0; p < s.point.size(); ++p) {
    SharpFeature r{s.point[p], s.point[p], true, int(p), {}, {}, {}, 0};
    for (int k : s.edges_at[p]) {
      const SurfaceEdge& e = s.edges[std::size_t(k)];
      const int other = e.corner[0] == int(p) ? e.corner[1] : e.corner[0];
      r.fall.push_back(unit(s.point[std::size_t(other)] - s.point[p]));
      r.length.push_back(norm(s.point[std::size_t(other)] - s.point[p]));
    }
    if (is_sharp(r, sine, s.solid ? &s.normal_at[p] : nullptr)) to.feature.push_back(r);
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

SharpFeatures sharp_features_make(const BodySurface& surface, double sine, double bucket) {
  SharpFeatures to;
  edges_add(surface, sine, to);
  tips_add(surface, sine, to);
  double length = 0;
  for (const SharpFeature& r : to.feature) {
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
