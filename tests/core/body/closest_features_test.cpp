// The closest features of a mesh against a search through all its triangles.
#include "body/closest_features.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>
#include <random>

#include "assembly/bodies.h"
#include "body_fixture.h"
#include "contact/particle/update_neighbours.h"
#include "math/vector3.h"

namespace drape::body {

using namespace tests;
namespace {

using namespace math::vector3;

model::Body body_of(const SceneFolder& folder, const Mesh& mesh) {
  Scene scene;
  body_add(scene, folder, "body", mesh);
  std::vector<Problem> problems;
  std::vector<model::Body> bodies = assembly::bodies_make(scene, problems);
  for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
  return std::move(bodies.at(0));
}

// The distance to a segment or triangle by projection and clamping, region by region.
double segment_distance(const Vec3& a, const Vec3& b, const Vec3& x) {
  const double t = std::clamp(dot(x - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return norm(x - (a + t * (b - a)));
}
double triangle_distance(const BodySurface& s, std::size_t t, const Vec3& x) {
  const Vec3 &a = s.point[std::size_t(s.corner[t][0])], &b = s.point[std::size_t(s.corner[t][1])],
             &c = s.point[std::size_t(s.corner[t][2])];
  const Vec3 n = cross(b - a, c - a);
  const auto left = [&](const Vec3& p, const Vec3& q) { return dot(cross(q - p, x - p), n) >= 0; };
  if (left(a, b) && left(b, c) && left(c, a)) return std::abs(dot(x - a, n)) / norm(n);
  return std::min({segment_distance(a, b, x), segment_distance(b, c, x), segment_distance(c, a, x)});
}
double mesh_distance(const BodySurface& s, const Vec3& x) {
  double smallest = INFINITY;
  for (std::size_t t = 0; t < s.corner.size(); ++t) smallest = std::min(smallest, triangle_distance(s, t, x));
  return smallest;
}

TEST(ClosestFeatures, IsTheNearestOfAllTrianglesAndItsFreeDistanceHolds) {
  const SceneFolder folder;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1, 1);
  for (const Mesh& mesh : {ball(0.1, 16), box(0.2, 0.1, 0.01), cylinder(0.05, 0.2, 12)}) {
    const model::Body body = body_of(folder, mesh);
    const double contact = 0.001, reach = contact::search_reach(body.mesh.surface, contact);
    DistanceGrid voxels = distance_grid_make(*body.mesh.library, *body.mesh.query, body.mesh.surface, reach);
    int touched = 0;
    for (int k = 0; k < 4000; ++k) {
      const std::size_t t = std::size_t(random()) % body.mesh.surface.corner.size();
      const double far = k % 4 == 0 ? 0.05 : 0.002;
      Vec3 x = body.mesh.surface.facet[t].middle;
      for (double& v : x) v += far * shift(random);
      const double exact = mesh_distance(body.mesh.surface, x);
      const Neighbourhood near = distance_grid_at(voxels, x);
      ClosestFeatures found;
      ClosestFeaturesScratch scratch;
      if (!near.triangle) {
        EXPECT_LE(near.clearance, exact + 1e-12);
        EXPECT_GT(near.clearance, contact);
        continue;
      }
      closest_features_find(body.mesh.surface, *near.triangle,
                            {x, contact, 3 * contact, reach, near.listed, nullptr}, scratch, found);
      if (exact > 3 * contact) {
        EXPECT_TRUE(found.feature.empty());
        EXPECT_LE(found.free_distance, exact - contact + 1e-12);
        EXPECT_GT(found.free_distance, 0);
      } else {
        ASSERT_FALSE(found.feature.empty());
        ++touched;
        EXPECT_NEAR(std::abs(found.feature[0].distance), exact, 1e-12);
      }
      if (found.feature.size() != 1 || found.feature[0].distance < 0 || found.free_distance <= 0) continue;
      // Wherever the particle moves within its free distance, the same feature gives the distance, if it is
      // within reach.
      for (int m = 0; m < 4; ++m) {
        Vec3 step{shift(random), shift(random), shift(random)};
        const Vec3 there = x + (0.999 * found.free_distance * std::abs(shift(random)) / norm(step)) * step;
        const auto& d = found.feature[0].shape;
        const Vec3 e = there - found.feature[0].point;
        if (dot(e, found.feature[0].side) < 0) continue;  // inside: deeper than the response allows
        const double reported =
            norm({d[0] * e[0] + d[1] * e[1] + d[2] * e[2], d[1] * e[0] + d[3] * e[1] + d[4] * e[2],
                  d[2] * e[0] + d[4] * e[1] + d[5] * e[2]});
        const double now = mesh_distance(body.mesh.surface, there);
        if (now < contact) EXPECT_NEAR(reported, now, 0.0201 * contact);
        else EXPECT_GE(reported, contact * 0.98);
      }
    }
    EXPECT_GT(touched, 500);
  }
}

// A fin of one triangle on a ball, without a back, makes no inside behind it.
TEST(ClosestFeatures, AFewBadEdgesMakeNoInside) {
  const SceneFolder folder;
  Mesh mesh = ball(0.1, 16);
  const int tip = int(mesh.point.size()), a = mesh.corner[200][0], b = mesh.corner[200][1];
  mesh.point.push_back(1.6 * mesh.point[std::size_t(a)]);
  mesh.corner.push_back({a, b, tip});
  const model::Body body = body_of(folder, mesh);
  const BodySurface& surface = body.mesh.surface;
  ASSERT_TRUE(surface.solid);
  DistanceGrid voxels = distance_grid_make(*body.mesh.library, *body.mesh.query, surface, 0.002);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 beside = surface.facet.back().middle + 0.02 * side * surface.facet.back().normal;
    EXPECT_EQ(distance_grid_depth(voxels, beside), 0) << side;
  }
  EXPECT_NEAR(distance_grid_depth(voxels, {0, 0, 0}), 0.1 * std::cos(std::numbers::pi / 16), 0.002);
}

// One minimum over a convex edge, two in a groove, and one sign for each side.
TEST(ClosestFeatures, CountsLocalMinima) {
  const SceneFolder folder;
  Mesh groove;  // two planes that meet at a right angle along x, open upwards; a sheet
  groove.point = {{-1, 0, 0}, {1, 0, 0}, {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}};
  groove.corner = {{0, 1, 2}, {0, 2, 3}, {1, 0, 5}, {1, 5, 4}};
  const model::Body body = body_of(folder, groove);
  EXPECT_FALSE(body.mesh.surface.solid);
  const std::vector<int> all{0, 1, 2, 3};
  ClosestFeatures found;
  ClosestFeaturesScratch scratch;
  closest_features_find(body.mesh.surface, all, {{0, 0, 0.01}, 0.01, 0.02, 1, 1, nullptr}, scratch, found);
  ASSERT_EQ(found.feature.size(), 2u);
  for (const ClosestFeature& t : found.feature) {
    EXPECT_NEAR(t.distance, 0.01 / std::numbers::sqrt2, 1e-15);
    EXPECT_GT(t.side[2], 0);
  }
  closest_features_find(body.mesh.surface, all, {{0, 0, -0.01}, 0.01, 0.02, 1, 1, nullptr}, scratch, found);
  ASSERT_EQ(found.feature.size(), 1u);
  EXPECT_NEAR(found.feature[0].distance, 0.01, 1e-15);
  EXPECT_LT(found.feature[0].side[2], 0);
}

// Over the diagonals of a box's top, one of which is an edge of its triangles.
TEST(ClosestFeatures, AnEdgeWithinAPlaneIsAFace) {
  const SceneFolder folder;
  const model::Body body = body_of(folder, box(0.2, 0.1, 0.01));
  const BodySurface& surface = body.mesh.surface;
  std::vector<int> all(surface.corner.size());
  std::iota(all.begin(), all.end(), 0);
  ClosestFeaturesScratch scratch;
  ClosestFeatures found;
  for (double share : {-0.9, -0.31, 0.0, 0.5, 0.77})
    for (double across : {-1.0, 1.0}) {
      const Vec3 x{0.1 * share, 0.05 * share * across, 0.0055};
      closest_features_find(surface, all, {x, 0.001, 0.001, 0.002, 1.0, nullptr}, scratch, found);
      ASSERT_EQ(found.feature.size(), 1u);
      const ClosestFeature& face = found.feature[0];
      EXPECT_EQ(face.side, (Vec3{0, 0, 1}));
      EXPECT_EQ(face.shape, (std::array<double, 6>{0, 0, 0, 0, 0, 1}));
      EXPECT_NEAR(face.distance, 0.0005, 1e-15);
    }
}

}  // namespace
}  // namespace drape::body
