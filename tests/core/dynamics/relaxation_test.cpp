// Relaxation: its rest is an equilibrium of the equations. core/README.md, section 4.
#include "dynamics/relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "reference/motion.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// Runs a fit to its rest. Returns false if it is not at rest within `duration` (s).
bool fit_run(Assembled& a, double duration) {
  std::string event;
  for (double t = 0; t < duration && !a.state.relaxation.at_rest; t += 0.1)
    if (leapfrog_advance(a.system, a.motion, a.state, 0.1, event) != Advance::kDone) return false;
  return a.state.relaxation.at_rest;
}

Vec3 probe_at(const Assembled& a) {
  Vec3 r{0, 0, 0};
  const model::Probe& p = a.system.probes[0];
  for (int k = 0; k < 4; ++k) {
    r[0] += p.weight[k] * a.state.x[p.node[k]];
    r[1] += p.weight[k] * a.state.y[p.node[k]];
    r[2] += p.weight[k] * a.state.z[p.node[k]];
  }
  return r;
}

// The heavy elastica th'' = -beta (1 - s) cos th, th(0) = 0, th'(1) = 0, by shooting for th'(0) with RK4 and
// bisection: the horizontal and vertical position of its tip, over the length.
struct Tip {
  double out, down;
};
struct Curved {
  double angle, rate;
  Tip tip;
};
Curved elastica_shot(double beta, double rate) {
  constexpr int kSteps = 4000;
  double th = 0, k = rate, out = 0, down = 0;
  const double h = 1.0 / kSteps;
  for (int n = 0; n < kSteps; ++n) {
    const double s = n * h;
    const auto bend = [&](double at, double angle) { return -beta * (1 - at) * std::cos(angle); };
    const double k1 = bend(s, th), t1 = k, k2 = bend(s + h / 2, th + h / 2 * t1), t2 = k + h / 2 * k1,
                 k3 = bend(s + h / 2, th + h / 2 * t2), t3 = k + h / 2 * k2, k4 = bend(s + h, th + h * t3),
                 t4 = k + h * k3;
    const double middle = th + h / 2 * (t1 + t2) / 2, end = th + h / 6 * (t1 + 2 * t2 + 2 * t3 + t4);
    out += h / 6 * (std::cos(th) + 4 * std::cos(middle) + std::cos(end));
    down += h / 6 * (std::sin(th) + 4 * std::sin(middle) + std::sin(end));
    th = end;
    k += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {th, k, {out, down}};
}
Tip elastica(double beta) {
  double low = 0, high = beta;  // th'(1) rises with th'(0)
  for (int n = 0; n < 60; ++n) {
    const double middle = (low + high) / 2;
    (elastica_shot(beta, middle).rate < 0 ? low : high) = middle;
  }
  return elastica_shot(beta, low).tip;
}

// A strip of warp that leaves a clamp horizontally, `cells` long and two wide. The clamp lies at the share s
// of a cell. Yarns of k (N/m) are strained by at most beta B/(l^2 k): 5e-5 for beta = 10 and 200 N/m.
constexpr double kLength = 0.065, kRigidity = 4.567e-6, kDensity = 0.1;  // m, N m, kg/m^2
enum class Held { kEdge, kRegion };
Scene cantilever(double beta, int cells, double share, Held held, double k) {
  scene::FabricSpec fabric = reference::threads(k);
  fabric.areal_density = kDensity;
  fabric.weft = reference::straight(k);
  fabric.bending_warp = kRigidity;
  const double b = kLength / cells, behind = held == Held::kRegion ? 3 * b : 0;
  Scene scene = reference::rectangle(fabric, 2 * b, kLength + behind, b);
  scene.mode = scene::Mode::kFit;
  scene.gravity = {0, 0, -beta * kRigidity / (kDensity * std::pow(kLength, 3))};
  scene::PieceSpec& piece = scene.pieces[0];
  for (Vec2& p : piece.outline) p[1] -= behind;
  piece.grid_origin = Vec2{0, share * b};  // the clamp is at y = 0
  scene::PinSpec pin;
  pin.name = "clamp";
  pin.piece = 0;
  pin.clamp = true;
  if (held == Held::kEdge) pin.edges = {0};
  else pin.region = {{-b, -behind - b}, {3 * b, -behind - b}, {3 * b, 0}, {-b, 0}};
  scene.pins = {pin};
  scene.probes = {{"tip", 0, {b, kLength}}};
  return scene;
}

Tip cantilever_tip(double beta, int cells, double share, Held held, double k = 200) {
  Assembled a = assemble(cantilever(beta, cells, share, held, k));
  EXPECT_TRUE(fit_run(a, 60)) << "residual " << a.state.relaxation.residual;
  const Vec3 tip = probe_at(a);
  return {tip[1] / kLength, -tip[2] / kLength};
}

double off(Tip a, Tip b) { return std::hypot(a.out - b.out, a.down - b.down); }

// Case b: within 0.1 % of l at b = l/50, of order 2 in b.
TEST(Cantilever, IsTheHeavyElasticaOfOrderTwo) {
  for (double beta : {1.0, 10.0}) {
    const Tip exact = elastica(beta);
    const double coarse = off(cantilever_tip(beta, 25, 1, Held::kEdge, 1000), exact),
                 fine = off(cantilever_tip(beta, 50, 1, Held::kEdge, 1000), exact),
                 order = std::log2(coarse / fine);
    std::printf("beta %-5g f/l %.5f: %.1e of l off at l/25, %.1e at l/50, order %.2f\n", beta, exact.down,
                coarse, fine, order);
    EXPECT_LE(fine, 1e-3);
    EXPECT_NEAR(order, 2, 0.1);
  }
}

// A clamp at shares of a cell: within 0.5 % of l at b = l/50, by an edge and by a region.
TEST(Cantilever, IsHeldAtAnyShareOfACell) {
  const double beta = 10;
  const Tip exact = elastica(beta);
  for (double share : {0.2, 0.35, 0.6, 0.8, 1.0}) {
    const double edge = off(cantilever_tip(beta, 50, share, Held::kEdge), exact),
                 region = off(cantilever_tip(beta, 50, share, Held::kRegion), exact);
    std::printf("clamp at %.1f of a cell: edge %.2f %%, region %.2f %% of l off\n", share, 100 * edge,
                100 * region);
    EXPECT_LE(edge, 5e-3);
    EXPECT_LE(region, 5e-3);
  }
}

// The overhang of the paper's Figure 5b, EI = 1370 uN cm2 on 30 mm, l = 65 mm: the horizontal position of
// the tip (mm) against the elastica of a given weight.
TEST(Cantilever, GivesTheOverhangOfTheBendingTest) {
  for (const auto& [grams, out, down] : {std::array{100.0, 14.32, 59.561}, std::array{150.0, 11.14, 60.660},
                                         std::array{200.0, 9.40, 61.284}}) {
    const double beta = 1e-3 * grams * 9.81 * std::pow(kLength, 3) / kRigidity;
    const Tip exact = elastica(beta), tip = cantilever_tip(beta, 52, 1, Held::kEdge);  // b = 1.25 mm
    std::printf("%3.0f g/m2: elastica %.2f out, %.3f down; strip %.2f, %.3f mm\n", grams,
                1e3 * kLength * exact.out, 1e3 * kLength * exact.down, 1e3 * kLength * tip.out,
                1e3 * kLength * tip.down);
    EXPECT_NEAR(1e3 * kLength * exact.out, out, 0.01);
    EXPECT_NEAR(1e3 * kLength * exact.down, down, 0.001);
    EXPECT_NEAR(tip.out / exact.out, 1, 0.005);
  }
}

// The rest of a fit is an equilibrium of the reference solver, with forces of zero; and a damped dynamic run
// ends there. A cut piece with a hole, on a pin inside a cell and one at a node.
TEST(Relaxation, EndsAtTheRestOfTheDampedMotion) {
  scene::FabricSpec fabric = reference::curved_fabric();
  Scene scene = cut_piece(fabric, Shape::kDiscWithHole);
  scene.pieces[0].place.axis_y = {0, 0, 1};
  scene.pins = {reference::pin_at("inside", {{0.0233, 0.0644}}), reference::pin_at("node", {{0.06, 0.06}})};
  scene.mode = scene::Mode::kFit;
  Assembled fit = assemble(scene);
  ASSERT_TRUE(fit_run(fit, 60)) << fit.state.relaxation.residual;
  const reference::Motion motion = reference::motion_make(scene);
  const reference::Residual left = reference::residual(motion, motion.start, positions(fit));
  EXPECT_LE(fit.state.relaxation.residual, 1e-5);
  EXPECT_NEAR(left.force, fit.state.relaxation.residual * fit.state.relaxation.load,
              1e-9 * fit.state.relaxation.load);

  scene.mode = scene::Mode::kDynamic;
  scene.damping = 30;
  Assembled damped = assemble(scene);
  std::string event;
  ASSERT_EQ(leapfrog_advance(damped.system, damped.motion, damped.state, 4, event), Advance::kDone);
  const double apart = (positions(fit) - positions(damped)).lpNorm<Eigen::Infinity>();
  std::printf(
      "fit: residual %.1e of the load after %lld steps; %.1e m from the damped motion's rest (%lld steps)\n",
      left.ratio, (long long)fit.state.steps, apart, (long long)damped.state.steps);
  // 1e-5 of the weight on the softest mode, the pendulum of length 0.05 m
  EXPECT_LE(apart, 1e-5 * 0.05);
}

// At rest an advance moves only the clock; a tuned value restarts the relaxation.
TEST(Relaxation, StaysAtRestUntilSomethingChanges) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.04, 0.04, 0.01, true);
  scene.pins = {reference::pin_edges("bar", {2})};
  scene.mode = scene::Mode::kFit;
  Assembled a = assemble(scene);
  ASSERT_TRUE(fit_run(a, 60));
  const Eigen::VectorXd rest = positions(a);
  const std::int64_t steps = a.state.steps;
  const double time = model::state_time(a.state, a.system.communication);
  std::string event;
  ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 1, event), Advance::kDone);
  EXPECT_EQ(a.state.steps, steps);
  EXPECT_EQ(positions(a), rest);
  EXPECT_NEAR(model::state_time(a.state, a.system.communication), time + 1, 1e-9);
  a.system.gravity = {0, 0, -2};
  leapfrog_retuned(a.system, a.motion, a.state);
  ASSERT_TRUE(fit_run(a, 60));
  EXPECT_GT(a.state.steps, steps);
  EXPECT_NE(positions(a), rest);
}

// The forces on the way to the rest do not count. A bar displaced in one step, with weight and without, and
// a cloth that starts far from rest both end where the reference solver finds no residual beyond the share
// of the present load.
TEST(Relaxation, RestIsMeasuredByThePresentLoad) {
  for (const double displaced : {0.0, 0.1, 1.0})
    for (const double weight : {9.81, 0.0}) {
      if (displaced == 0 && weight == 0) continue;
      Scene scene = reference::rectangle(reference::curved_fabric(), 0.05, 0.05, 0.01, true);
      scene.mode = scene::Mode::kFit;
      scene.gravity = {0, 0, -weight};
      scene.imperfection_amplitude = 0.01;  // as large as a cell
      scene.pins = {reference::pin_edges("bar", {2}), reference::pin_edges("foot", {0})};
      scene.pins[0].drive = scene::Drive::kPosition;
      Assembled a = assemble(scene);
      std::string event;
      const Vec3 from = a.motion.inputs.pin[0].position;
      a.motion.inputs.pin[0].position = {from[0], from[1] + displaced, from[2] + displaced};
      ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 1e-4, event), Advance::kDone);
      a.motion.inputs.pin[0].position = {from[0], from[1], from[2] + 0.002};  // 4 % longer than it was
      ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 1e-4, event), Advance::kDone);
      ASSERT_TRUE(fit_run(a, 60)) << displaced << " m, " << weight << " m/s^2, residual "
                                  << a.state.relaxation.residual;
      const reference::Motion motion = reference::motion_make(scene);
      reference::Outside outside = motion.start;
      outside.pins[0].p[2] += 0.002;
      const reference::Residual left = reference::residual(motion, outside, positions(a));
      EXPECT_LE(left.ratio, 1.001e-5) << displaced << " m, " << weight << " m/s^2";
      // Without weight the load may be a share of earlier forces (core/README.md, section 4).
      const double load = left.force / left.ratio, reported = a.state.relaxation.load;
      EXPECT_NEAR(left.force, a.state.relaxation.residual * reported, 1e-3 * left.force + 1e-12 * reported);
      if (weight > 0) EXPECT_NEAR(reported, load, 1e-5 * load);
      else EXPECT_NEAR(reported, std::max(load, 1e-4 * a.state.relaxation.max_force), 1e-5 * reported);
    }
}

// Damping along springs lowers the step limit too. The relaxation stays bounded beyond the hundred intervals
// after which a dynamic run would choose its step again. Without weight, with only a clamp that was rotated,
// it also comes to rest.
TEST(Relaxation, ComesToRestWithDampedSpringsAndWithoutWeight) {
  scene::FabricSpec fabric = reference::curved_fabric();
  for (double damping : {0.0, 1e-4}) {
    fabric.damping = damping;
    Scene scene = reference::rectangle(fabric, 0.04, 0.04, 0.01, true);
    scene.mode = scene::Mode::kFit;
    scene.pins = {reference::pin_edges("bar", {2})};
    Assembled a = assemble(scene);
    EXPECT_TRUE(fit_run(a, 60)) << a.state.relaxation.residual;
    scene.gravity = {0, 0, 0};
    Assembled weightless = assemble(scene);
    crumple(weightless, 0.001, 3);
    for (const constraint::FixedNode& f : weightless.system.constraints.fixed) {
      weightless.state.x[f.node] = f.target.start[0];
      weightless.state.y[f.node] = f.target.start[1];
      weightless.state.z[f.node] = f.target.start[2];
    }
    EXPECT_TRUE(fit_run(weightless, 60)) << weightless.state.relaxation.residual;
  }
}

// Where cells stiffen beyond what the step allows, their inertia grows: h omega' stays at 2 S.
TEST(Relaxation, EnlargesTheInertiaOfStiffCells) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.05, 0.05, 0.01);
  scene.mode = scene::Mode::kFit;
  Assembled a = assemble(scene);
  for (std::size_t n : a.system.particle) a.state.y[n] *= a.state.y[n] > 0.025 ? 1.3 : 1.0;
  const double h = kSafety * step_limit_of(a.system, a.state.omega2);
  relaxation_scale_masses(a.system, a.motion.constraints, a.state, h);
  double smallest = 1, largest = 0;
  for (std::size_t n : a.system.particle) {
    smallest = std::min(smallest, a.state.inverse_mass_scale[n]);
    largest = std::max(largest, a.state.inverse_mass_scale[n]);
  }
  EXPECT_LT(smallest, 0.5);
  EXPECT_EQ(largest, 1);
  EXPECT_NEAR(h * std::sqrt(a.state.omega2) / 2, kSafety, 1e-12);
}

// The inertia is updated within 16 steps, and sooner where a particle would move by a fiftieth of its cell:
// at the speed b/(50 k h), after k steps.
TEST(Relaxation, ChecksSoonerWhereTheClothMovesFast) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.05, 0.05, 0.01);
  scene.mode = scene::Mode::kFit;
  Assembled a = assemble(scene);
  const double h = 1e-5;
  const auto steps_to_check = [&](double steps) {
    a.state.vz[a.system.particle[7]] = -0.01 / (50 * steps * h);
    relaxation_scale_masses(a.system, a.motion.constraints, a.state, h);
    return a.state.steps_to_limit_check;
  };
  EXPECT_EQ(steps_to_check(1e6), 16);
  EXPECT_EQ(steps_to_check(5.001), 5);
  EXPECT_EQ(steps_to_check(0.01), 1);
}

}  // namespace
}  // namespace drape::dynamics
