// Which edges and tips of bodies are sharp, and the distance of cloth from them. core/README.md, section 7.
#include "body/sharp_edges.h"

#include <gtest/gtest.h>

#include <random>

#include "body_fixture.h"
#include "contact/edge/gap.h"
#include "math/vector3.h"

namespace drape::body {

using namespace tests;
namespace {

using namespace math::vector3;

BodySurface surface_of(const Mesh& mesh) {
  SurfaceFindings findings;
  std::string problem;
  return surface_make(mesh.point, mesh.corner, findings, problem);
}

std::array<int, 2> edges_and_tips(const Mesh& mesh) {
  std::array<int, 2> count{};
  for (const SharpFeature& r : sharp_features_make(surface_of(mesh), {}, 0.01).feature) ++count[r.tip];
  return count;
}

TEST(SharpEdges, AreTheSharpEdgesAndTipsOfABody) {
  EXPECT_EQ(edges_and_tips(box(1, 2, 3)), (std::array<int, 2>{12, 8}));
  EXPECT_EQ(edges_and_tips(ball(0.05, 100)), (std::array<int, 2>{0, 0}));
  EXPECT_EQ(edges_and_tips(cylinder(0.05, 0.1, 720)), (std::array<int, 2>{1440, 0}));  // its rims
  const Mesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(edges_and_tips(sheet), (std::array<int, 2>{4, 4}));
  const Mesh groove{{{-1, 0, 1}, {0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {0, 1, 0}, {1, 1, 1}},
                    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};  // from below it is a convex edge
  EXPECT_EQ(edges_and_tips(groove)[0], 7);
  Mesh dented = box(1, 1, 1);  // a pit in the top is no tip
  dented.point.push_back({0, 0, 0});
  std::erase_if(dented.corner, [&](const std::array<int, 3>& c) {
    return dented.point[std::size_t(c[0])][2] > 0 && dented.point[std::size_t(c[1])][2] > 0 &&
           dented.point[std::size_t(c[2])][2] > 0;
  });
  for (const std::array<int, 2>& side : {std::array<int, 2>{1, 5}, {5, 7}, {7, 3}, {3, 1}})
    dented.corner.push_back({side[0], side[1], 8});
  ASSERT_TRUE(surface_of(dented).solid);
  EXPECT_EQ(edges_and_tips(dented), (std::array<int, 2>{12, 8}));
}

// What is smaller than a link has edges and tips everywhere, however finely it is triangulated; on larger
// bodies triangles know how deep a link sinks in: by b^2/(8 R).
TEST(SharpEdges, AreAllOfBodiesSmallerThanALink) {
  const double half = 0.005, sink = 0.0003;
  const SharpBounds bounds{kSharpSine, half, sink, true, 1e-5, 4 * half};
  const auto features = [&](const Mesh& mesh) { return sharp_features_make(surface_of(mesh), bounds, 0.01); };
  const SharpFeatures rod = features(cylinder(0.0015, 0.1, 200));
  EXPECT_EQ(
      std::count_if(rod.feature.begin(), rod.feature.end(),
                    [](const SharpFeature& f) { return !f.tip && std::abs(f.to[1] - f.from[1]) > 0.09; }),
      200);
  EXPECT_TRUE(rod.narrow);
  const SharpFeatures bead = features(ball(0.001, 40));
  EXPECT_EQ(
      std::count_if(bead.feature.begin(), bead.feature.end(), [](const SharpFeature& f) { return f.tip; }),
      2 + 39 * 40);
  const double radius = 0.05;
  const SharpFeatures large = features(ball(radius, 200));
  EXPECT_TRUE(large.feature.empty());
  ASSERT_FALSE(large.sink.empty());
  const double deepest = *std::max_element(large.sink.begin(), large.sink.end());
  EXPECT_NEAR(deepest, half * half / (2 * radius), 0.1 * deepest);
}

// The faces of a bar are as long as they are, into however many triangles they are cut.
TEST(SharpEdges, FacesGoOnOverTheirTriangles) {
  for (const int parts : {1, 7}) {
    Mesh bar;  // along y, 6 by 4 mm, its sides cut along y
    for (int k = 0; k <= parts; ++k)
      for (const Vec3& p :
           {Vec3{-0.003, 0, -0.002}, {0.003, 0, -0.002}, {0.003, 0, 0.002}, {-0.003, 0, 0.002}})
        bar.point.push_back(p + Vec3{0, 0.1 * k / parts, 0});
    for (int k = 0; k < parts; ++k)
      for (int i = 0; i < 4; ++i) {
        const int a = 4 * k + i, b = 4 * k + (i + 1) % 4;
        bar.corner.push_back({a, b + 4, b}), bar.corner.push_back({a, a + 4, b + 4});
      }
    bar.corner.insert(bar.corner.end(), {{0, 1, 2}, {0, 2, 3}});
    const int end = 4 * parts;
    bar.corner.insert(bar.corner.end(), {{end, end + 2, end + 1}, {end, end + 3, end + 2}});
    ASSERT_TRUE(surface_of(bar).solid);
    const SharpFeatures features =
        sharp_features_make(surface_of(bar), {kSharpSine, 0.005, 3e-4, true, 1e-5, 0.02}, 0.01);
    int along = 0;
    for (const SharpFeature& f : features.feature) {
      if (f.tip || std::abs(f.to[1] - f.from[1]) < 1e-3) continue;
      ++along;
      ASSERT_EQ(f.length.size(), 2u);
      EXPECT_NEAR(std::min(f.length[0], f.length[1]), 0.004, 1e-9);
      EXPECT_NEAR(std::max(f.length[0], f.length[1]), 0.006, 1e-9);
      EXPECT_NEAR(f.turn, 1, 1e-9);
    }
    EXPECT_EQ(along, 4 * parts);
  }
}

// The search in buckets finds what a comparison with all features finds.
TEST(SharpEdges, SearchFindsTheNearest) {
  const Mesh mesh = box(0.3, 0.2, 0.1);
  const BodySurface surface = surface_of(mesh);
  const SharpFeatures features = sharp_features_make(surface, {}, 0.02);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(-0.2, 0.2);
  std::vector<std::uint32_t> found;
  for (int k = 0; k < 200; ++k) {
    const Vec3 x{at(random), at(random), at(random)};
    double smallest = 0.05;
    for (const SharpFeature& r : features.feature)
      for (int p = 0; p <= 2000; ++p)
        smallest = std::min(smallest, norm(x - r.from - (p / 2000.0) * (r.to - r.from)));
    EXPECT_NEAR(sharp_features_distance(features, x, 0.05, found), smallest, 1e-5);
  }
}

// d is the distance of the elements while they are apart, and grows below 0 as they pass through: D.n by
// differences of the nodes' positions, W = dd/dr_k . n.
// A search visits at most as many buckets as there are entries: a box of 1e18 m holds 1e60 buckets.
TEST(SharpEdges, SearchInABoxOfAnySizeFindsWhatLiesInIt) {
  const SharpFeatures features = sharp_features_make(surface_of(box(0.3, 0.2, 0.1)), {}, 0.02);
  std::vector<std::uint32_t> all(features.feature.size()), upper, found;
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    all[k] = k;
    const SharpFeature& f = features.feature[k];
    if (std::max(f.from[2], f.to[2]) > 0.04) upper.push_back(k);
  }
  ASSERT_EQ(all.size(), 20u);
  ASSERT_EQ(upper.size(), 12u);
  for (const double far : {0.2, 10.0, 1e6, 1e18, 1e300}) {
    sharp_features_in(features, {-far, -far, -far}, {far, far, far}, found);
    EXPECT_EQ(found, all) << far;
    sharp_features_in(features, {-far, -far, 0.04}, {far, far, far}, found);
    EXPECT_EQ(found, upper) << far;
    sharp_features_in(features, {-far, -far, 0.1}, {far, far, far}, found);
    EXPECT_TRUE(found.empty()) << far;
  }
}

TEST(SharpEdges, WeightsAreTheGradientOfTheDistance) {
  const SharpFeatures edges = sharp_features_make(surface_of(roof(0.7)), {}, 0.1),
                      tips = sharp_features_make(surface_of(pyramid(0.7)), {}, 0.1);
  const SharpFeature *edge = nullptr, *tip = nullptr;
  for (const SharpFeature& r : edges.feature)
    if (!r.tip && r.from[2] == 0 && r.to[2] == 0) edge = &r;
  for (const SharpFeature& r : tips.feature)
    if (r.tip && r.from[2] == 0) tip = &r;
  ASSERT_TRUE(edge && tip);
  const double sine = 0.01, h = 1e-7;
  for (const double z : {0.002, -0.002}) {
    Vec3 x[6] = {{-0.004, -0.003, z},
                 {0.006, -0.004, z + 1e-3},
                 {-0.005, 0.006, z + 2e-4},
                 {0.006, 0.007, z - 3e-4},
                 {0, 0, 0},
                 {0, 0, 0}};
    const auto check = [&](const char* what, int nodes, auto gap_of) {
      const contact::EdgeGap gap = gap_of(x);
      ASSERT_TRUE(gap.over) << what;
      EXPECT_EQ(gap.distance > 0, z > 0) << what;
      EXPECT_NEAR(gap.clearance, std::abs(gap.distance), 1e-12) << what;
      for (int k = 0; k < nodes; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
          const double was = x[k][i];
          x[k][i] = was + h;
          const double more = gap_of(x).distance;
          x[k][i] = was - h;
          const double less = gap_of(x).distance;
          x[k][i] = was;
          EXPECT_NEAR((more - less) / (2 * h), gap.weight[k] * gap.n[i], 1e-6) << what << k << i;
        }
    };
    check("link on edge", 2, [&](const Vec3* at) { return contact::gap_link_edge(*edge, at, sine); });
    check("cell on tip", 4, [&](const Vec3* at) { return contact::gap_cell_tip(*tip, at, sine); });
    const Vec3 beyond[1][2] = {{{-0.004, 0.006, z + 0.009}, {0.006, 0.006, z + 0.009}}};
    check("link on tip", 2, [&](const Vec3* at) {
      const Vec3 end[2] = {at[0] + Vec3{0, 0.0028, 0}, at[1] + Vec3{0, 0.0028, 0}};
      return contact::gap_link_tip(*tip, end, beyond, 1, sine);
    });
  }
}

}  // namespace
}  // namespace drape::body
