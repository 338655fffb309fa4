// The contact library: FCL behind a C interface. Includes FCL's search for one kind of tree and one shape;
// the matrices of fcl::distance and fcl::collide hold those for all.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_triangle.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_shape_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_shape_distance_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/traversal_recurse.h>

#include <algorithm>
#include <cstdint>
#include <limits>
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

using Vector = fcl::Vector3d;
using Transform = fcl::Transform3d;
using Ball = fcl::Sphered;

// What FCL calls a narrow phase solver, for a ball and a triangle. The names are FCL's.
struct Solver {
  // NOLINTBEGIN(readability-function-size): the parameters are FCL's too
  bool shapeTriangleDistance(const Ball& ball, const Transform& ball_at, const Vector& a, const Vector& b,
                             const Vector& c, const Transform& mesh_at, double* distance, Vector* on_ball,
                             Vector* on_triangle) const {
    return fcl::detail::sphereTriangleDistance(ball, ball_at, a, b, c, mesh_at, distance, on_ball,
                                               on_triangle);
  }
  bool shapeTriangleDistance(const Ball& ball, const Transform& ball_at, const Vector& a, const Vector& b,
                             const Vector& c, double* distance, Vector* on_ball, Vector* on_triangle) const {
    return fcl::detail::sphereTriangleDistance(ball, ball_at, a, b, c, distance, on_ball, on_triangle);
  }
  bool shapeTriangleIntersect(const Ball& ball, const Transform& ball_at, const Vector& a, const Vector& b,
                              const Vector& c, const Transform& mesh_at, Vector* point, double* depth,
                              Vector* normal) const {
    return fcl::detail::sphereTriangleIntersect(ball, ball_at, mesh_at * a, mesh_at * b, mesh_at * c, point,
                                                depth, normal);
  }
  bool shapeTriangleIntersect(const Ball& ball, const Transform& ball_at, const Vector& a, const Vector& b,
                              const Vector& c, Vector* point, double* depth, Vector* normal) const {
    return fcl::detail::sphereTriangleIntersect(ball, ball_at, a, b, c, point, depth, normal);
  }
  // NOLINTEND(readability-function-size)
};

Vector vector_of(const double* p) { return {p[0], p[1], p[2]}; }

Transform transform_of(const double* p) {
  Transform transform = Transform::Identity();
  transform.translation() = vector_of(p);
  return transform;
}

std::unique_ptr<drape_query> tree_of(const double* point, size_t points, const int* corner,
                                     size_t triangles) {
  std::vector<Vector> vertices;
  std::vector<fcl::Triangle> faces;
  for (size_t k = 0; k < points; ++k) vertices.push_back(vector_of(point + 3 * k));
  for (size_t t = 0; t < triangles; ++t)
    faces.emplace_back(size_t(corner[3 * t]), size_t(corner[3 * t + 1]), size_t(corner[3 * t + 2]));
  auto query = std::make_unique<drape_query>();
  query->tree.beginModel(int(triangles), int(points));
  query->tree.addSubModel(vertices, faces);
  query->tree.endModel();
  return query;
}

drape_query* query_make(const double* point, size_t points, const int* corner, size_t triangles) noexcept {
  try {
    return tree_of(point, points, corner, triangles).release();
  } catch (...) {
    return nullptr;
  }
}

void query_free(drape_query* query) noexcept { delete query; }

double distance_to(const drape_query* query, const double* at, int* triangle) {
  constexpr double kPoint = 1e-9;  // m, radius of the ball that represents the point
  const Ball ball(kPoint);
  const Solver solver;
  const fcl::DistanceRequest<double> request;
  fcl::DistanceResult<double> result;
  fcl::detail::MeshShapeDistanceTraversalNodeOBBRSS<Ball, Solver> node;
  initialize(node, query->tree, Transform::Identity(), ball, transform_of(at), &solver, request, result);
  node.preprocess();
  fcl::detail::distanceRecurse<double>(&node, 0, 0, nullptr);
  if (triangle) *triangle = int(result.b1);
  return std::max(result.min_distance, 0.0) + kPoint;
}

size_t ball_triangles(const drape_query* query, const double* at, double radius, int* triangle,
                      size_t capacity) {
  const Ball ball(radius);
  const Solver solver;
  const fcl::CollisionRequest<double> request(size_t(query->tree.num_tris), false);
  fcl::CollisionResult<double> result;
  fcl::detail::MeshShapeCollisionTraversalNodeOBBRSS<Ball, Solver> node;
  initialize(node, query->tree, Transform::Identity(), ball, transform_of(at), &solver, request, result);
  fcl::detail::collisionRecurse<double>(&node, 0, 0, nullptr);
  const size_t count = result.numContacts();
  for (size_t k = 0; k < std::min(count, capacity); ++k) triangle[k] = int(result.getContact(k).b1);
  std::sort(triangle, triangle + std::min(count, capacity));
  return count;
}

double distance(const drape_query* query, const double* at, int* triangle) noexcept {
  try {
    return distance_to(query, at, triangle);
  } catch (...) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

size_t within(const drape_query* query, const double* at, double radius, int* triangle,
              size_t capacity) noexcept {
  try {
    return ball_triangles(query, at, radius, triangle, capacity);
  } catch (...) {
    return SIZE_MAX;
  }
}

}  // namespace

const drape_contact_library* drape_contact_library_2() noexcept {
  static const drape_contact_library library{
      drape::body::mesh_read, drape::body::mesh_free, query_make, query_free, distance, within};
  return &library;
}
