// Rows shared out to threads: the same bits as from one.
#include "dynamics/kernel/row_blocks.h"

#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "cut_pieces.h"

namespace drape::dynamics {

using namespace tests;
namespace {

struct Cloth {
  const char* name;
  bool curved, bending, air;
  double springs;  // s, damping along them
};
const Cloth kCloths[] = {{"plain", false, false, false, 0},
                         {"hinges", false, true, false, 0},
                         {"tables_and_hinges", true, true, false, 0},
                         {"air", false, false, true, 0},
                         {"everything", true, true, true, 1e-5}};

// Two pieces, one of them with twins.
Scene scene_of(const Cloth& cloth, Shape shape) {
  scene::FabricSpec fabric = reference::curved_fabric();
  if (!cloth.curved) fabric.warp = fabric.weft = fabric.bias = reference::diagram({0, 0.1}, {0, 0.5});
  if (!cloth.bending) fabric.bending_warp = fabric.bending_weft = 0;
  fabric.damping = cloth.springs;
  Scene scene = cut_piece(fabric, shape);
  scene.has_air = cloth.air;
  scene.air_normal = cloth.air ? 1.2 : 0;
  scene::PieceSpec second = cut_piece(fabric, Shape::kRectangle).pieces[0];
  second.name = "second";
  scene.pieces.push_back(second);
  return scene;
}

State moved(const Scene& scene, int threads) {
  Assembled a = assemble(scene);
  a.motion.workspace = workspace_make(a.system, threads);
  crumple(a, 0.001, 3);
  for (int k = 0; k < 50; ++k) leapfrog_step(a.system, a.motion, a.state, 1e-5);
  return a.state;
}

class RowBlocks : public testing::TestWithParam<Cloth> {};
INSTANTIATE_TEST_SUITE_P(Cloths, RowBlocks, testing::ValuesIn(kCloths),
                         [](const auto& cloth) { return cloth.param.name; });

TEST_P(RowBlocks, GiveTheBitsOfOneThread) {
  for (const Shape shape : {Shape::kRectangle, Shape::kDiscWithHole, Shape::kSlits}) {
    const Scene scene = scene_of(GetParam(), shape);
    const State one = moved(scene, 1);
    for (int threads = 2; threads <= 7; ++threads) {
      const State s = moved(scene, threads);
      EXPECT_EQ(s.x, one.x) << threads;
      EXPECT_EQ(s.vz, one.vz) << threads;
    }
  }
}

// Every row in one block, whatever the threads.
TEST(RowBlocks, CoverEveryRowOnce) {
  Assembled a = assemble(scene_of(kCloths[0], Shape::kSlits));
  for (int threads = 1; threads <= 40; ++threads) {
    std::vector<std::vector<int>> times;
    for (const model::Lattice& l : a.system.lattices) times.emplace_back(l.rows, 0);
    for (const ThreadWorkspace& workspace : workspace_make(a.system, threads).threads)
      for (const RowBlock& block : workspace.blocks)
        for (int j = block.begin; j < block.end; ++j) ++times[std::size_t(block.lattice)][std::size_t(j)];
    for (const std::vector<int>& rows : times)
      for (int n : rows) EXPECT_EQ(n, 1) << threads;
  }
}

TEST(RowBlocks, AreNoMoreThanPay) {
  Assembled a = assemble(scene_of(kCloths[0], Shape::kSlits));
  a.system.threads = 8;
  EXPECT_EQ(threads_wanted(a.system), 1);
  Scene scene = scene_of(kCloths[0], Shape::kRectangle);
  scene.pieces[0].outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Assembled large = assemble(scene);
  EXPECT_EQ(threads_wanted(large.system), 1);
  large.system.threads = 3;
  EXPECT_EQ(threads_wanted(large.system), 3);
}

}  // namespace
}  // namespace drape::dynamics
