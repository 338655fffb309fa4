// The damping of a fit is measured within one system. core/README.md, section 4.
#include <gtest/gtest.h>

#include <cmath>

#include "cloth_fixture.h"
#include "dynamics/relaxation.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// A stretched sheet that has nearly come to rest, whose fabric then stiffens by half: over the jump the
// forces change along the way, as if the stiffness were below 0. The damping stays that of before until a way
// has been measured in the new system, in which no way is without stiffness: then 0 < c < 2 omega of the
// bound.
TEST(RelaxationDamping, IsMeasuredWithinOneSystem) {
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01, true);
  scene.mode = scene::Mode::kFit;
  scene.pins = {reference::pin_edges("bar", {2}), reference::pin_edges("foot", {0})};
  scene.pins[0].drive = scene::Drive::kPosition;
  Assembled a = assemble(scene);
  a.motion.inputs.pin[0].position[2] += 0.002;
  advance(a, 0.01);
  while (a.state.relaxation.residual > 1e-3) advance(a, 1e-3);
  const double before = a.state.relaxation.damping;
  ASSERT_GT(before, 0);
  std::vector<scene::FabricSpec> fabrics = scene.fabrics;
  fabrics[0].warp = fabrics[0].weft = reference::straight(3000);
  std::vector<Problem> problems;
  leapfrog_complete(a.system, a.motion, a.state);
  assembly::system_retune(a.system, fabrics, problems);
  ASSERT_TRUE(problems.empty());
  leapfrog_retuned(a.system, a.motion, a.state);
  const std::int64_t retuned = a.state.steps;
  const double h = a.system.communication / double(a.state.steps_per_interval);
  bool anew = false;
  for (int k = 0; k < 200 && !anew; ++k) {
    leapfrog_step(a.system, a.motion, a.state, h);
    if (--a.state.steps_to_limit_check <= 0) relaxation_update(a.system, a.motion, a.state, h);
    anew = a.state.relaxation.damping != before;
    if (a.state.steps < retuned + 16) {
      EXPECT_EQ(a.state.relaxation.damping, before);
    }
  }
  EXPECT_TRUE(anew);
  EXPECT_GT(a.state.relaxation.damping, 0);
  EXPECT_LT(a.state.relaxation.damping, 2 * std::sqrt(a.state.omega2));
}

// A start has a damping after the first 16 steps; before, none.
TEST(RelaxationDamping, BeginsWithinSixteenSteps) {
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01, true);
  scene.mode = scene::Mode::kFit;
  scene.pins = {reference::pin_edges("bar", {2})};
  Assembled a = assemble(scene);
  std::string event;
  std::int64_t measured = 0;
  while (a.state.relaxation.damping == 0 && a.state.steps < 1000) {
    ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state,
                               a.system.communication / double(a.state.steps_per_interval), event),
              Advance::kDone);
    measured = a.state.steps;
  }
  EXPECT_GE(measured, 16);
  EXPECT_LE(measured, 33);
}

}  // namespace
}  // namespace drape::dynamics
