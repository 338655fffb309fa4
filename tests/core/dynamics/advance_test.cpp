// The integrator against its own exact discrete solutions. Equations: core/README.md, section 4.
#include <gtest/gtest.h>

#include <cmath>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "dynamics/potential_energy.h"
#include "validation/load.h"

namespace drape::dynamics {

using namespace tests;
namespace {

using reference::rectangle;
using reference::straight;

scene::FabricSpec linear_fabric(double warp, double weft, double bias) {
  scene::FabricSpec f;
  f.name = "linear";
  f.areal_density = 0.15;
  if (warp > 0) f.warp = straight(warp);
  if (weft > 0) f.weft = straight(weft);
  if (bias > 0) f.bias = reference::diagram({0, 0.1}, {0, 0.1 * bias * 0.05});
  return f;
}

// One cell that oscillates along the warp: four nodes of mass rho b^2/4, two linear links of half width. The
// lattice is one oscillator with w^2 = 4 k/(rho b^2), for which leapfrog conserves v^2/2 + w^2 x^2 (1 - h^2
// w^2/4)/2 exactly.
TEST(Leapfrog, ConservesItsDiscreteEnergyForAMillionSteps) {
  Scene scene = rectangle(linear_fabric(100, 0, 0), 0.01, 0.01, 0.01);
  scene.gravity = {0, 0, 0};
  Assembled a = assemble(scene);
  const double w2 = 4 * 100 / (0.15 * 1e-4), h = 0.7 / std::sqrt(w2);
  const std::size_t low = a.system.lattices[0].node(0, 0), high = a.system.lattices[0].node(0, 1);
  for (int i = 0; i < 2; ++i) {
    a.state.y[low + std::size_t(i)] -= 2e-3;
    a.state.y[high + std::size_t(i)] += 2e-3;
  }
  const auto invariant = [&] {
    std::vector<math::Wrench> pins;
    Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
    leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, pins);
    const double x = (a.state.y[high] - a.state.y[low] - 0.01) / 2, v = (vy[high] - vy[low]) / 2;
    return v * v / 2 + w2 * x * x * (1 - h * h * w2 / 4) / 2;
  };
  const double start = invariant();
  double worst = 0;
  for (int step = 1; step <= 1000000; ++step) {
    leapfrog_step(a.system, a.motion, a.state, h);
    if (step <= 100 || step % 1000 == 0) worst = std::max(worst, std::abs(invariant() / start - 1));
  }
  // 1e6 roundings of 1e-16 of the cell (5 times the amplitude) add up as a random walk: 1e3 x 5e-16.
  EXPECT_LE(worst, 1e-12);
  std::printf("invariant after 1e6 steps: worst relative change %.2e\n", worst);
}

// v_{n+1/2} = v_{n-1/2} (1 - hc/2)/(1 + hc/2) + h g/(1 + hc/2); the first kick is half a step.
TEST(Leapfrog, FallsThroughAirByItsOwnRecurrence) {
  for (Shape shape : {Shape::kRectangle, Shape::kDiscWithHole, Shape::kDart}) {
    Scene scene = cut_piece(linear_fabric(100, 100, 10), shape);
    scene.damping = 3;
    Assembled a = assemble(scene);
    const double h = 1e-4, c = 3, g = -9.81;
    double v = (h / 2 * g) / (1 + h * c / 2), z = h * v;
    leapfrog_step(a.system, a.motion, a.state, h);
    for (int step = 1; step < 1000; ++step) {
      leapfrog_step(a.system, a.motion, a.state, h);
      v = v * (1 - h * c / 2) / (1 + h * c / 2) + h * g / (1 + h * c / 2);
      z += h * v;
    }
    for (std::size_t n : a.system.particle) {
      EXPECT_NEAR(a.state.vz[n], v, 1e-12 * std::abs(v));
      EXPECT_NEAR(a.state.z[n], z, 1e-12 * std::abs(z));
    }
  }
}

// Case i on pieces with a hole and with a slit cell. Straight warp yarns alone, moved along themselves, are
// a linear system M u'' = -K u, for which leapfrog conserves v_{n+1/2} M v_{n+1/2}/2 + u_n K u_{n+1}/2.
TEST(Leapfrog, ConservesTheDiscreteEnergyOfCutPieces) {
  for (Shape shape : {Shape::kDiscWithHole, Shape::kDart}) {
    Scene scene = cut_piece(linear_fabric(100, 0, 0), shape);
    scene.gravity = {0, 0, 0};
    Assembled a = assemble(scene);
    const State rest = a.state;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> shift(-1e-3, 1e-3);
    for (std::size_t n : a.system.particle) a.state.y[n] += shift(random);
    const double h = 0.35 * 2 / std::sqrt(a.state.omega2);
    Array fx(a.system.nodes), fy(a.system.nodes), fz(a.system.nodes);
    const auto step_energy = [&] {
      kernel_forces(*a.motion.kernel, a.system, a.state, a.motion.workspace,
                    {fx.data(), fy.data(), fz.data()});
      leapfrog_step(a.system, a.motion, a.state, h);
      double sum = 0;
      for (std::size_t n : a.system.particle)
        sum += a.system.mass[n] * a.state.vy[n] * a.state.vy[n] - fy[n] * (a.state.y[n] - rest.y[n]);
      return sum / 2;
    };
    step_energy();  // the half kick of the start
    const double start = step_energy();
    double worst = 0;
    for (int step = 0; step < 100000; ++step) worst = std::max(worst, std::abs(step_energy() / start - 1));
    // Positions of up to 0.08 m are rounded by 1e-17 m a step, 1e-14 of the amplitude. 1e5 random roundings
    // give 300 times that, over some 80 particles.
    EXPECT_LE(worst, 1e-12) << shape_name(shape);
    std::printf("%s: invariant after 1e5 steps, worst relative change %.2e\n", shape_name(shape), worst);
  }
}

// A closed system keeps linear and angular momentum: forces are equal and opposite, and along or normal to
// their links.
class ClosedSystem : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, ClosedSystem,
                         testing::Values(Shape::kRectangle, Shape::kDiscWithHole, Shape::kDart,
                                         Shape::kSlits),
                         [](const auto& shape) { return shape_name(shape.param); });
TEST_P(ClosedSystem, KeepsItsMomentum) {
  Scene scene = cut_piece(reference::curved_fabric(), GetParam());
  scene.gravity = {0, 0, 0};
  Assembled a = assemble(scene);
  crumple(a, 0.002, 2);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> speed(-1, 1);
  for (std::size_t n : a.system.particle) {
    a.state.vx[n] = speed(random);
    a.state.vy[n] = speed(random);
    a.state.vz[n] = speed(random);
  }
  using V = Eigen::Vector3d;
  const double h = 0.3 * step_limit_of(a.system, step_limit_omega2(a.system, *a.motion.kernel, a.state));
  leapfrog_step(a.system, a.motion, a.state, h);
  // Leapfrog's angular momentum, sum m r_n x v_{n+1/2} = sum m r_{n+1} x v_{n+1/2}, is constant in each kick
  // and drift.
  const auto momenta = [&] {
    V linear = V::Zero(), angular = V::Zero();
    for (std::size_t n : a.system.particle) {
      const V p = a.system.mass[n] * V(a.state.vx[n], a.state.vy[n], a.state.vz[n]);
      linear += p;
      angular += V(a.state.x[n], a.state.y[n], a.state.z[n]).cross(p);
    }
    return std::pair(linear, angular);
  };
  double scale = 0;
  for (std::size_t n : a.system.particle) scale += a.system.mass[n];
  const auto [linear, angular] = momenta();
  for (int step = 0; step < 10000; ++step) leapfrog_step(a.system, a.motion, a.state, h);
  const auto [linear_end, angular_end] = momenta();
  EXPECT_LE((linear_end - linear).norm(), 1e-12 * scale);
  EXPECT_LE((angular_end - angular).norm(), 1e-12 * scale * 0.1);
  std::printf("1e4 steps: linear momentum moved %.2e, angular %.2e (relative)\n",
              (linear_end - linear).norm() / scale, (angular_end - angular).norm() / (scale * 0.1));
}

// Case c, linear: a strip hung by its top edge. Link i from the top bears rho g w (L - (i + 1/2) b), so at
// rest its strain is that over k w. The strip starts with these strains, and nothing may move.
TEST(Leapfrog, HoldsAHangingStripAtItsExactRest) {
  const double b = 0.01, length = 0.2, k = 400, rho = 0.15, g = 9.81;
  Scene scene = rectangle(linear_fabric(k, 0, 0), 0.03, length, b, true);
  scene.pins = {reference::pin_edges("bar", {2})};
  Assembled a = assemble(scene);
  const model::Lattice& l = a.system.lattices[0];
  std::vector<double> at(std::size_t(l.rows), length);
  for (int link = 0; link < l.rows - 1; ++link) {
    const double strain = rho * g * (length - (link + 0.5) * b) / k;
    at[std::size_t(l.rows - 2 - link)] = at[std::size_t(l.rows - 1 - link)] - b * (1 + strain);
  }
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) a.state.z[l.node(i, j)] = at[std::size_t(j)];
  std::string event;
  EXPECT_EQ(leapfrog_advance(a.system, a.motion, a.state, 1.0, event), Advance::kDone);
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i)
      EXPECT_NEAR(a.state.z[l.node(i, j)], at[std::size_t(j)], 1e-9 * length);
}

// Case k: a linear lattice is bounded at 0.99 of the step limit and grows at 1.01 of it, without and with
// damping along springs and -m c v (which is centred and does not change leapfrog's limit). Yarns that move
// along themselves, neighbours in opposite directions, reach the bound exactly in a strip and wherever the
// outline cuts, because widths and masses shrink together.
struct LimitCase {
  const char* name;
  Shape shape;
  scene::Integrator integrator = scene::Integrator::kLeapfrog;
  double xi = 0;     // beta omega/2
  double along = 0;  // c/omega
};
const LimitCase kLimits[] = {{"rectangle", Shape::kRectangle},
                             {"disc_with_hole", Shape::kDiscWithHole},
                             {"dart", Shape::kDart},
                             {"slightly_damped", Shape::kDart, scene::Integrator::kLeapfrog, 0.05},
                             {"damped", Shape::kDiscWithHole, scene::Integrator::kLeapfrog, 0.7, 0.3},
                             {"paper", Shape::kDart, scene::Integrator::kPaper, 0, 0.3},
                             {"paper_damped", Shape::kDart, scene::Integrator::kPaper, 0.1, 0.3}};

class StepLimitOf : public testing::TestWithParam<LimitCase> {};
INSTANTIATE_TEST_SUITE_P(Cases, StepLimitOf, testing::ValuesIn(kLimits),
                         [](const auto& c) { return c.param.name; });

TEST_P(StepLimitOf, IsWhereALinearLatticeBeginsToGrow) {
  const double omega = std::sqrt(4 * 100 / (0.15 * 1e-4));
  for (const double factor : {0.99, 1.01}) {
    scene::FabricSpec fabric = linear_fabric(100, 0, 0);
    fabric.damping = 2 * GetParam().xi / omega;
    Scene scene = cut_piece(fabric, GetParam().shape);
    scene.gravity = {0, 0, 0};
    scene.damping = GetParam().along * omega;
    scene.integrator = GetParam().integrator;
    Assembled a = assemble(scene);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-1e-9, 1e-9);
    for (std::size_t n : a.system.particle) a.state.y[n] += shift(random);
    const double h = factor * step_limit_of(a.system, a.state.omega2);
    double largest = 0;
    for (int step = 0; step < 3000; ++step) {
      leapfrog_step(a.system, a.motion, a.state, h);
      for (std::size_t n : a.system.particle) largest = std::max(largest, std::abs(a.state.vy[n]));
    }
    if (factor < 1) EXPECT_LT(largest, 1e-9 / h * 200);
    else EXPECT_GT(largest, 1.0);
  }
}

State advanced(const Scene& scene, double length, int calls) {
  Assembled a = assemble(scene);
  std::string event;
  for (int k = 0; k < calls; ++k)
    EXPECT_EQ(leapfrog_advance(a.system, a.motion, a.state, length, event), Advance::kDone);
  return a.state;
}

TEST(Leapfrog, GivesTheSameBitsHoweverAMasterGroupsItsSteps) {
  Scene scene = rectangle(reference::curved_fabric(), 0.074, 0.05, 0.01, true);
  scene.pins = {reference::pin_at("corner", {{0, 0.05}})};
  scene.damping = 1;
  const State one = advanced(scene, 0.2, 1), ten = advanced(scene, 0.02, 10),
              hundred = advanced(scene, 0.002, 100);
  for (const State* s : {&ten, &hundred}) {
    EXPECT_TRUE(s->x == one.x && s->y == one.y && s->z == one.z);
    EXPECT_TRUE(s->vx == one.vx && s->vy == one.vy && s->vz == one.vz);
    EXPECT_EQ(s->steps, one.steps);
  }
}

// A run that reaches numbers that are not finite leaves nothing behind in its workspace: after the previous
// state is restored, the cloth moves as if nothing had happened. A disc, whose rows have different lengths.
TEST(Leapfrog, GoesOnFromAGoodStateAfterABadOne) {
  Scene scene = cut_piece(reference::curved_fabric(), Shape::kRectangle);
  scene.pieces[0].outline = circle({0.2, 0.2}, 0.19, 64);
  for (const bool air : {false, true}) {
    scene.has_air = air;
    scene.air_normal = air ? 1.1 : 0;
    Assembled a = assemble(scene), fresh = assemble(scene);
    std::string event;
    for (std::size_t k = 0; k < a.system.particle.size(); k += 97) {
      const State good = a.state;
      a.state.x[a.system.particle[k]] = NAN;
      EXPECT_EQ(leapfrog_advance(a.system, a.motion, a.state, 1e-3, event), Advance::kNotFinite);
      a.state = good;
      ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 1e-3, event), Advance::kDone) << k;
      ASSERT_EQ(leapfrog_advance(fresh.system, fresh.motion, fresh.state, 1e-3, event), Advance::kDone);
      ASSERT_EQ(a.state.x, fresh.state.x);
      ASSERT_EQ(a.state.vz, fresh.state.vz);
    }
  }
}

// The mean force of a pin times the time is the momentum that gravity added less the momentum that the cloth
// still has.
TEST(Leapfrog, PinsTakeOutExactlyTheMomentumThatIsMissing) {
  // 0.05 m: corners on nodes; 0.044 m: one corner inside a cut cell, a row on two nodes.
  for (const auto& [integrator, width] : {std::pair{scene::Integrator::kLeapfrog, 0.05},
                                          {scene::Integrator::kLeapfrog, 0.044},
                                          {scene::Integrator::kPaper, 0.05},
                                          {scene::Integrator::kPaper, 0.044}}) {
    Scene scene = rectangle(reference::curved_fabric(), width, 0.05, 0.01, true);
    scene.pins = {reference::pin_at("corners", {{0, 0.05}, {width, 0.05}})};
    scene.integrator = integrator;
    Assembled a = assemble(scene);
    std::string event;
    std::vector<math::Wrench> force;
    Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
    double before = 0;
    for (int call = 0; call < 30; ++call) {
      ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 0.003, event), Advance::kDone);
      leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, force);
      double momentum = 0, weight = 0;
      for (std::size_t n : a.system.particle) {
        momentum += a.system.mass[n] * vz[n];
        weight += a.system.mass[n] * a.system.gravity[2];
      }
      const double last_half = integrator == scene::Integrator::kPaper ? 0 : a.state.h_old / 2;
      const double impulse = a.state.pin_impulse[0].force[2] + last_half * force[0].force[2];
      EXPECT_NEAR(impulse, weight * 0.003 - (momentum - before), 1e-12 * std::abs(weight))
          << width << " call " << call;
      before = momentum;
    }
  }
}

// A communication step off the grid is an interval of its own, and the grid restarts at its end. The order
// stays 2.
TEST(Leapfrog, TakesCommunicationStepsOffTheGrid) {
  Scene scene = rectangle(linear_fabric(100, 100, 10), 0.05, 0.03, 0.01);
  Assembled a = assemble(scene);
  std::string event;
  const double lengths[] = {0.0005, 0.00123, 0.0021, 0.001, 0.0177};
  double time = 0;
  for (double length : lengths) {
    ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, length, event), Advance::kDone);
    time += length;
    EXPECT_NEAR(model::state_time(a.state, a.system.communication), time, 1e-15);
  }
  // Free fall by leapfrog with steps h_k: z = g sum h_k (t_k + h_k/2) = g t^2/2 exactly.
  for (std::size_t n : a.system.particle) EXPECT_NEAR(a.state.z[n], -9.81 * time * time / 2, 1e-14);
}

// The time is a count times the interval: it gathers no rounding, however many steps there were.
TEST(Leapfrog, KeepsTheTimeOfABillionIntervals) {
  Scene scene = rectangle(linear_fabric(100, 0, 0), 0.01, 0.01, 0.01);
  scene.communication = 0.001;
  Assembled a = assemble(scene);
  a.state.tick = 1'000'000'000;
  for (int k = 1; k <= 100; ++k) {
    advance(a, 0.001);
    EXPECT_EQ(model::state_time(a.state, 0.001), 0.001 * (1e9 + k));
  }
  advance(a, 0.1);
  EXPECT_EQ(model::state_time(a.state, 0.001), 0.001 * (1e9 + 200));
}

// The limit falls when the cloth stiffens under load, and the step with it. The step grows again after 100
// intervals without a change.
TEST(Leapfrog, FollowsTheStepLimitDownAndUp) {
  Scene scene = rectangle(reference::curved_fabric(), 0.02, 0.3, 0.01, true);
  scene.pins = {reference::pin_edges("bar", {2})};
  scene.fabrics[0].warp = reference::diagram({0, 0.001, 0.002, 0.003}, {0, 0.005, 0.05, 0.5});
  scene.damping = 20;
  Assembled a = assemble(scene);
  const std::int64_t start = a.state.steps_per_interval;
  std::int64_t largest = start;
  std::string event;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 0.001, event), Advance::kDone);
    largest = std::max(largest, a.state.steps_per_interval);
    EXPECT_LT(0.001 / double(a.state.steps_per_interval),
              step_limit_of(a.system, step_limit_omega2(a.system, *a.motion.kernel, a.state)));
  }
  EXPECT_GT(largest, start);
  EXPECT_LT(a.state.steps_per_interval, largest);
}

// An interval that began with steps far above the limit is finished with smaller ones, and keeps its length:
// free fall by leapfrog is exact for any steps.
TEST(Leapfrog, HalvesTheStepsLeftOfAnInterval) {
  Assembled a = assemble(reference::rectangle(reference::curved_fabric(), 0.05, 0.03, 0.01));
  a.state.steps_per_interval /= 4;
  a.state.steps_to_limit_check = 3;  // the first check of the limit comes in the middle of the interval
  const std::int64_t few = a.state.steps_per_interval;
  ASSERT_GE(few, 4);
  std::string event;
  ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 0.001, event), Advance::kDone);
  EXPECT_GT(a.state.steps_per_interval, few);
  EXPECT_EQ(a.state.steps, 3 + (few - 3) * 4);  // four times as many again
  for (std::size_t n : a.system.particle) EXPECT_NEAR(a.state.z[n], -9.81 * 1e-6 / 2, 1e-19);
}

}  // namespace
}  // namespace drape::dynamics
