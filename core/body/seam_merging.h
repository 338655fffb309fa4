// Closes the seams of a mesh, along which its points have been split.
#pragma once
#include <vector>

namespace drape::body {

struct Triangles {
  std::vector<double> point;  // [points x 3], m
  std::vector<int> corner;    // [triangles x 3] points
};

// Points of open edges that are nearer to each other than kSeam of the mesh's size become the first of them.
// So a surface is closed again whose points are split along a texture seam or hard edge, or differ in their
// last digits. Two closed surfaces that touch stay apart: they have no open edge. (In STL they share the
// points that have equal coordinates.)
inline constexpr double kSeam = 1e-6;
void seams_merge(Triangles& mesh);

}  // namespace drape::body
