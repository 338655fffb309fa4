// The contact library: FCL behind a C interface. The only file that includes FCL.
#include <fcl/fcl.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "body/mesh_reading.h"
#include "body/query.h"

// A tree of oriented boxes with rectangle swept spheres: the only kind of bounding volume tree with which FCL
// measures distances without transforming the mesh.
struct drape_query {
  fcl::BVHModel<fcl::OBBRSSd> tree;
};

namespace {

fcl::Vector3d vector_of(const double* p) { return {p[0], p[1], p[2]}; }

fcl::Transform3d transform_of(const double* p) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.translation() = vector_of(p);
  return transform;
}

drape_query* query_make(const double* point, size_t points, const int* corner, size_t triangles) {
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> faces;
  for (size_t k = 0; k < points; ++k) vertices.push_back(vector_of(point + 3 * k));
  for (size_t t = 0; t < triangles; ++t)
    faces.emplace_back(size_t(corner[3 * t]), size_t(corner[3 * t + 1]), size_t(corner[3 * t + 2]));
  auto query = std::make_unique<drape_query>();
  query->tree.beginModel(int(triangles), int(points));
  query->tree.addSubModel(vertices, faces);
  query->tree.endModel();
  return query.release();
}

void query_free(drape_query* query) { delete query; }

double distance(const drape_query* query, const double* at, int* triangle) {
  constexpr double kPoint = 1e-9;  // m, radius of the ball that represents the point
  const fcl::Sphered ball(kPoint);
  const fcl::DistanceRequest<double> request;
  fcl::DistanceResult<double> result;
  const double found =
      fcl::distance(&query->tree, fcl::Transform3d::Identity(), &ball, transform_of(at), request, result);
  if (triangle) *triangle = int(result.b1);
  return std::max(found, 0.0) + kPoint;
}

size_t within(const drape_query* query, const double* at, double radius, int* triangle, size_t capacity) {
  const fcl::Sphered ball(radius);
  const fcl::CollisionRequest<double> request(query->tree.num_tris, false);
  fcl::CollisionResult<double> result;
  fcl::collide(&query->tree, fcl::Transform3d::Identity(), &ball, transform_of(at), request, result);
  const size_t count = result.numContacts();
  for (size_t k = 0; k < std::min(count, capacity); ++k) triangle[k] = int(result.getContact(k).b1);
  std::sort(triangle, triangle + std::min(count, capacity));
  return count;
}

}  // namespace

const drape_contact_library* drape_contact_library_1() {
  static const drape_contact_library library{
      drape::body::mesh_read, drape::body::mesh_free, query_make, query_free, distance, within};
  return &library;
}
