// One hash for every instruction set with fused multiply-add, every number of threads and every machine.
#include <gtest/gtest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdio>

#include "cloth_fixture.h"
#include "cut_pieces.h"

namespace drape::dynamics {

using namespace tests;
namespace {

constexpr int kSteps = 200;
constexpr double kStep = 1e-5;  // s
constexpr std::uint64_t kGolden = 1263720844775631442;

// Curved laws, different rigidities, slits, air, damping along the springs: every stage of the kernel. The
// scene needs no sine and no power, which libraries round differently.
Assembled cloth_of(const char* kernel, int threads) {
  scene::FabricSpec fabric = reference::curved_fabric();
  fabric.damping = 1e-5;
  Scene scene = cut_piece(fabric, Shape::kSlits);
  scene.clamp_correction = false;
  scene.has_air = true;
  scene.air_normal = 1.2;
  scene.air_tangential = 0.1;
  scene.damping = 2;
  Assembled a = assemble(scene);
  a.motion.kernel = kernel_named(kernel);
  a.motion.workspace = workspace_make(a.system, threads);
  std::uint64_t random = 1;
  for (std::size_t n : a.system.particle)
    for (Array* r : {&a.state.x, &a.state.y, &a.state.z}) {
      random = 6364136223846793005u * random + 1442695040888963407u;
      (*r)[n] += 0.003 * (double(random >> 11) * 0x1p-53 - 0.5);
    }
  return a;
}

Eigen::VectorXd moved(const char* kernel, int threads, int rounding = FE_TONEAREST) {
  Assembled a = cloth_of(kernel, threads);
  std::fesetround(rounding);
  for (int k = 0; k < kSteps; ++k) leapfrog_step(a.system, a.motion, a.state, kStep);
  std::fesetround(FE_TONEAREST);
  return positions(a);
}

std::uint64_t hash(const Eigen::VectorXd& v) {  // the FNV hash of Fowler, Noll and Vo, of whole numbers
  std::uint64_t h = 14695981039346656037u;
  for (double x : v) h = (h ^ std::bit_cast<std::uint64_t>(x)) * 1099511628211u;
  return h;
}

TEST(Golden, OneHashForAllFusedKernelsAndThreads) {
  int seen = 0;
  for (const char* kernel : {"scalar", "avx2", "avx512"}) {
    if (!kernel_named(kernel)) continue;
    for (int threads = 1; threads <= 3; ++threads, ++seen)
      EXPECT_EQ(hash(moved(kernel, threads)), kGolden) << kernel << ", " << threads << " threads";
  }
  if (!seen) GTEST_SKIP() << "this processor has no AVX2 with FMA";
}

// A master may have set another rounding mode: every lane and thread uses it alike.
TEST(Golden, LanesAndThreadsRoundAlikeInEveryMode) {
  if (!kernel_named("scalar")) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  const std::uint64_t nearest = hash(moved("scalar", 1));
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const std::uint64_t expected = hash(moved("scalar", 1, mode));
    EXPECT_NE(expected, nearest);
    for (const char* kernel : {"avx2", "avx512"}) {
      if (!kernel_named(kernel)) continue;
      for (int threads : {1, 3})
        EXPECT_EQ(hash(moved(kernel, threads, mode)), expected) << kernel << ", mode " << mode;
    }
  }
}

// Each step rounds coordinates of 0.1 m by 1e-17 m, and the laws by some ten times as much. 200 steps of the
// stiffest motion add that up, with a growth of at most the square of their number: 200^2/2 x 1e-16 m =
// 2e-12 m.
TEST(Golden, ThePortableKernelIsWithinRounding) {
  if (!kernel_named("scalar")) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  const double off = (moved("portable", 1) - moved("scalar", 1)).lpNorm<Eigen::Infinity>();
  std::printf("portable: %.1e m off after %d steps\n", off, kSteps);
  EXPECT_LE(off, 2e-12);
  EXPECT_GT(off, 0);
}

}  // namespace
}  // namespace drape::dynamics
