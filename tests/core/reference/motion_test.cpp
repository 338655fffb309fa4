// The reference solver against exact solutions: falls, hanging cloths, conservation, and the order of
// ERKStep.
#include "reference/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "reference/test_cloth.h"

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Reached {
  VectorXd y;
  long steps;
};

Reached state_at(Motion motion, double time, const Accuracy& accuracy) {
  SolverHandle solver = solver_open(motion, motion_start(motion), accuracy);
  VectorXd y = solver_advance(*solver, time);
  return {y, solver_step_count(*solver)};
}

Course standing(const Motion& motion) { return course_make(motion.lattice, motion.start, motion.start, 1); }

// v = v_inf + (v_0 - v_inf) e^{-ct}, r = r_0 + v_inf t + (v_0 - v_inf)(1 - e^{-ct})/c, v_inf = g/c.
TEST(ReferenceMotion, FallsWithDamping) {
  const double c = 8, t = 0.1, rtol = 1e-12;
  Scene scene = rectangle(curved_fabric(), 0.03, 0.03, 0.01);
  scene.damping = c;
  scene.pieces[0].velocity = {0.3, -0.2, 1};
  const Motion motion = motion_make(scene);
  const auto [y, steps] = state_at(motion, t, {rtol, 8, 0});
  const double fade = std::exp(-c * t);
  const Vector3d v0(0.3, -0.2, 1), v_inf(0, 0, -kG / c);
  const Vector3d v = v_inf + (v0 - v_inf) * fade, moved = v_inf * t + (v0 - v_inf) * (1 - fade) / c;
  const Eigen::Index n = 3 * motion.lattice.count;
  for (Eigen::Index k = 0; k < n; k += 3) {
    EXPECT_LE((y.segment<3>(k) - motion.lattice.position.segment<3>(k) - moved).norm(),
              position_slack(steps, rtol, 0.1, 0.01, 1, t));
    EXPECT_LE((y.segment<3>(n + k) - v).norm(), velocity_slack(steps, rtol, 1));
  }
}

// Spring i, counted from the hem, bears rho g w (i + 1/2) b: its strain is rho g (i + 1/2) b/k.
VectorXd hung_strip(const Lattice& lattice, double b, int cells, double k) {
  VectorXd r = lattice.position;
  for (int j = cells - 1; j >= 0; --j) {
    const double strain = 0.15 * kG * (j + 0.5) * b / k;
    for (int i = 0; i < 2; ++i) {
      r[3 * (2 * j + i) + 2] = r[3 * (2 * (j + 1) + i) + 2] - b * (1 + strain);
    }
  }
  return r;
}

// Case c: the discrete solution is in equilibrium, and a damped strip converges to it. The slowest mode has
// w_1 < pi/2 sqrt(k/rho)/L. With c = 2 w_1 it decays as e^{-c t/2} (1 + c t/2), below 1e-10 after 0.06 s.
TEST(ReferenceMotion, HangingStripComesToItsDiscreteAnswer) {
  const double k = 20, b = 0.01;
  const int cells = 6;
  Scene scene = rectangle(threads(k), b, cells * b, b, true);
  scene.pins = {pin_edges("bar", {2})};
  scene.damping = std::numbers::pi * std::sqrt(k / 0.15) / (cells * b);
  const Motion motion = motion_make(scene);
  const Eigen::Index n = 3 * motion.lattice.count;
  const VectorXd answer = hung_strip(motion.lattice, b, cells, k);

  VectorXd still = motion_start(motion);
  still.head(n) = answer;
  const VectorXd rate = motion_rate(motion, standing(motion), still);
  EXPECT_LE(rate.segment(n, n).lpNorm<Eigen::Infinity>(), 1e-9 * kG);
  const double weight = 0.15 * b * cells * b * kG;
  EXPECT_NEAR(rate[2 * n + 2], -weight, 1e-11 * weight);

  const VectorXd y = state_at(motion, 0.12, {1e-11, 8, 0}).y;
  EXPECT_LE((y.head(n) - answer).lpNorm<Eigen::Infinity>(), 1e-9 * cells * b);
}

// Case d: a strip held at both ends hangs as a chain of equal weights: tan th_{i+1} - tan th_i = m g/H, H the
// pull of the pin on the chain's end along the horizontal.
TEST(ReferenceMotion, SlackStripHangsAsADiscreteCatenary) {
  const double k = 4, b = 0.01, m = 0.15 * b * b / 2;
  const int cells = 8;
  Scene scene = rectangle(threads(k), b, cells * b, b);
  scene.pins = {pin_edges("near", {0}), pin_edges("far", {2})};
  scene.damping = 60;
  const Motion motion = motion_make(scene);
  const Eigen::Index n = 3 * motion.lattice.count;
  const VectorXd y = state_at(motion, 1.2, {1e-11, 8, 0}).y;
  const VectorXd rate = motion_rate(motion, standing(motion), y);
  ASSERT_LE(rate.segment(n, n).lpNorm<Eigen::Infinity>(), 1e-7 * kG);  // it is at rest

  const double H = rate[2 * n + 1] / 2;  // of each of the two threads, along y
  const auto slope = [&](int j) {
    const Vector3d d = y.segment<3>(3 * (2 * (j + 1))) - y.segment<3>(3 * (2 * j));
    return d[2] / d[1];
  };
  EXPECT_LT(slope(0), -0.2);  // it does sag
  for (int j = 0; j + 1 < cells; ++j) {
    EXPECT_NEAR(slope(j + 1) - slope(j), m * kG / H, 1e-6 * m * kG / H) << "joint " << j;
  }
}

// The slope over a halving is P where the first term of the error dominates; the next term can imitate one
// order more.
TEST(ReferenceMotion, EachMethodShowsItsOrder) {
  const Motion motion = motion_make(smooth_scene());
  const double until = 0.016;
  const VectorXd exact = state_at(motion, until, {1e-10, 8, until / 160}).y;
  const std::map<int, int> first_count{{2, 256}, {3, 256}, {4, 256}, {5, 64}, {6, 32}, {8, 20}};
  for (auto [order, count] : first_count) {
    double error[2];
    for (int k : {0, 1}) {
      const VectorXd y = state_at(motion, until, {1e-10, order, until / (count << k)}).y;
      error[k] = (y - exact).head(6 * motion.lattice.count).norm();
    }
    const double slope = std::log2(error[0] / error[1]);
    EXPECT_GE(slope, order - 0.1) << "order " << order << ", errors " << error[0] << " " << error[1];
    EXPECT_LE(slope, order + 1) << "order " << order << ", errors " << error[0] << " " << error[1];
  }
}

TEST(ReferenceMotion, ErrorStaysWithinTheTolerance) {
  const Motion motion = motion_make(smooth_scene());
  const double until = 0.05;
  const Eigen::Index n = 3 * motion.lattice.count;
  const VectorXd exact = state_at(motion, until, {1e-12, 8, 5e-5}).y;
  for (int order : {4, 5, 6, 8}) {
    for (double rtol : {1e-6, 1e-8, 1e-10, 1e-12}) {
      const auto [y, steps] = state_at(motion, until, {rtol, order, 0});
      EXPECT_LE((y - exact).head(n).lpNorm<Eigen::Infinity>(),
                position_slack(steps, rtol, 0.04, 0.01, 0.5, until))
          << "order " << order << ", rtol " << rtol;
    }
  }
}

// Every Runge-Kutta step keeps linear relations between the states: M v + c M (r - r_0) + J = M v_0 + M g t.
// The point of one pin lies in a cell of which the other pin fixes a corner.
TEST(ReferenceMotion, PinsReceiveAllMomentum) {
  Scene scene = smooth_scene();
  scene.pieces[0].velocity = {0.1, 0.2, -0.3};
  scene.pins[1] = pin_at("beside", {{0.004, 0.006}});
  const Motion motion = motion_make(scene);
  const double t = 0.03;
  const VectorXd y = state_at(motion, t, {1e-8, 5, 0}).y;
  const Lattice& lattice = motion.lattice;
  const Eigen::Index n = 3 * lattice.count;
  Vector3d moved = Vector3d::Zero(), momentum = Vector3d::Zero(), start = Vector3d::Zero();
  double mass = 0;
  for (int k = 0; k < lattice.count; ++k) {
    const double m = lattice.mass[std::size_t(k)];
    mass += m;
    moved += m * (y.segment<3>(3 * k) - lattice.position.segment<3>(3 * k));
    momentum += m * y.segment<3>(n + 3 * k);
    start += m * lattice.velocity.segment<3>(3 * k);
  }
  const Vector3d J = y.segment<3>(2 * n) + y.segment<3>(2 * n + 3);
  const Vector3d balance = momentum + scene.damping * moved + J - start - mass * motion.gravity * t;
  EXPECT_LE(balance.norm(), 1e-12 * (J.norm() + mass * kG * t));
}

// Five points inside one cell are held by its four particles: four independent rows.
TEST(ReferenceMotion, KeepsIndependentRowsOnly) {
  Scene scene = smooth_scene();
  scene.pins = {
      pin_at("all", {{0.011, 0.012}, {0.018, 0.013}, {0.012, 0.018}, {0.017, 0.017}, {0.015, 0.015}})};
  const Motion motion = motion_make(scene);
  ASSERT_EQ(motion.lattice.rows.size(), 5u);
  EXPECT_EQ(motion.held.A.rows(), 4);
  VectorXd x = crumpled(motion.lattice, 1, 2);
  const std::vector<Vector3d> still(5, Vector3d::Zero());
  constraints_project(motion.lattice, motion.held, still, still, x);
  for (const Row& row : motion.lattice.rows) EXPECT_LE(point_value(row.point, x).norm(), 1e-12);
}

}  // namespace
}  // namespace drape::reference
