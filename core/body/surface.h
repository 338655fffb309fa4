// The surface of a body: triangles, which of them meet where, and which way is out.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::body {

// A corner pair of the surface; its triangles, and the unit vectors in each triangle's plane that point from
// the edge into it.
struct SurfaceEdge {
  std::array<int, 2> corner;
  std::vector<int> triangle;
  std::vector<Vec3> into;
  Vec3 normal;      // mean of the triangles' normals, length 1
  double turn = 0;  // sine of the angle between two triangles' normals; 0 where there are not two
};

// What a search asks first of a triangle, in one line of the cache.
struct alignas(64) Facet {
  Vec3 middle;   // m
  double reach;  // m, from the middle to the farthest corner
  Vec3 normal;   // length 1; out of a solid
};

struct BodySurface {
  std::vector<Vec3> point;                 // m
  std::vector<std::array<int, 3>> corner;  // [triangles]
  std::vector<Facet> facet;                // [triangles]
  std::vector<std::array<int, 3>> edge;    // [triangles] edge k runs from corner k to corner k + 1
  std::vector<SurfaceEdge> edges;
  std::vector<std::vector<int>> edges_at;  // [points]
  std::vector<Vec3> normal_at;     // [points] mean of the triangles' normals by their angles, length 1
  std::vector<char> convex_at;     // [points] no edge there is a groove
  bool solid = false;              // closed: it has an inside
  double edge_mean = 0, size = 0;  // m; size: the diagonal of its box
};

// What making a surface met with.
struct SurfaceFindings {
  std::size_t degenerate = 0;         // triangles without area, left out
  std::size_t open = 0, crowded = 0;  // edges with one triangle, with more than two
  std::size_t turned = 0;             // edges whose triangles face different ways
};

// From what stands in a file. Empty: `trouble` says why.
BodySurface surface_make(const std::vector<Vec3>& point, const std::vector<std::array<int, 3>>& corner,
                         SurfaceFindings& findings, std::string& trouble);

}  // namespace drape::body
