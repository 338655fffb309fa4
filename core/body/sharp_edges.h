// What is sharp about a body: its ridges (convex edges, rims of sheets) and tips, in the body's frame, and
// which of them are near a place. core/README.md, section 7.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "body/surface.h"

namespace drape::body {

// A ridge runs between two points; those of a tip are one. The surface falls away along `fall`, of length 1:
// into the triangles of an edge, along the edges of a tip, for `length`.
struct SharpFeature {
  Vec3 from, to;  // m
  bool tip;
  int edge;                    // of the surface, or vertex
  std::vector<Vec3> fall;      // at least one
  std::vector<double> length;  // [of fall] m
  Vec3 out;                    // = -sum fall, of length 1
  double sharp;  // least -out.fall: sine of the angle by which the surface falls away from `out`
};

// No surface whose triangles turn by less than 2 asin of this is sharp: it stands for a smooth one.
inline constexpr double kSharpSine = 0.0872;  // 10 degrees
inline constexpr double kSharpSineFit = 0.5;  // 60 degrees: fewer, for a fit to come to rest

struct SharpFeatures {
  std::vector<SharpFeature> feature;                                              // edges, then vertices
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};  // their box
  double bucket = 0;                                                              // m
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entry;                     // bucket and ridge, sorted
  std::vector<std::pair<std::uint64_t, std::uint32_t>> table;  // bucket and its first entry, hashed
};

// Those at least as sharp as `sine`; buckets of `bucket` m or more.
SharpFeatures sharp_features_make(const BodySurface& surface, double sine, double bucket);

// Those that may be in a box, in their order, each once.
void sharp_features_in(const SharpFeatures& features, const Vec3& low, const Vec3& high,
                       std::vector<std::uint32_t>& found);

// The distance (m) from x to the closest sharp feature, at most `largest`. `found` is scratch memory.
double sharp_features_distance(const SharpFeatures& features, const Vec3& x, double largest,
                               std::vector<std::uint32_t>& found);

}  // namespace drape::body
