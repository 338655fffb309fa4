// The methods of order 4 and 6: their conditions, their order on smooth cloth, and their step limit.
#include "model/composition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cloth_fixture.h"
#include "dynamics/potential_energy.h"
#include "model/kinetic_energy.h"

namespace drape::model {

using namespace tests;
namespace {

using reference::rectangle;
using reference::straight;

class CompositionOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, CompositionOf, testing::Values(4, 6),
                         [](const auto& p) { return "order_" + std::to_string(p.param); });

// Straight diagrams, large rotations: smooth, but not linear.
scene::FabricSpec smooth_fabric() {
  scene::FabricSpec f;
  f.name = "smooth";
  f.areal_density = 0.2;
  f.warp = straight(30);
  f.weft = straight(20);
  f.bias = reference::diagram({0, 0.1}, {0, 0.1 * 8 * 0.05});
  f.bending_warp = f.bending_weft = 2e-5;
  return f;
}

// Palindromes whose kicks and drifts add up to the step.
TEST_P(CompositionOf, AddsUpToOneStepAndBack) {
  const Composition& of = *composition_of(GetParam());
  double kicks = 0, drifts = 0;
  for (int k = 0; k <= of.stages; ++k) kicks += of.kick[k];
  for (int k = 0; k < of.stages; ++k) drifts += of.drift[k];
  EXPECT_NEAR(kicks, 1, 1e-15);
  EXPECT_NEAR(drifts, 1, 1e-15);
  for (int k = 0; k <= of.stages; ++k) EXPECT_EQ(of.kick[k], of.kick[of.stages - k]);
  for (int k = 0; k < of.stages; ++k) EXPECT_EQ(of.drift[k], of.drift[of.stages - 1 - k]);
}

// The absolute trace of one step of x'' = -w^2 x, less 2: above 0 the oscillator grows.
double excess(const Composition& of, double angle) {
  double m[2][2] = {{1, 0}, {0, 1}};
  for (int k = 0; k <= of.stages; ++k)
    for (auto column : {0, 1}) {
      m[1][column] -= of.kick[k] * angle * angle * m[0][column];
      if (k < of.stages) m[0][column] += of.drift[k] * m[1][column];
    }
  return std::abs(m[0][0] + m[1][1]) - 2;
}

// The limit is the first angle beyond which the trace leaves [-2, 2]; it touches +-2 where h w = k pi.
TEST_P(CompositionOf, IsBoundedUpToItsLimit) {
  const Composition& of = *composition_of(GetParam());
  for (double angle = 1e-3; angle < 0.9999 * of.limit; angle += 1e-3)
    ASSERT_LE(excess(of, angle), 1e-13) << angle;
  double beyond = 0;
  for (double share = 1.00002; share < 1.01; share += 2e-5)
    beyond = std::max(beyond, excess(of, share * of.limit));
  EXPECT_GT(beyond, 1e-8);
  std::printf("order %d: trace at most 2 + %.1e within 1 %% beyond h w = %g\n", of.order, beyond, of.limit);
}

// The limit holds with damping up to c h = 10: eigenvalues of at most 1.
TEST_P(CompositionOf, IsBoundedUpToItsLimitWithDamping) {
  const Composition& of = *composition_of(GetParam());
  for (double damping : {1e-3, 0.01, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0})
    for (double angle = 0.01; angle < 0.9999 * of.limit; angle += 0.01) {
      double m[2][2] = {{1, 0}, {0, 1}};
      for (int k = 0; k <= of.stages; ++k)
        for (auto column : {0, 1}) {
          m[1][column] -= of.kick[k] * angle * angle * m[0][column];
          if (k == of.stages) continue;
          m[0][column] -= std::expm1(-damping * of.drift[k]) / damping * m[1][column];
          m[1][column] *= std::exp(-damping * of.drift[k]);
        }
      // z^2 - T z + D has its roots within the unit circle: |T| <= 1 + D, D <= 1.
      ASSERT_LE(std::abs(m[0][0] + m[1][1]), 1 + std::exp(-damping) + 1e-11) << damping << " " << angle;
    }
}

// One cell that oscillates along the warp: w^2 = 4 k/(rho b^2). It is bounded at 0.99 of the limit. Beyond
// it the method of order 4 grows at once; that of order 6 grows by sqrt(excess) a step in a tongue 0.0003
// wide.
TEST_P(CompositionOf, MovesAnOscillatorWithinItsLimit) {
  scene::FabricSpec fabric;
  fabric.name = "linear";
  fabric.areal_density = 0.15;
  fabric.warp = straight(100);
  for (const double factor : {0.99, GetParam() == 4 ? 1.01 : 1.00013}) {
    Scene scene = rectangle(fabric, 0.01, 0.01, 0.01);
    scene.gravity = {0, 0, 0};
    scene.order = GetParam();
    Assembled a = assemble(scene);
    const Lattice& l = a.system.lattices[0];
    for (int i = 0; i < 2; ++i) a.state.y[l.node(i, 0)] -= 1e-9, a.state.y[l.node(i, 1)] += 1e-9;
    const double h = factor * dynamics::step_limit_of(a.system, a.state.omega2);
    double largest = 0;
    for (int step = 0; step < 60000 && largest < 1; ++step) {
      dynamics::leapfrog_step(a.system, a.motion, a.state, h);
      for (std::size_t n : a.system.particle) largest = std::max(largest, std::abs(a.state.vy[n]) * h);
    }
    if (factor < 1) EXPECT_LT(largest, 1e-9 * 200);
    else EXPECT_GT(largest, 1e-3);
  }
}

// A cloth that swings on two pins: positions, synchronous velocities and pin forces at one time, with `n`
// steps.
struct Swung {
  Eigen::VectorXd r, v;
  double force;    // N, mean of the peg over the advance
  double balance;  // J
};
Swung swung(int order, int n, double damping, bool driven = false,
            const scene::FabricSpec& fabric = smooth_fabric()) {
  Scene scene = rectangle(fabric, 0.054, 0.04, 0.01, true);
  scene::PinSpec pin = reference::pin_at("pegs", {{0, 0.04}, {0.054, 0.04}});
  if (driven) pin.drive = scene::Drive::kBoth;
  scene.pins = {pin};
  scene.order = order;
  scene.damping = damping;
  scene.energy = true;
  scene.communication = 0.02;
  scene.step = scene.communication / n;
  Assembled a = assemble(scene);
  dynamics::energy_begin(a.system, a.state);
  if (driven) {
    a.motion.inputs = dynamics::inputs_at(a.state);
    a.motion.inputs.pin[0].position[0] += 0.01;
    a.motion.inputs.pin[0].position[2] += 0.005;
    a.motion.inputs.pin[0].velocity = {0.3, 0.2, 0};
  }
  std::string event;
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 0.02, event), dynamics::Advance::kDone);
    if (driven) a.motion.inputs.pin[0].position[0] += 0.004;
  }
  std::vector<math::Wrench> load;
  Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
  const dynamics::HalfKick half_kick =
      dynamics::leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, load);
  const dynamics::BalanceNow now =
      dynamics::balance_now(a.system, a.motion.balance, a.state, 0, {vx, vy, vz});
  drape_energy e = dynamics::potential_energy(a.system, a.state);
  e.kinetic = model::kinetic_energy(a.system, vx, vy, vz);
  return {
      positions(a), gathered(a.system, vx, vy, vz),
      (a.state.pin_impulse[0].force[2] + dynamics::last_half(a.system, a.state) * load[0].force[2]) / 0.02,
      dynamics::energy_sum(e) - a.state.energy_start -
          (now.input + a.state.drive_work + half_kick.work_of_drives) + now.dissipated};
}

// Error = C h^p (1 + O(h^2)): halving the step divides it by 2^p. The exact solution is the method of order
// 6 in steps eight times as small as the smallest; its error is 8^-6 of theirs or, at order 4, less.
void expect_order(int order, double damping, bool driven) {
  const Swung exact = swung(6, 512, damping, driven);
  const int first = order == 4 ? 32 : 24;
  std::vector<std::array<double, 4>> errors;
  for (int n : {first, 2 * first, 4 * first}) {
    const Swung s = swung(order, n, damping, driven);
    errors.push_back({(s.r - exact.r).lpNorm<Eigen::Infinity>(), (s.v - exact.v).lpNorm<Eigen::Infinity>(),
                      std::abs(s.force - exact.force), std::abs(s.balance)});
    std::printf("order %d, c = %g%s, %d steps: r %.2e m, v %.2e m/s, force %.2e N, balance %.2e J\n", order,
                damping, driven ? ", driven" : "", n, errors.back()[0], errors.back()[1], errors.back()[2],
                errors.back()[3]);
  }
  for (std::size_t what = 0; what < 3; ++what)
    EXPECT_NEAR(std::log2(errors[0][what] / errors[2][what]) / 2, order, 0.35) << what;
  // The work of accelerating pins is of order 2. Energies of 2e-4 J, sums of a hundred terms, are rounded by
  // at most 3e-18 J, which order 6 reaches after one halving.
  if (driven) EXPECT_NEAR(std::log2(errors[0][3] / errors[2][3]) / 2, 2, 0.35);
  else EXPECT_LE(errors[1][3], 1.5 * errors[0][3] / std::pow(2, order) + 3e-18);
}

// Diagrams are C2 at their points, so the step in which a link passes one errs by h^4: of order 6 only order
// 4 remains, with a small constant.
TEST_P(CompositionOf, HasOrder4AcrossPointsOfDiagrams) {
  scene::FabricSpec fabric = smooth_fabric();
  fabric.warp = reference::diagram({0, 0.002, 0.005, 0.01, 0.02}, {0, 0.002, 0.008, 0.02, 0.06});
  fabric.weft = reference::diagram({0, 0.003, 0.006, 0.012}, {0, 0.002, 0.006, 0.02});
  const Swung exact = swung(6, 2048, 0, false, fabric);
  double before = 0;
  for (int n : {64, 128, 256}) {
    const double error = (swung(GetParam(), n, 0, false, fabric).r - exact.r).lpNorm<Eigen::Infinity>();
    std::printf("order %d across points, %d steps: r %.2e m, slope %.2f\n", GetParam(), n, error,
                std::log2(before / error));
    if (n == 256) {
      EXPECT_NEAR(std::log2(before / error), 4, 0.4);
    }
    before = error;
  }
}

TEST_P(CompositionOf, HasItsOrder) { expect_order(GetParam(), 0, false); }
TEST_P(CompositionOf, HasItsOrderWithDamping) { expect_order(GetParam(), 20, false); }
TEST_P(CompositionOf, HasItsOrderWithDrivenPins) { expect_order(GetParam(), 5, true); }

TEST_P(CompositionOf, GivesTheSameBitsHoweverAMasterGroupsItsSteps) {
  Scene scene = rectangle(reference::curved_fabric(), 0.074, 0.05, 0.01, true);
  scene.pins = {reference::pin_at("corner", {{0, 0.05}})};
  scene.damping = 1;
  scene.order = GetParam();
  const auto advanced = [&](double length, int calls) {
    Assembled a = assemble(scene);
    std::string event;
    for (int k = 0; k < calls; ++k)
      EXPECT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, length, event),
                dynamics::Advance::kDone);
    return a.state;
  };
  const State one = advanced(0.1, 1), hundred = advanced(0.001, 100);
  EXPECT_TRUE(one.x == hundred.x && one.y == hundred.y && one.z == hundred.z);
  EXPECT_TRUE(one.vx == hundred.vx && one.vy == hundred.vy && one.vz == hundred.vz);
  EXPECT_EQ(one.steps, hundred.steps);
}

TEST_P(CompositionOf, GivesTheSameBitsOnThreads) {
  Scene scene = rectangle(reference::curved_fabric(), 0.3, 0.2, 0.01, true);
  scene.pins = {reference::pin_at("corner", {{0, 0.2}})};
  scene.damping = 1;
  scene.order = GetParam();
  const auto moved = [&](int threads) {
    Assembled a = assemble(scene);
    a.motion.workspace = dynamics::workspace_make(a.system, threads);
    std::string event;
    EXPECT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 0.01, event), dynamics::Advance::kDone);
    return positions(a);
  };
  const Eigen::VectorXd one = moved(1);
  EXPECT_TRUE(moved(2) == one);
  EXPECT_TRUE(moved(3) == one);
}

// The mean force of a pin times the time is the momentum that gravity added less the momentum that the cloth
// still has.
TEST_P(CompositionOf, PinsTakeOutExactlyTheMomentumThatIsMissing) {
  for (const double width : {0.05, 0.044}) {
    Scene scene = rectangle(reference::curved_fabric(), width, 0.05, 0.01, true);
    scene.pins = {reference::pin_at("corners", {{0, 0.05}, {width, 0.05}})};
    scene.order = GetParam();
    Assembled a = assemble(scene);
    std::string event;
    std::vector<math::Wrench> load;
    Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
    double before = 0;
    for (int call = 0; call < 10; ++call) {
      ASSERT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 0.003, event),
                dynamics::Advance::kDone);
      dynamics::leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, load);
      double momentum = 0, weight = 0;
      for (std::size_t n : a.system.particle) {
        momentum += a.system.mass[n] * vz[n];
        weight += a.system.mass[n] * a.system.gravity[2];
      }
      const double impulse =
          a.state.pin_impulse[0].force[2] + dynamics::last_half(a.system, a.state) * load[0].force[2];
      EXPECT_NEAR(impulse, weight * 0.003 - (momentum - before), 1e-12 * std::abs(weight)) << width;
      before = momentum;
    }
  }
}

}  // namespace
}  // namespace drape::model
