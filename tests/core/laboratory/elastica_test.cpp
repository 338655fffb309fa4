// The heavy elastica and the bending tests that are read by it. Equations: core/README.md, section 5.
#include "laboratory/elastica.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "laboratory/bending.h"
#include "reference/test_cloth.h"

namespace drape {
namespace {

// Small loads: f/l = beta/8, the beam's; the next term is of order beta^3.
TEST(Elastica, IsTheBeamAtSmallLoads) { EXPECT_NEAR(elastica_of_load(1e-3).down / (1e-3 / 8), 1, 1e-6); }

// The overhang of 65 mm with EI = 1370 uN cm2 on 30 mm; g/m2 -> drop and tip in mm.
TEST(Elastica, GivesTheOverhangOfTheBendingTest) {
  for (const auto& [grams, down, out] :
       {std::array{100.0, 59.561, 14.32}, std::array{120.0, 60.092, 12.77}, std::array{150.0, 60.660, 11.14},
        std::array{180.0, 61.068, 9.99}, std::array{200.0, 61.284, 9.40}}) {
    const Elastica e = elastica_of_load(1e-3 * grams * 9.81 * std::pow(0.065, 3) / (1370e-10 / 0.03));
    EXPECT_NEAR(65 * e.down, down, 1.1e-3);
    EXPECT_NEAR(65 * e.out, out, 0.011);
  }
}

TEST(Elastica, IsFoundByLoadDropAndSlope) {
  for (double beta : {0.01, 1.0, 8.0, 40.0, 1000.0}) {
    const Elastica e = elastica_of_load(beta);
    EXPECT_NEAR(e.beta / beta, 1, 1e-9);
    EXPECT_NEAR(elastica_of_drop(e.down).beta / beta, 1, 1e-7);
    EXPECT_NEAR(elastica_of_slope(std::atan2(e.down, e.out)).beta / beta, 1, 1e-7);
    const std::vector<Vec2> shape = elastica_shape(beta, 50);
    EXPECT_NEAR(shape[50][0], e.out, 1e-9);
    EXPECT_NEAR(shape[50][1], e.down, 1e-9);
    EXPECT_EQ(shape[0], (Vec2{0, 0}));
  }
  EXPECT_NEAR(elastica_of_slope(41.5 * std::numbers::pi / 180).beta, 8.004, 5e-4);
}

// GOST 10550: A of a report by the standard at f0 = 0.7929 is 15.63, and 42046 = g l^3/(5 x 0.16 m) in uN
// cm2/g.
TEST(Elastica, IsTheFormulaOfTheBendingTest) {
  EXPECT_NEAR(elastica_of_drop(0.7929).beta / 15.63, 1, 0.002);
  EXPECT_NEAR(kStandardGravity * std::pow(kWing, 3) / (5 * 0.16) * 1e-3 * 1e10, 42046, 0.5);
}

FabricSpec strip_fabric() {
  FabricSpec f = reference::threads(2000);
  f.weft = reference::straight(1500);
  f.areal_density = 0.12;
  f.bending_warp = 9e-6;
  f.bending_weft = 5e-6;
  return f;
}

// Both tests on the mesh and on one of half the cell: of order 2 towards B. The order of the sequence itself
// is that of hinges at the clamp, 2, to 0.3 as the meshes are coarse.
TEST(BendingTests, GiveBackTheRigidityWithOrderTwo) {
  const FabricSpec f = strip_fabric();
  std::vector<Problem> problems;
  for (bool warp : {true, false}) {
    const double b = warp ? f.bending_warp : f.bending_weft;
    double off[2][2];
    for (int k : {0, 1}) {
      const BendingTest drop = pt2_test(f, warp, k ? 0.0025 : 0.005, problems),
                        length = overhang_test(f, warp, k ? 24 : 12, problems);
      ASSERT_TRUE(drop.found && length.found && problems.empty());
      EXPECT_NEAR(drop.reading / drop.expected, 1, k ? 0.0025 : 0.01);
      off[0][k] = std::abs(drop.reading - drop.expected) / kWing;
      off[1][k] = std::abs(length.rigidity / b - 1);
    }
    std::printf("%s: PT-2 drop %.1e of l off, order %.2f; EI by the bending length %.1e off, order %.2f\n",
                warp ? "warp" : "weft", off[0][1], std::log2(off[0][0] / off[0][1]), off[1][1],
                std::log2(off[1][0] / off[1][1]));
    EXPECT_NEAR(std::log2(off[0][0] / off[0][1]), 2, 0.3);
    EXPECT_LE(off[1][1], 0.01);
  }
}

}  // namespace
}  // namespace drape
