// How the automatic step follows a motion. core/README.md, section 4, "Step".
#include <gtest/gtest.h>

#include <cmath>

#include "cloth_fixture.h"
#include "dynamics/potential_energy.h"
#include "dynamics/step_size/step_limit.h"
#include "model/kinetic_energy.h"
#include "validation/load.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// Whatever made the step short has gone: after 50 intervals, or sooner after 20,000 steps, it is as long as
// before. Damped cloth in free fall is calm.
TEST(Leapfrog, GivesAShortStepBack) {
  for (const auto& [factor, intervals] : {std::pair{8, 50}, std::pair{20000, 1}}) {
    Scene scene = reference::rectangle(reference::curved_fabric(), 0.05, 0.03, 0.01);
    scene.damping = 5;
    Assembled a = assemble(scene);
    std::string event;
    const std::int64_t start = a.state.steps_per_interval;
    ASSERT_EQ(start * factor * intervals >= 20000, intervals == 1);
    a.state.steps_per_interval *= factor;
    for (int k = 0; k < intervals; ++k) {
      EXPECT_EQ(a.state.steps_per_interval, start * factor) << k;
      ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 0.001, event), Advance::kDone);
    }
    ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 0.001, event), Advance::kDone);
    EXPECT_EQ(a.state.steps_per_interval, start);
  }
}

// Undamped cloth starts with 0.4 of the limit. Calm, it takes 0.7 after 50 intervals.
TEST(Leapfrog, TakesLongerStepsOnceCalm) {
  Assembled a = assemble(reference::rectangle(reference::curved_fabric(), 0.05, 0.03, 0.01));
  const double limit = step_limit_of(a.system, a.state.omega2), q = a.system.communication;
  std::string event;
  EXPECT_EQ(a.state.steps_per_interval, std::int64_t(std::ceil(q / (0.4 * limit))));
  for (int k = 0; k < 51; ++k)
    ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, q, event), Advance::kDone);
  EXPECT_EQ(a.state.steps_per_interval, std::int64_t(std::ceil(q / (0.7 * limit))));
}

// The measured wool, undamped, keeps its energy: the automatic step stays far enough below the limit. The
// energy starts at 0, and leapfrog's own ripple is a thousandth of the energies that move; growth would be
// exponential.
TEST(Leapfrog, UndampedWoolKeepsItsEnergy) {
  std::vector<Problem> problems;
  Scene wool;
  const std::string file = std::string(DRAPE_SOURCE_DIR) + "/examples/hanging_wool/scene.toml";
  wool = validation::scene_load(file, problems);
  ASSERT_TRUE(problems.empty());
  Scene scene = reference::rectangle(wool.fabrics[0], 0.22, 0.235, 0.02);
  scene.clamp_correction = false;
  scene.pins = {reference::pin_at("left", {{0.02, 0.235}}), reference::pin_at("right", {{0.2, 0.215}})};
  Assembled a = assemble(scene);
  std::string event;
  double kinetic = 0, worst = 0;
  const double start = dynamics::potential_energy(a.system, a.state).gravity;
  Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
  std::vector<math::Wrench> force;
  for (int call = 0; call < 60; ++call) {
    ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 0.1, event), Advance::kDone);
    leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, force);
    const drape_energy e = dynamics::potential_energy(a.system, a.state);
    const double k = model::kinetic_energy(a.system, vx, vy, vz);
    kinetic = std::max(kinetic, k);
    worst = std::max(worst, std::abs(e.stretch + e.shear + e.bending + e.gravity + k - start));
  }
  std::printf("undamped wool, 6 s: energy off by %.2e of the largest kinetic energy\n", worst / kinetic);
  EXPECT_LE(worst, 0.002 * kinetic);
}

}  // namespace
}  // namespace drape::dynamics
