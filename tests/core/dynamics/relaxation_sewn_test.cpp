// A relaxation that sews: its stages, its inertia that shrinks slowly, its state that continues with the
// same bits. core/README.md, section 4.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "body_fixture.h"
#include "dynamics/relaxation.h"
#include "seam_fixture.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// Two sheets above a box, to be sewn together; one is held at its outer edge.
Scene to_sew(const SceneFolder& folder) {
  Scene scene = reference::rectangle(linen(), 0.05, 0.05, 0.01);
  scene.mode = scene::Mode::kFit;
  scene.pieces[0].place.origin = {0, 0, 0.001};
  scene.pieces.push_back(scene.pieces[0]);
  scene.pieces[1].name = "right";
  scene.pieces[1].place.origin = {0.054, 0.001, 0.003};
  scene.seams = {seam_join()};
  scene.pins = {reference::pin_edges("bar", {3})};
  scene.pins[0].drive = scene::Drive::kPosition;
  body_add(scene, folder, "table", box(0.06, 0.2, 0.2));
  for (scene::PieceSpec& p : scene.pieces) p.place.origin[2] += 0.1;
  return scene;
}

Vec2 friction_of(const Assembled& a) {
  return contact::current_law(a.system, a.state, a.system.bodies[0], a.system.lattices[0]).friction;
}

bool is_sewn(const Assembled& a) { return !seams_to_close(a.system, a.state); }

void sew(Assembled& a) {
  for (int k = 0; k < 2000 && !is_sewn(a); ++k) sewn_advance(a, 1e-3);
  ASSERT_TRUE(is_sewn(a));
}

// While seams are open, gravity and friction are off. Then gravity acts, and friction acts once the residual
// forces have first been measured at 0.1 of the load.
TEST(RelaxationStages, EndsWhenATenthOfTheLoadIsLeft) {
  const SceneFolder folder;
  Assembled a = assemble(to_sew(folder));
  sewn_advance(a, 1e-3);
  EXPECT_EQ(gravity_of(a.system, a.state), (Vec3{0, 0, 0}));
  EXPECT_EQ(friction_of(a), (Vec2{0, 0}));
  sew(a);
  double waited = 0, before = INFINITY;
  while (waited < 1 && friction_of(a)[0] == 0) {
    before = a.state.relaxation.residual;
    sewn_advance(a, 1e-3);
    waited += 1e-3;
    EXPECT_EQ(gravity_of(a.system, a.state), a.system.gravity);
  }
  std::printf("settled after %.3f s: %.3f of the load left, the time before %.3f\n", waited,
              a.state.relaxation.residual, before);
  EXPECT_LT(waited, 0.9);  // ended by the residual, not by the time
  EXPECT_LE(a.state.relaxation.residual, 0.1);
  EXPECT_GT(before, 0.1);
  EXPECT_EQ(friction_of(a), a.system.lattices[0].contact_law.friction);
  crumple(a, 1e-4, 3);  // a stage that has ended does not restart
  sewn_advance(a, 0.01);
  EXPECT_EQ(friction_of(a), a.system.lattices[0].contact_law.friction);
}

// Where the residual does not fall (it is not measured while a pin moves), friction acts 1 s after the last
// seam: later by at most the 16 steps between two checks.
TEST(RelaxationStages, EndsAfterASecondAtTheLatest) {
  const SceneFolder folder;
  Assembled a = assemble(to_sew(folder));
  sew(a);
  const double q = a.system.communication, h = q / double(a.state.steps_per_interval);
  double waited = 0;
  while (waited < 2 && friction_of(a)[0] == 0) {
    a.motion.inputs.pin[0].position[1] += 1e-7;
    sewn_advance(a, q);
    waited += q;
  }
  EXPECT_NEAR(waited, 1, 2 * 16 * h + 2 * q);
}

// An inertia grows at once. From check to check it shrinks by 1 % at most, until it equals the mass.
TEST(RelaxationInertia, ShrinksByAHundredthACheck) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.05, 0.05, 0.01);
  scene.mode = scene::Mode::kFit;
  Assembled a = assemble(scene);
  const double h = kSafety * step_limit_of(a.system, a.state.omega2);
  const Array flat = a.state.y;
  relaxation_scale_masses(a.system, a.motion.constraints, a.state, h);
  for (std::size_t n : a.system.particle) a.state.y[n] *= a.state.y[n] > 0.025 ? 1.3 : 1.0;
  relaxation_scale_masses(a.system, a.motion.constraints, a.state, h);
  Array before = a.state.inverse_mass_scale;
  std::size_t stiffest = a.system.particle[0];
  for (std::size_t n : a.system.particle)
    if (before[n] < before[stiffest]) stiffest = n;
  const double grown = 1 / before[stiffest];
  ASSERT_GT(grown, 2);
  a.state.y = flat;
  const int checks = int(std::ceil(std::log(grown) / -std::log(0.99)));
  for (int k = 1; k < checks; ++k) {
    relaxation_scale_masses(a.system, a.motion.constraints, a.state, h);
    EXPECT_NEAR(before[stiffest] / a.state.inverse_mass_scale[stiffest], 0.99, 1e-12) << k;
    for (std::size_t n : a.system.particle)
      EXPECT_GE(before[n] / a.state.inverse_mass_scale[n], 0.99 * (1 - 1e-12)) << k;
    before = a.state.inverse_mass_scale;
  }
  EXPECT_LT(before[stiffest], 1);
  relaxation_scale_masses(a.system, a.motion.constraints, a.state, h);
  EXPECT_EQ(a.state.inverse_mass_scale[stiffest], 1);
}

// Every grouping of advances gives the same bits: while pairs are pulled, across welds and after.
TEST(RelaxationSewn, BitsAreThoseOfEveryGrouping) {
  const SceneFolder folder;
  const auto run = [&](int advances) {
    Assembled a = assemble(to_sew(folder));
    for (int k = 0; k < advances; ++k) sewn_advance(a, 0.6 / advances);
    EXPECT_TRUE(is_sewn(a));
    return positions(a);
  };
  const Eigen::VectorXd whole = run(1);
  for (int advances : {20, 600}) EXPECT_EQ((run(advances) - whole).cwiseAbs().maxCoeff(), 0) << advances;
}

// A restored state continues with the same bits: saved before the first check, while pairs are pulled, and
// as the cloth comes to rest.
TEST(RelaxationSewn, StateGoesOnAsItWas) {
  const SceneFolder folder;
  Assembled a = assemble(to_sew(folder));
  for (int times = 0; times < 2; ++times) {
    const State kept = a.state;
    const auto go = [&] {
      for (int k = 0; k < 3; ++k) sewn_advance(a, 0.2);
      return positions(a);
    };
    const bool sewn = is_sewn(a);
    const Eigen::VectorXd first = go();
    EXPECT_TRUE(is_sewn(a));
    const std::int64_t steps = a.state.steps;
    const double damping = a.state.relaxation.damping;
    a.state = kept;
    workspace_clear(a.motion.workspace);
    seams_restore(a.system, a.motion, a.state);
    EXPECT_EQ(is_sewn(a), sewn);
    EXPECT_EQ((go() - first).cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ(a.state.steps, steps);
    EXPECT_EQ(a.state.relaxation.damping, damping);
    a.state = kept;
    workspace_clear(a.motion.workspace);
    seams_restore(a.system, a.motion, a.state);
    sewn_advance(a, times == 0 ? 0.01 : 0.1);
  }
}

}  // namespace
}  // namespace drape::dynamics
