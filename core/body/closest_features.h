// The features of a body's surface closest to a particle: the local minima of the distance to the surface.
//
// A minimum on a face lies in the interior of a triangle, under the particle. A minimum on an edge lies
// beyond all triangles of the edge. A minimum on a vertex lies beyond all edges of the vertex:
//
//        \ v /         one minimum over a convex edge or tip, two in a groove
//      f  \ / f   e
//     ------o---------
//
// The distance to a feature at p is |D (x - p)|. D = n n^T for a face with normal n, D = 1 - e e^T for an
// edge along e, and D = 1 for a vertex.
#pragma once
#include <array>
#include <vector>

#include "body/surface.h"

namespace drape::body {

struct ClosestFeature {
  Vec3 point;                   // p, m
  std::array<double, 6> shape;  // D: xx xy xz yy yz zz
  Vec3 side;                    // unit vector from the surface to the side that the particle belongs to
  double distance;              // m; negative where the particle is on the wrong side
  int triangle;                 // on which the feature was found
};

struct ClosestFeatures {
  std::vector<ClosestFeature> feature;  // the closest first
  double free_distance = 0;  // m, how far the particle may move before the features must be found again
};

// A particle and the distances that bound the search around it; all in m, in the body's frame.
struct ClosestFeaturesQuery {
  Vec3 x;                   // the particle
  double contact_distance;  // beyond it the particle does not touch
  double within;            // features up to this distance are found
  double reach;      // at least `within`; a triangle farther away is bounded by its plane and sphere only
  double listed;     // the candidate triangles include all within this distance of x
  const Vec3* side;  // side of the closest feature found last; null: none known
};

// The closest point of one triangle to x, and the feature it lies on.
enum class FeatureKind { kFace, kEdge, kVertex };
struct TrianglePoint {
  FeatureKind kind;
  int index;  // triangle, edge or vertex of the surface
  Vec3 point;
};

// Memory of `closest_features_find`, kept between calls to save allocations. One for each thread.
struct ClosestFeaturesScratch {
  struct Candidate {
    int triangle;
    double distance;  // m
    TrianglePoint closest;
  };
  std::vector<Candidate> near, minima;
  std::vector<std::array<int, 2>> seen;  // kind and index
};

// Finds the features closest to the particle among the triangles with the numbers `triangle`.
void closest_features_find(const BodySurface& surface, const std::vector<int>& triangle,
                           const ClosestFeaturesQuery& query, ClosestFeaturesScratch& scratch,
                           ClosestFeatures& found);

// The distance from x to a triangle, m.
double closest_features_distance(const BodySurface& surface, int triangle, const Vec3& x);

// The signed distance (m) from x to the surface; `triangle` is the number of the triangle closest to x. The
// distance is negative inside, and positive outside or where the surface has no inside. Where the triangle
// faces away from x, the winding number of the whole surface decides, so a few bad edges enclose no inside.
double closest_features_signed(const BodySurface& surface, int triangle, const Vec3& x);

}  // namespace drape::body
