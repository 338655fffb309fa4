// The sharp features of a body, in the body's frame: sharp edges (convex edges and the boundary of an open
// surface) and tips. A hash grid finds those near a point. core/README.md, section 7.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "body/surface.h"

namespace drape::body {

// A sharp edge runs between two points; the two points of a tip are equal. The surface falls away from the
// feature along the unit vectors `fall`: into the triangles of an edge, or along the edges of a tip. It falls
// straight for the distances `length`, on a face that may be one of many triangles.
struct SharpFeature {
  Vec3 from, to;  // m
  bool tip;
  int edge;                    // number of the edge of the surface; of the vertex for a tip
  std::vector<Vec3> fall;      // at least one
  std::vector<double> length;  // [of fall] m, at most SharpBounds::longest
  Vec3 out;                    // -sum fall, normalized to length 1; of a blunt tip, the surface's normal
  double sharp;                // min of -out.fall: sine of the angle of fall from the plane normal to `out`
  double turn;  // 1, at most 1: an edge's turn over 90 degrees; a tip's over that of a corner of a cube
  bool bears;   // a penalty acts; else only the stop
};

// An edge is sharp where its triangles turn by at least 2 asin of this. Below that the mesh is taken as the
// approximation of a smooth surface.
inline constexpr double kSharpSine = 0.0872;  // 10 degrees
inline constexpr double kSharpSineFit = 0.5;  // 60 degrees: fewer sharp edges, so that a fit converges

// What is sharp: an edge or tip that falls by `sine` on all sides; or on which a straight link, with its
// middle over it and both ends on the surface, would sink in by `sink`.
struct SharpBounds {
  double sine = kSharpSine;
  double half = INFINITY, sink = INFINITY;  // m: half a link; how deep it may sink
  bool keeps_off = false;                   // particles are to stay away by what is left to sink
  double bend = 0, longest = INFINITY;      // m: a face is straight within `bend`; how far it is followed
};

struct SharpFeatures {
  std::vector<SharpFeature> feature;  // edges, then tips
  // [triangles] m, how deep a link may sink in at their edges that are not sharp: less than
  // SharpBounds::sink. Empty: nowhere.
  std::vector<double> sink;
  bool narrow = false;  // a face of a feature is not straight for SharpBounds::longest
  // Bounding box of the features, m.
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  double bucket = 0;                                           // m, size of a bucket
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entry;  // bucket and feature, sorted
  std::vector<std::pair<std::uint64_t, std::uint32_t>> table;  // hash table: bucket and its first entry
};

// The sharp features of a surface, in buckets of at least `bucket` m.
SharpFeatures sharp_features_make(const BodySurface& surface, const SharpBounds& bounds, double bucket);

// Finds the features whose buckets meet the box from `low` to `high`: their numbers, ascending, each once.
void sharp_features_in(const SharpFeatures& features, const Vec3& low, const Vec3& high,
                       std::vector<std::uint32_t>& found);

// The distance (m) from x to the closest sharp feature, at most `largest`. `found` is scratch memory.
double sharp_features_distance(const SharpFeatures& features, const Vec3& x, double largest,
                               std::vector<std::uint32_t>& found);

}  // namespace drape::body
