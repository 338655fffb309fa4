// Where a particle touches: the local minima of its distance to the surface.
//
// A face is one where the particle stands over its inside; an edge where it stands beyond all of the edge's
// triangles; a vertex where it stands beyond all of its edges:
//
//        \ v /         one minimum over a convex edge or tip, two in a groove
//      f  \ / f   e
//     ------o---------
//
// The distance to each is |D (x - p)|: D = n n^T over a face, 1 - e e^T over an edge, 1 over a vertex.
#pragma once
#include <vector>

#include "body/surface.h"

namespace drape::body {

struct ClosestFeature {
  Vec3 point;                   // p, m
  std::array<double, 6> shape;  // D: xx xy xz yy yz zz
  Vec3 side;                    // unit vector from the surface to the side that the particle belongs to
  double distance;              // m; negative where it is on the wrong side
};

struct ClosestFeatures {
  std::vector<ClosestFeature> feature;  // those within `within`, the nearest first
  double free_distance = 0;  // m that the particle may move before any of this must be looked at again
};

// For a particle at x; `triangle` lists all triangles within `listed` of x. Beyond `contact_distance` nothing touches;
// what is farther than `reach`, at least `within`, is measured by the planes of triangles and the balls
// around them. `side`: the side of the nearest feature so far, or null.
void closest_features_find(const BodySurface& surface, const std::vector<int>& triangle, const Vec3& x,
                           double contact_distance, double within, double reach, double listed, const Vec3* side,
                           ClosestFeatures& found);

// The distance to a triangle.
double closest_features_distance(const BodySurface& surface, int triangle, const Vec3& x);

// The signed distance to the surface at the triangle that is known to be nearest; above 0 outside, and where
// the surface has no inside. Where the triangle faces away from x the whole surface is asked: a few bad edges
// make no inside.
double closest_features_signed(const BodySurface& surface, int triangle, const Vec3& x);

}  // namespace drape::body
