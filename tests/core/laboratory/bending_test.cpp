// Bending tests on simulated cloth, evaluated by the heavy elastica. Equations: core/README.md, section 5.
#include "laboratory/bending.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "reference/test_cloth.h"

namespace drape::laboratory {
namespace {

scene::FabricSpec strip_fabric() {
  scene::FabricSpec f = reference::threads(2000);
  f.weft = reference::straight(1500);
  f.areal_density = 0.12;
  f.bending_warp = 9e-6;
  f.bending_weft = 5e-6;
  return f;
}

// Both tests on the mesh and on one of half the cell: order 2 towards B. The order of the sequence itself is
// 2, that of hinges at the clamp, within 0.3 since the meshes are coarse.
TEST(BendingTests, ReadAlikeWithDamping) {
  scene::FabricSpec f = strip_fabric();
  std::vector<Problem> problems;
  const BendingTest without = pt2_test(f, true, 0.005, problems);
  f.damping = 1e-5;
  const BendingTest with = pt2_test(f, true, 0.005, problems);
  EXPECT_TRUE(with.found && problems.empty());
  EXPECT_EQ(with.reading, without.reading);
}

TEST(BendingTests, GiveBackTheRigidityWithOrderTwo) {
  const scene::FabricSpec f = strip_fabric();
  std::vector<Problem> problems;
  for (bool warp : {true, false}) {
    const double b = warp ? f.bending_warp : f.bending_weft;
    double off[2][2]{};
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
}  // namespace drape::laboratory
