// What a step errs in energy, and how the step follows from it. core/README.md, section 4, "Step".
#include "dynamics/step_size/cell_defect.h"

#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "dynamics/step_size/step_limit.h"
#include "model/elements.h"

namespace drape::dynamics {

using namespace tests;
namespace {

Scene curved_scene() {
  scene::FabricSpec fabric = reference::curved_fabric();
  fabric.bias = {};
  fabric.bending_warp = fabric.bending_weft = 0;
  return reference::rectangle(fabric, 0.06, 0.05, 0.01);
}

// Stretches the cloth along y about the origin: to the strain e, at the rate u (1/s).
void stretch(Assembled& a, double e, double u) {
  for (std::size_t n : a.system.particle) {
    a.state.vy[n] = u * a.state.y[n];
    a.state.y[n] *= 1 + e;
  }
}

// The links along y all go from e - d to e. The trapezoid rule errs by the integral of p less d [p(e - d) +
// p(e)]/2 per width and length, which is d^2 [p'(e) - p'(e - d)]/12 + O(d^5): with d = 1e-5 of segments some
// 1e-2 long, to 1e-4 of itself.
TEST(CellDefect, IsTheErrorOfTheTrapezoidRule) {
  constexpr double e = 0.013, d = 1e-5, h = 1e-6;
  Assembled a = assemble(curved_scene());
  const model::Lattice& l = a.system.lattices[0];
  double moved = 0;  // the sum of width times length of the links that are stretched
  model::YarnDirection along = model::YarnDirection::kWarp;
  model::links_visit(a.system, l, [&](const model::Link& link) {
    const bool along_y = std::abs(a.state.x[link.to] - a.state.x[link.from]) < 1e-9;
    if (!along_y) return;
    moved += link.width * link.rest;
    along = link.along;
  });
  stretch(a, e, d / h);
  const math::Curve& p = model::law_curve(l.law, along);
  const double change = math::curve_slope(p, e) - math::curve_slope(p, e - d);
  const StepDefect defect = step_defect(a.system, *a.motion.kernel, a.state, h);
  const double exact = math::curve_energy(p, e) - math::curve_energy(p, e - d) -
                       d / 2 * (math::curve_value(p, e) + math::curve_value(p, e - d));
  ASSERT_GT(std::abs(change), 0);
  EXPECT_NEAR(defect.energy, moved * d * d * std::abs(change) / 12, 1e-9 * defect.energy);
  EXPECT_NEAR(defect.energy, moved * std::abs(exact), 0.02 * defect.energy);  // exact: 1e-16 of p d left
  EXPECT_NEAR(defect.omega2, 4 * std::abs(change) / (l.law.areal_density * l.cell * l.cell),
              1e-9 * defect.omega2);
}

// A cloth that turns at w: strains stay, directions change by w h, and omega^2 by 4 p' w h/(rho b^2).
TEST(CellDefect, CountsTheTurnOfLinks) {
  constexpr double w = 30, h = 1e-5;
  Assembled a = assemble(curved_scene());
  for (std::size_t n : a.system.particle) {
    a.state.vx[n] = -w * a.state.y[n];
    a.state.vy[n] = w * a.state.x[n];
  }
  const model::Lattice& l = a.system.lattices[0];
  const double stiffness = std::max(math::curve_slope(l.law.warp, 0), math::curve_slope(l.law.weft, 0));
  const StepDefect defect = step_defect(a.system, *a.motion.kernel, a.state, h);
  EXPECT_NEAR(defect.omega2 / (4 * stiffness * w * h / (l.law.areal_density * l.cell * l.cell)), 1, 1e-3);
}

TEST(CellDefect, HasTheSameBitsInAllLanes) {
  Assembled a = assemble(curved_scene());
  crumple(a, 0.001, 3);
  for (std::size_t n : a.system.particle) a.state.vx[n] = 5 * a.state.y[n], a.state.vz[n] = 3 * a.state.x[n];
  const StepDefect expected = step_defect(a.system, *kernel_named("scalar"), a.state, 1e-5);
  ASSERT_GT(expected.energy, 0);
  for (const char* name : {"avx2", "avx512"}) {
    const Kernel* kernel = kernel_named(name);
    if (!kernel) continue;
    const StepDefect defect = step_defect(a.system, *kernel, a.state, 1e-5);
    EXPECT_EQ(defect.energy, expected.energy) << name;
    EXPECT_EQ(defect.omega2, expected.omega2) << name;
  }
}

// Between the bounds, h^2 drift is 25/s and h^3 flutter/4 is 0.01; with c, 1 + c 1 s and 1 + c 8 s times
// that.
TEST(AutomaticStep, FollowsFromTheMotion) {
  Scene scene = curved_scene();
  for (double c : {0.0, 0.5}) {
    scene.damping = c;
    const Assembled a = assemble(scene);
    const double omega2 = 1e10, limit = step_limit_of(a.system, omega2), more = 1 + 8 * c;
    const auto step = [&](double drift, double flutter) {
      return step_automatic(a.system, omega2, {drift, flutter});
    };
    EXPECT_DOUBLE_EQ(step(0, 0), 0.7 * limit);
    const double h = 0.2 * limit, slower = 0.5 * limit;
    EXPECT_NEAR(step(25 * (1 + c) / (h * h), 0), h, 1e-12 * h);
    EXPECT_NEAR(step(0, 0.04 * more / std::pow(slower, 3)), slower, 1e-12 * slower);
    EXPECT_DOUBLE_EQ(step(0, INFINITY), 0.4 * limit);
    EXPECT_DOUBLE_EQ(step(INFINITY, INFINITY), 0.05 * limit);
  }
}

}  // namespace
}  // namespace drape::dynamics
