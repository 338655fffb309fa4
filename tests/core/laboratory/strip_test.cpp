// Strips between jaws and without: case a of the model. Equations: core/README.md, section 5.
#include "laboratory/strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "cloth_fixture.h"
#include "laboratory/equilibrium.h"
#include "laboratory/strip_order.h"
#include "reference/motion.h"
#include "validation/load.h"

namespace drape::laboratory {

using namespace tests;
namespace {

scene::FabricSpec shipped(const std::string& name) {
  std::vector<Problem> problems;
  const scene::FabricSpec f =
      validation::fabric_load(DRAPE_SOURCE_DIR "/examples/fabrics/" + name + ".toml", problems);
  for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
  return f;
}

StripPull expect_pull(const scene::FabricSpec& f, model::YarnDirection along, double cell,
                      const std::vector<double>& elongation) {
  std::vector<Problem> problems;
  const StripPull pull = strip_pull(f, along, cell, elongation, problems);
  for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
  EXPECT_EQ(pull.force.size(), elongation.size());
  return pull;
}

class ShippedStrip : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Fabrics, ShippedStrip,
                         testing::Values("cotton", "half_wool", "quilting_cotton", "wool"),
                         [](const auto& name) { return std::string(name.param); });

// Case a on calibrated fabrics: S_i = F_i, 0.05 % in jaws along warp and weft, 0.1 % at 45 degrees.
TEST_P(ShippedStrip, GivesBackItsDiagrams) {
  const scene::FabricSpec f = shipped(GetParam());
  for (model::YarnDirection along :
       {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias}) {
    const scene::DiagramSpec& d = strip_diagram(f, along);
    ASSERT_FALSE(d.correction.empty());
    const StripPull pull =
        expect_pull(f, along, f.strip_width / kStripCells, strip_elongations(f, along, 10));
    double worst = 0;
    for (std::size_t k = 0; k < pull.force.size(); ++k)
      worst = std::max(worst, std::abs(pull.force[k] / d.force[k + 1] - 1));
    std::printf("case a, %s: at most %.1e off\n",
                along == model::YarnDirection::kBias ? "45 degrees" : "threads", worst);
    EXPECT_LE(worst, along == model::YarnDirection::kBias ? 1e-3 : 5e-4);
  }
}

// Every strip also finds its equilibrium on cells of width/8 and width/32. Along the ends of the 45 degree
// strip the points have equal shares of the width, corners are nodes, and the forces converge with order 1
// or more.
TEST_P(ShippedStrip, FindsItsRestOnOtherCells) {
  const scene::FabricSpec f = shipped(GetParam());
  std::vector<Problem> problems;
  for (model::YarnDirection along : {model::YarnDirection::kWarp, model::YarnDirection::kWeft})
    for (double cells : {8.0, 32.0})
      expect_pull(f, along, f.strip_width / cells, strip_elongations(f, along, 0.04));
  if (!f.bias.jaws) return;
  const StripOrder o =
      strip_order(f, f.strip_width / 16, strip_elongations(f, model::YarnDirection::kBias, 0.06), problems);
  ASSERT_TRUE(o.has_order && o.why.empty() && problems.empty()) << o.why;
  std::printf("45 degrees on cells of %.3f, %.3f, %.3f mm: %.2f, %.3f, %.2f %% off, order %.2f\n",
              1e3 * o.cell[0], 1e3 * o.cell[1], 1e3 * o.cell[2], 100 * o.off[0], 100 * o.off[1],
              100 * o.off[2], o.order);
  EXPECT_GE(o.order, 1);
}

// Changes of b^p between three cells.
TEST(StripOrder, IsThePowerOfTheCell) {
  const std::array<double, 3> b{5e-3, 3e-3, 1.4e-3};
  for (double p : {0.5, 1.0, 1.7, 3.0})
    EXPECT_NEAR(order_of(b, std::pow(b[0], p) - std::pow(b[1], p), std::pow(b[1], p) - std::pow(b[2], p)), p,
                1e-9);
  EXPECT_TRUE(std::isnan(order_of(b, 1e-3, 2e-3)));  // changes that grow
}

// Slack yarns and short strips (ASTM D5035), whose jaws hold nearly dependent rows.
TEST(Strip, FindsItsRestWhereClothIsSlackOrShort) {
  for (const auto& [width, gauge] : {std::pair{0.05, 0.075}, std::pair{0.025, 0.075}, std::pair{0.05, 0.1}})
    for (double compression : {1.0, 0.0}) {
      scene::FabricSpec f = shipped("cotton");
      f.strip_width = width, f.strip_gauge = gauge, f.compression = compression;
      for (model::YarnDirection along :
           {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias})
        for (double cells : {8.0, 13.0})
          expect_pull(f, along, width / cells, strip_elongations(f, along, 10));
    }
}

// With the bias law and bending off, a warp strip between jaws consists of independent yarns: it gives the
// input at every cell, to the residual of the equilibrium (1e-7 of the load).
TEST(Strip, OfYarnsAloneIsItsDiagramAtEveryCell) {
  scene::FabricSpec f = shipped("cotton");
  f.bias = {};
  f.warp.correction.clear();
  f.weft.correction.clear();
  for (model::YarnDirection along : {model::YarnDirection::kWarp, model::YarnDirection::kWeft})
    for (double cells : {4.0, 7.3, 16.0}) {
      const scene::DiagramSpec& d = strip_diagram(f, along);
      const StripPull pull = expect_pull(f, along, f.strip_width / cells, strip_elongations(f, along, 10));
      for (std::size_t k = 0; k < pull.force.size(); ++k)
        EXPECT_NEAR(pull.force[k] / d.force[k + 1], 1, 1e-6) << cells << " cells, point " << k + 1;
    }
}

// The equilibrium of Newton's method is one of the reference solver: its residual is zero, and the pins bear
// the stated forces.
TEST(Strip, IsAtRestForTheReference) {
  const scene::FabricSpec f = shipped("half_wool");
  const Scene scene = strip_scene(f, model::YarnDirection::kBias, f.strip_width / 8);
  Assembled a = assemble(scene);
  a.state.pin_motion[1].position[1] += 0.04 * f.strip_gauge;
  const EquilibriumSearchHandle search = equilibrium_search_make(a.system, true);
  const Equilibrium rest = equilibrium_find(*search, a.system, a.motion, a.state);
  ASSERT_TRUE(rest.found);
  const reference::Motion motion = reference::motion_make(scene);
  reference::Outside outside = motion.start;
  outside.pins[1].p[1] += 0.04 * f.strip_gauge;
  const reference::Residual left = reference::residual(motion, outside, positions(a));
  EXPECT_LE(left.ratio, 2e-7);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(rest.force[0][std::size_t(k)], -rest.force[1][std::size_t(k)], 1e-6 * -rest.force[1][1]);
}

// At rest, damping exerts no force.
TEST(Strip, IsPulledAlikeWithDamping) {
  scene::FabricSpec f = shipped("half_wool");
  for (const auto along : {model::YarnDirection::kWarp, model::YarnDirection::kBias}) {
    f.damping = 0;
    const StripPull without = expect_pull(f, along, f.strip_width / 4, {0.01, 0.02});
    f.damping = 1e-5;
    EXPECT_EQ(expect_pull(f, along, f.strip_width / 4, {0.01, 0.02}).force, without.force);
  }
}

// Fit mode finds the same equilibrium by motion, to the 1e-5 of the load at which it stops: as forces on
// soft strips, 1e-3 of the pull.
TEST(Strip, IsTheRestOfAFit) {
  const scene::FabricSpec f = shipped("half_wool");
  Scene scene = strip_scene(f, model::YarnDirection::kBias, f.strip_width / 4);
  scene.mode = scene::Mode::kFit;
  Assembled a = assemble(scene);
  const double pull = 0.03;
  a.motion.inputs = dynamics::inputs_at(a.state);
  a.motion.inputs.pin[1].position[1] += pull * f.strip_gauge;
  std::string event;
  ASSERT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 0.1, event), dynamics::Advance::kDone);
  for (int k = 0; k < 600 && !a.state.relaxation.at_rest; ++k)
    ASSERT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 0.1, event), dynamics::Advance::kDone);
  ASSERT_TRUE(a.state.relaxation.at_rest) << a.state.relaxation.residual;
  std::vector<math::Wrench> load(2);
  Array v[3] = {Array(a.system.nodes), Array(a.system.nodes), Array(a.system.nodes)};
  dynamics::leapfrog_synchronous(a.system, a.motion, a.state, {v[0].data(), v[1].data(), v[2].data()}, load);
  const StripPull newton = expect_pull(f, model::YarnDirection::kBias, f.strip_width / 4, {pull});
  EXPECT_NEAR(-load[1].force[1] / newton.force[0], 1, 1e-3);
}

// A trellis of inextensible yarns: S = w_p [g(L) + g(|e2|) l1/l2], which the odd law without jaws solves for
// F; exact except for the differences of the homogeneous lattice, 1e-9.
TEST(Strip, WithoutJawsIsTheTrellis) {
  scene::FabricSpec f = shipped("wool");
  f.bias.correction.clear();
  const std::vector<double> elongation = strip_elongations(f, model::YarnDirection::kBias, 10);
  for (double cells : {4.0, 9.0}) {
    const StripPull pull = expect_pull(f, model::YarnDirection::kBias, f.strip_width / cells, elongation);
    for (std::size_t k = 0; k < pull.force.size(); ++k)
      EXPECT_NEAR(pull.force[k] / f.bias.force[k + 1], 1, 1e-9);
  }
}

// Jaws stiffen a linear 45 degree strip about as K = r (r - 1.25)/(r - 1)^2 predicts: within 15 % for r = 4.
TEST(Strip, IsStiffenedByJawsAboutAsKPredicts) {
  scene::FabricSpec f = shipped("cotton");
  for (scene::DiagramSpec* d : {&f.warp, &f.weft, &f.bias})
    d->correction.clear(), d->correction_elongation.clear();
  const StripPull pull = expect_pull(f, model::YarnDirection::kBias, f.strip_width / 16, {0.005});
  EXPECT_NEAR(pull.force[0] / f.bias.force[1], 1, 0.15);
  f.bias.jaws = false;
  f.bias.force[1] *= 9.0 / 11;  // over K
  EXPECT_NEAR(
      expect_pull(f, model::YarnDirection::kBias, f.strip_width / 16, {0.005}).force[0] / f.bias.force[1], 1,
      1e-9);
}

// The diagonals' share of a uniform strip is sqrt(2) g (1 + e)/l w_p, l = hypot(1 + e, 1), while the strip
// keeps its width. If it narrows, they pull less. For a calibrated strip the expected excess is its 1e-4 on
// the cells of the calibration.
TEST(StripExcess, OfWeftIsTheShareOfTheDiagonalsAtMost) {
  scene::FabricSpec f = shipped("wool");
  f.weft.correction.clear();
  const StripExcess e = strip_excess(f, model::YarnDirection::kWeft, {});
  EXPECT_EQ(e.elongation, f.weft.elongation[1]);
  std::vector<Problem> problems;
  const fabric::Law law = fabric::law_make(f, {}, 0.01, "fabric.f", problems);
  const double l = std::hypot(1 + e.elongation, 1),
               share = std::numbers::sqrt2 * math::curve_value(law.bias, l / std::numbers::sqrt2 - 1) *
                       (1 + e.elongation) / l * f.strip_width / f.weft.force[1];
  std::printf("wool's weft at %.3f %%: %.1f %% too hard, at most %.1f %%\n", 100 * e.elongation,
              100 * e.excess, 100 * share);
  EXPECT_GT(e.excess, 0.3 * share);
  EXPECT_LE(e.excess, share);
}

}  // namespace
}  // namespace drape::laboratory
