// The surface of a body: triangles, their adjacency and their outward normals.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::body {

// An edge of the surface: two points, the triangles that share the edge and, for each of them, the unit
// vector in the triangle's plane that points from the edge into the triangle.
struct SurfaceEdge {
  std::array<int, 2> corner;
  std::vector<int> triangle;
  std::vector<Vec3> into;
  Vec3 normal;        // mean of the triangles' normals, of length 1
  double turn = 0;    // sine of the angle between the normals of its triangles; 0 unless it has two
  bool flat = false;  // its two triangles lie in one plane
};

// The data of a triangle that a search reads first, in one cache line.
struct alignas(64) Facet {
  Vec3 middle;    // m
  double radius;  // m, from the middle to the farthest corner
  Vec3 normal;    // of length 1; outwards where the surface is a solid
};

struct BodySurface {
  std::vector<Vec3> point;                 // m
  std::vector<std::array<int, 3>> corner;  // [triangles]
  std::vector<Facet> facet;                // [triangles]
  std::vector<std::array<int, 3>> edge;    // [triangles] edge k runs from corner k to corner k + 1
  std::vector<SurfaceEdge> edges;
  std::vector<std::vector<int>> edges_at;  // [points]
  std::vector<Vec3> normal_at;             // [points] mean of the normals, weighted by angles; of length 1
  std::vector<char> convex_at;             // [points] 1 where no edge at the point is concave (a groove)
  std::vector<char> flat_at;               // [points] 1 where all edges at the point are flat
  bool solid = false;                      // closed, so that it has an inside
  double edge_mean = 0, size = 0;          // m, mean edge length; diagonal of the bounding box
};

// Defects found while making a surface.
struct SurfaceFindings {
  std::size_t degenerate = 0;         // triangles without area, omitted
  std::size_t open = 0, crowded = 0;  // edges with one triangle, with more than two
  std::size_t turned = 0;             // edges whose triangles have opposite orientations
};

// Makes a surface from the points (m) and corners of a mesh. On failure the surface is empty and `trouble`
// gives the reason.
BodySurface surface_make(const std::vector<Vec3>& point, const std::vector<std::array<int, 3>>& corner,
                         SurfaceFindings& findings, std::string& trouble);

}  // namespace drape::body
