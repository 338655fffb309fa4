// Fields of particles and elongations of pieces, against the summaries of the whole cloth.
#include "outputs/fields.h"

#include <numbers>

#include <gtest/gtest.h>

#include "body_fixture.h"
#include "contact/particle/contact.h"
#include "outputs/strain.h"

namespace drape::outputs {

using namespace tests;
namespace {

// A cloth that has fallen onto a moving ball.
Assembled on_ball(const SceneFolder& folder) {
  Scene scene = reference::rectangle(linen(), 0.2, 0.2, 0.01);
  scene.pieces[0].place.origin = {-0.07, -0.1, 0.0507};
  body_add(scene, folder, "ball", ball(0.05, 40)).moves = true;
  Assembled a = assemble(scene);
  a.motion.inputs.body[0].position = {0.001, 0, 0.002};
  advance(a, 0.05);
  return a;
}

// The field and the summary agree: count, largest pressure.
TEST(Fields, PressureIsThatOfTheSummary) {
  const SceneFolder folder;
  const Assembled a = on_ball(folder);
  Fields fields;
  fields_fill(fields, a.system, a.state, {});
  const model::ContactSummary sum = contact::contact_summary(a.system, a.state, {});
  std::size_t count = 0;
  double largest = 0, weight = 0;
  for (const double p : fields.pressure) count += p > 0, largest = std::max(largest, p);
  for (const double area : fields.area) weight += area;
  ASSERT_GE(sum.count, 4u);
  EXPECT_EQ(count, sum.count);
  EXPECT_NEAR(largest / sum.pressure, 1, 1e-12);
  EXPECT_NEAR(weight, 0.04, 1e-12);
}

// At rest on a table the pressure on every particle is its weight over its area, rho g, whether the penalty
// supports it or is too soft and the stop does; with a hole, and cells that the outline cuts. The body bears
// the sum.
TEST(Fields, PressureAtRestIsWeightOverArea) {
  const SceneFolder folder;
  for (const double slope : {0.2, 20.0})  // N/m per width
    for (const scene::Mode mode : {scene::Mode::kFit, scene::Mode::kDynamic}) {
      scene::FabricSpec fabric = linen();
      fabric.warp = fabric.weft = reference::straight(slope);
      fabric.bias = {};
      fabric.bending_warp = fabric.bending_weft = 0;
      Scene scene = reference::rectangle(fabric, 0.05, 0.05, 0.01);
      scene.pieces[0].outline[2] = {0.047, 0.042};
      scene.pieces[0].place.origin = {0, 0, 0.0002};
      scene.mode = mode;
      scene.damping = mode == scene::Mode::kFit ? 0 : 50;
      body_add(scene, folder, "table", box(2, 2, 0.1)).position = {0, 0, -0.05};
      Assembled a = assemble(scene);
      for (double t = 0; t < 2 && !a.state.relaxation.at_rest; t += 0.1) advance(a, 0.1);
      const contact::ContactStops stops = dynamics::leapfrog_stops(a.system, a.motion, a.state);
      EXPECT_EQ(stops.particle.empty(), slope > 1) << "the penalty holds it";
      Fields fields;
      fields_fill(fields, a.system, a.state, stops);
      const double expected = 0.2 * 9.81;
      double force = 0, weight = 0;
      for (std::size_t k = 0; k < fields.pressure.size(); ++k) {
        EXPECT_NEAR(fields.pressure[k], expected, 1e-4 * expected) << slope;
        force += fields.pressure[k] * fields.area[k];
      }
      for (std::size_t n : a.system.particle) weight += 9.81 * a.system.mass[n];
      EXPECT_NEAR(force, weight, 2e-5 * weight);
      EXPECT_NEAR(-body_force(a)[2], mode == scene::Mode::kFit ? force : force * a.state.h_old / 2,
                  2e-5 * weight);
      EXPECT_NEAR(contact::contact_summary(a.system, a.state, stops).pressure, expected, 1e-4 * expected);
    }
}

// Particles at the bottom of a groove touch both of its sides. Each counts once, and so does one that
// touches two bodies.
TEST(Fields, AParticleCountsOnceByHoweverManySurfaces) {
  const SceneFolder folder;
  const Mesh groove{{{-0.2, -1, 0.2}, {0, -1, 0}, {0.2, -1, 0.2}, {-0.2, 1, 0.2}, {0, 1, 0}, {0.2, 1, 0.2}},
                    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
  for (const bool halves : {false, true}) {
    Scene scene = reference::rectangle(linen(), 0.04, 0.03, 0.01);
    scene.pieces[0].place.axis_x = {0, 1, 0};  // along the groove
    scene.pieces[0].place.axis_y = {-1, 0, 0};
    scene.pieces[0].place.origin = {0.01, -0.02, 0.05};
    if (halves) {
      Mesh left = groove, right = groove;
      left.corner.resize(2);
      right.corner.erase(right.corner.begin(), right.corner.begin() + 2);
      body_add(scene, folder, "left", left);
      body_add(scene, folder, "right", right);
    } else {
      body_add(scene, folder, "groove", groove);
    }
    Assembled a = assemble(scene);
    for (std::size_t n : a.system.particle) {  // all into the bottom, in contact with both sides
      a.state.x[n] = 0;
      a.state.z[n] = 0.0004 * std::numbers::sqrt2;
    }
    contact::begin(a.system, a.motion.kernel->contact, a.motion.contact, a.state);
    EXPECT_EQ(contact::contact_summary(a.system, a.state, {}).count, a.system.particle.size()) << halves;
  }
}

// For a single piece, the elongations are the strains of the cloth; the means of particles lie between them.
TEST(Fields, ElongationIsThatOfTheSummary) {
  const SceneFolder folder;
  const Assembled a = on_ball(folder);
  const StrainSummary sum = strain_summary(a.system, a.state);
  Fields fields;
  fields_fill(fields, a.system, a.state, {});
  const drape_strain of[] = {sum.warp, sum.weft, sum.bias};
  double tension = 0;
  for (const model::YarnDirection along :
       {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias}) {
    const drape_strain& all = of[std::size_t(along)];
    const double middle = (all.min + all.max) / 2;
    const Elongation e = elongation_of(a.system, a.state, a.system.lattices[0], along, middle);
    EXPECT_EQ(e.min, all.min);
    EXPECT_EQ(e.max, all.max);
    EXPECT_NEAR(e.mean, all.mean, 1e-15);
    EXPECT_GT(e.beyond, 0);
    EXPECT_LT(e.beyond, 1);
    tension = std::max(tension, e.tension_max);
    for (std::size_t k = std::size_t(along); k < fields.strain.size(); k += 3) {
      EXPECT_GE(fields.strain[k], all.min);
      EXPECT_LE(fields.strain[k], all.max);
    }
  }
  EXPECT_EQ(tension, sum.tension_max);
}

}  // namespace
}  // namespace drape::outputs
