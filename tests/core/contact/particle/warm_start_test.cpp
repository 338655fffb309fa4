// Particles in contact that share constraints with others, by a weld or in a groove. core/README.md, section
// 7.
#include <gtest/gtest.h>

#include <algorithm>

#include "body_fixture.h"
#include "math/vector3.h"
#include "outputs/outputs.h"
#include "seam_fixture.h"

namespace drape::contact {

using namespace tests;
namespace {

// Two squares of linen side by side, sewn together. The cell size of the left one is `ratio` times that of
// the right one.
Scene sewn_pair(double side, double ratio, double mu_left, double mu_right) {
  Scene scene = reference::rectangle(linen(), side, side, side / 5);
  scene.fabrics.push_back(scene.fabrics[0]);
  scene.fabrics[0].friction = {mu_left, mu_left};
  scene.fabrics[1].friction = {mu_right, mu_right};
  scene.pieces.push_back(scene.pieces[0]);
  scene.pieces[1].name = "right";
  scene.pieces[1].fabric = 1;
  scene.pieces[1].cell = side / (5 * ratio);
  scene.seams = {seam_join()};
  return scene;
}

// On a table; gravity is inclined by the angle towards +x.
Assembled pair_on_incline(const SceneFolder& folder, double angle, double ratio) {
  Scene scene = sewn_pair(0.05, ratio, 0.2, 0.6);
  scene.gravity = {9.81 * std::sin(angle), 0, -9.81 * std::cos(angle)};
  scene.damping = 0;
  scene.pieces[0].place.origin = {-0.5, 0, 0.00049};
  scene.pieces[1].place.origin = {-0.45, 0, 0.00049};
  body_add(scene, folder, "table", box(2, 2, 0.1)).position = {0, 0, -0.05};
  return assemble(scene);
}

double speed_along(const Assembled& a) {
  double sum = 0, mass = 0;
  for (std::size_t n : a.system.particle) sum += a.system.mass[n] * a.state.vx[n], mass += a.system.mass[n];
  return sum / mass;
}

// The halves have equal weights, so the cloth slides by the mean of their coefficients, 0.4. (With cells of
// two sizes, the smaller ones have the stiffer penalty and bear more of the seam.)
TEST(WarmStart, SewnHalvesSlideByTheMeanOfTheirCoefficients) {
  const SceneFolder folder;
  const double angle = std::atan(0.5), t = 0.2;
  Assembled a = pair_on_incline(folder, angle, 1);
  for (std::size_t n : a.system.particle) a.state.vx[n] = 0.5;  // all of it slides
  sewn_advance(a, 0.1);
  const double before = speed_along(a);
  sewn_advance(a, t);
  const double gained = 9.81 * (std::sin(angle) - 0.4 * std::cos(angle)) * t;
  EXPECT_NEAR(speed_along(a) - before, gained, 1e-3 * gained);
}

TEST(WarmStart, SewnHalvesStickBelowIt) {
  const SceneFolder folder;
  Assembled a = pair_on_incline(folder, std::atan(0.36), 1.6);
  sewn_advance(a, 0.5);
  const Eigen::VectorXd start = positions(a);
  sewn_advance(a, 1);
  EXPECT_LT((positions(a) - start).cwiseAbs().maxCoeff(), 1e-9);
}

// Runs a fit to its rest. Returns false if it is not at rest within `duration` (s).
bool rests(Assembled& a, double duration) {
  for (double t = 0; t < duration && !a.state.relaxation.at_rest; t += 0.1) sewn_advance(a, 0.1);
  return a.state.relaxation.at_rest;
}

// One half lies on a table, the other hangs over its edge, and friction holds it by the seam. The seam lies
// on the edge: some of its nodes touch and some do not.
TEST(WarmStart, AHangingHalfRestsByItsSeam) {
  const SceneFolder folder;
  Scene scene = sewn_pair(0.1, 1.6, 0.7, 0.7);
  scene.mode = scene::Mode::kFit;
  scene.pieces[0].place.origin = {-0.1, 0, 0.00049};
  scene.pieces[1].place.origin = {0, 0, 0.00049};
  body_add(scene, folder, "table", box(1, 1, 0.1)).position = {-0.5, 0, -0.05};
  Assembled a = assemble(scene);
  ASSERT_TRUE(rests(a, 10)) << "residual " << a.state.relaxation.residual;
  expect_weight(a);
}

// A strip in a groove of 90 degrees: the nodes at the bottom touch both of its sides.
TEST(WarmStart, AStripRestsInAGroove) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(), 0.1, 0.03, 0.01);
  scene.fabrics[0].friction = {0.2, 0.2};
  scene.fabrics[0].bending_warp = scene.fabrics[0].bending_weft = 1e-7;
  scene.mode = scene::Mode::kFit;
  scene.pieces[0].place.origin = {-0.05, -0.015, 0.055};
  const Mesh groove{{{-0.2, -1, 0.2}, {0, -1, 0}, {0.2, -1, 0.2}, {-0.2, 1, 0.2}, {0, 1, 0}, {0.2, 1, 0.2}},
                    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
  body_add(scene, folder, "groove", groove);
  Assembled a = assemble(scene);
  ASSERT_TRUE(rests(a, 10)) << "residual " << a.state.relaxation.residual;
  const model::ContactBlocks& blocks = a.state.body[0].blocks;
  int both = 0;  // nodes that lie on both sides
  for (std::size_t k = 1; k < blocks.order.size(); ++k) {
    if (blocks.order[k].node != blocks.order[k - 1].node) continue;
    const model::ContactBlock &p = blocks.pool[blocks.order[k - 1].block],
                              &q = blocks.pool[blocks.order[k].block];
    for (std::size_t i = 0; i < std::size_t(math::kRowUnit); ++i) {
      const std::size_t n = p.node + i;
      const auto height = [&](const model::ContactBlock& b) {
        return b.side[0][i] * a.state.x[n] + b.side[1][i] * a.state.y[n] + b.side[2][i] * a.state.z[n] -
               b.offset[i];
      };
      both += p.offset[i] != -model::kFar && q.offset[i] != -model::kFar && height(p) < 0.0005 &&
              height(q) < 0.0005;
    }
  }
  EXPECT_GT(both, 0);
  expect_weight(a);
}

// Welds that no contact touches in a step are not projected again. That leaves them as they are, up to
// rounding, compared with projecting all again. Two sewn squares fall onto a ball below the seam, or on a
// box with sharp edges.
TEST(WarmStart, WeldsLeftAloneAreSatisfiedAlready) {
  const SceneFolder folder;
  const auto run = [&](bool features, bool all) {
    Scene scene = sewn_pair(0.05, 1.6, 0.2, 0.6);
    scene.energy = true;
    scene.pieces[0].place.origin = {-0.05, 0, 0.001};
    scene.pieces[1].place.origin = {0, 0, 0.001};
    scene.pins = {{"held", 0, {}, {3}}};
    if (features) body_add(scene, folder, "body", box(0.05, 0.025, 0.1)).position = {0.003, 0.01, -0.05};
    else body_add(scene, folder, "body", ball(0.03, 40)).position = {0.002, 0.022, -0.03};
    Assembled a = assemble(scene);
    sewn_advance(a, 1e-3);
    EXPECT_FALSE(a.motion.contact.touched.empty());
    if (all) a.motion.contact.touched.clear();
    dynamics::energy_begin(a.system, a.state);
    int met = 0;  // advances whose last step had contact at a weld
    for (int k = 0; k < 60; ++k) {
      sewn_advance(a, 1e-3);
      met += std::count(a.motion.contact.touched.begin(), a.motion.contact.touched.end(), 1) > 0;
    }
    if (!all) {
      EXPECT_GT(met, 5) << features;
      EXPECT_LT(met, 60);
    }
    return a;
  };
  for (const bool features : {false, true}) {
    const Assembled some = run(features, false), all = run(features, true);
    EXPECT_LT((positions(some) - positions(all)).cwiseAbs().maxCoeff(), 1e-10) << features;
    EXPECT_NEAR(some.state.input, all.state.input, 1e-10);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(some.state.pin_impulse[0].force[k], all.state.pin_impulse[0].force[k], 1e-10);
  }
}

// Two sewn squares are thrown onto a ball below their seam. Welds share out what stops a particle; contact
// and welds respond in turns within the step, so that no particle comes deeper than the stop, 0.9 of the
// contact distance, and what the ball curves in a step. (With one turn it came to 1.1 of it.)
TEST(WarmStart, ASeamIsStoppedInTheStepOfItsImpact) {
  const SceneFolder folder;
  Scene scene = sewn_pair(0.05, 1.6, 0.2, 0.6);
  scene.pieces[0].place.origin = {-0.05, 0, 0.002};
  scene.pieces[1].place.origin = {0, 0, 0.002};
  for (scene::PieceSpec& piece : scene.pieces) piece.velocity = {0, 0, -20};
  body_add(scene, folder, "body", ball(0.03, 40)).position = {0.002, 0.022, -0.03};
  scene.communication = 1e-5;
  Assembled a = assemble(scene);
  const double contact_distance = a.system.lattices[0].contact_law.distance;
  double deepest = 0;
  for (int k = 0; k < 100; ++k) {
    sewn_advance(a, 1e-5);
    deepest = std::max(deepest, contact_summary(a.system, a.state, {}).penetration);
  }
  EXPECT_GT(deepest, 0.1 * contact_distance);
  EXPECT_LT(deepest, 0.93 * contact_distance);
}

}  // namespace
}  // namespace drape::contact
