// The rows of the reference solver: columns, outputs against exact solutions, and messages where it cannot
// run.
#include "reference/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/test_cloth.h"

namespace drape::reference {
namespace {

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  std::vector<std::string> errors;
  int status = 0;

  double at(std::size_t row, const std::string& name) const {
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == name) return rows[row][k];
    }
    ADD_FAILURE() << "no column " << name;
    return std::nan("");
  }
};

Table run_table(const Scene& scene, const Options& options) {
  Table t;
  t.status = reference_run(
      scene, options,
      {[&](const auto& names) { t.names = names; }, [&](const auto& row) { t.rows.push_back(row); },
       [&](const auto& error) { t.errors.push_back(error); }});
  return t;
}

// One cell hung from its upper edge: each lower particle is a damped oscillator, x'' = g - c x' - w^2 x with
// w^2 = (k/2)/m and x the displacement downwards. The pins bear their own weight and the yarns: -2 (m g +
// k/2 mean x). By the equation itself mean x = (g - [v + c x]/t)/w^2.
TEST(ReferenceRun, HangingCellSwingsExactly) {
  const double k = 40, b = 0.01, m = 0.15 * b * b / 4, c = 60, rtol = 1e-11;
  Scene scene = rectangle(threads(k), b, b, b, true);
  scene.damping = c;
  scene.pins = {pin_edges("bar", {2})};
  scene.probes = {{"hem", 0, {b / 2, 0}}};
  scene.duration = 0.02;
  const Table table = run_table(scene, {rtol, 8, 0, 0.0007, false});
  ASSERT_EQ(table.status, 0) << (table.errors.empty() ? "" : table.errors[0]);
  ASSERT_EQ(table.rows.size(), 30u);
  EXPECT_EQ(table.rows.back()[0], 0.02);

  const double w2 = k / 2 / m, W = std::sqrt(w2 - c * c / 4);
  const auto x = [&](double t) {
    return kG / w2 * (1 - std::exp(-c * t / 2) * (std::cos(W * t) + c / (2 * W) * std::sin(W * t)));
  };
  const auto v = [&](double t) { return kG / W * std::exp(-c * t / 2) * std::sin(W * t); };
  EXPECT_NEAR(table.at(0, "pin.bar.force[3]"), -2 * m * kG, 1e-13 * m * kG);
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const double t = table.at(i, "time"), before = table.at(i - 1, "time");
    // An error dv of the velocity oscillates as dv/W in the position; J is controlled to rtol times 4 m 1
    // m/s.
    const long steps = std::lround(table.at(i, "step.count"));
    const double slack_v = velocity_slack(steps, rtol, kG / W),
                 slack_x = position_slack(steps, rtol, b, b, kG / W, 1 / W);
    EXPECT_NEAR(table.at(i, "probe.hem.position[3]"), -x(t), slack_x);
    EXPECT_NEAR(table.at(i, "probe.hem.velocity[3]"), -v(t), slack_v);
    EXPECT_NEAR(table.at(i, "strain.warp.max"), x(t) / b, slack_x / b);
    EXPECT_NEAR(table.at(i, "tension.max"), k * x(t) / b, k * slack_x / b);
    const double mean_x = (kG - (v(t) - v(before) + c * (x(t) - x(before))) / (t - before)) / w2;
    const double slack_J = double(steps) * rtol * 4 * m * (1 + kG * t);
    EXPECT_NEAR(table.at(i, "pin.bar.force[3]"), -2 * (m * kG + k / 2 * mean_x),
                k * slack_x + 2 * slack_J / (t - before));
  }
}

// A point inside a cell stays at its position although all four particles around it move.
TEST(ReferenceRun, HoldsPointsInsideCells) {
  Scene scene = smooth_scene();
  scene.probes = {{"held", 0, {0.017, 0.024}}, {"free", 0, {0.03, 0.03}}};
  scene.duration = 0.03;
  const Table table = run_table(scene, {1e-10, 8, 0, 0, false});
  ASSERT_EQ(table.status, 0) << (table.errors.empty() ? "" : table.errors[0]);
  const std::size_t last = table.rows.size() - 1;
  EXPECT_NEAR(table.at(last, "probe.held.position[1]"), 0.017, 1e-15);
  EXPECT_NEAR(table.at(last, "probe.held.position[2]"), 0.024, 1e-15);
  EXPECT_NEAR(table.at(last, "probe.held.position[3]"), 0, 1e-15);
  EXPECT_GT(std::abs(table.at(last, "probe.free.position[3]")), 1e-3);
}

// Undamped, the energy moves only by the integrator's error: each step's rtol (|v| + 1 m/s) times m |v|.
TEST(ReferenceRun, KeepsEnergyWithoutDamping) {
  Scene scene = rectangle(curved_fabric(), 0.03, 0.04, 0.01);
  scene.pins = {pin_at("corners", {{0, 0.04}, {0.03, 0.04}})};
  scene.duration = 0.08;
  scene.energy = true;
  const Table table = run_table(scene, {1e-11, 8, 0, 0, false});
  ASSERT_EQ(table.status, 0) << (table.errors.empty() ? "" : table.errors[0]);
  const auto total = [&](std::size_t row) {
    double sum = 0;
    for (const char* kind : {"kinetic", "stretch", "shear", "bending", "gravity"}) {
      sum += table.at(row, std::string("energy.") + kind);
    }
    return sum;
  };
  const std::size_t last = table.rows.size() - 1;
  EXPECT_GT(table.at(last, "energy.stretch"), 0);
  EXPECT_GT(table.at(last, "energy.shear"), 0);
  EXPECT_GT(table.at(last, "energy.bending"), 0);
  const double steps = table.at(last, "step.count"), speed = 1, mass = 0.15 * 0.03 * 0.04;
  EXPECT_NEAR(total(last), total(0), steps * 1e-11 * mass * speed * (speed + 1));
}

TEST(ReferenceRun, RowsMatchTheirColumns) {
  Scene scene = smooth_scene();
  scene.energy = true;
  scene.probes = {{"hem", 0, {0.015, 0}}};
  const Table table = run_table(scene, {1e-6, 5, 0.01, 0.004, true});
  ASSERT_EQ(table.status, 0) << (table.errors.empty() ? "" : table.errors[0]);
  ASSERT_EQ(table.rows.size(), 4u);  // 0, 0.004, 0.008, 0.01
  EXPECT_EQ(table.rows[3][0], 0.01);
  EXPECT_EQ(table.names.size(), 1 + 6 + 9 + 4 + 2 * 6 + 8 + 2 * 3 * 16u);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.names.size());
  EXPECT_EQ(table.at(0, "node.position[2,1]"), 0.01);
  EXPECT_EQ(table.at(0, "node.position[16,2]"), 0.03);
  EXPECT_EQ(table.at(0, "step.count"), 0);
  EXPECT_GT(table.at(3, "step.size"), 0);
  EXPECT_EQ(table.at(0, "strain.beyond_test.count"), 0);
}

TEST(ReferenceRun, CountsLinksBeyondTheirTest) {
  scene::FabricSpec fabric = threads(40);
  fabric.warp = diagram({0, 0.001}, {0, 0.001 * 40 * 0.05});
  Scene scene = rectangle(fabric, 0.01, 0.02, 0.01, true);
  scene.pins = {pin_edges("bar", {2})};
  scene.damping = 1000;
  const Table table = run_table(scene, {1e-10, 8, 0.1, 0.05, false});
  ASSERT_EQ(table.status, 0) << (table.errors.empty() ? "" : table.errors[0]);
  const double strain = 0.15 * kG * 0.01 / 40;  // of half a cell's weight: 1.8e-4 below, 5.5e-4 above
  EXPECT_NEAR(table.at(2, "strain.warp.min"), strain / 2, 1e-9);
  EXPECT_NEAR(table.at(2, "strain.warp.max"), 3 * strain / 2, 1e-9);
  EXPECT_NEAR(table.at(2, "strain.warp.mean"), strain, 1e-9);
  EXPECT_EQ(table.at(2, "strain.beyond_test.count"), 0);
  scene.fabrics[0].warp = diagram({0, 0.0003}, {0, 0.0003 * 40 * 0.05});
  EXPECT_EQ(run_table(scene, {1e-10, 8, 0.1, 0.05, false}).at(2, "strain.beyond_test.count"), 2);
}

TEST(ReferenceRun, RefusesBadOptionsOneSentenceEach) {
  const Table table = run_table(smooth_scene(), {1e-20, 9, -1, std::nan(""), false});
  EXPECT_EQ(table.status, 1);
  ASSERT_EQ(table.errors.size(), 4u);
  EXPECT_EQ(table.errors[1], "order is 9; allowed: 2 to 8");
  EXPECT_TRUE(table.rows.empty());
}

TEST(ReferenceRun, FailsWithTimeAndFlag) {
  Scene scene = smooth_scene();
  scene.gravity[2] = std::numeric_limits<double>::infinity();
  const Table table = run_table(scene, {});
  EXPECT_EQ(table.status, 2);
  ASSERT_EQ(table.errors.size(), 1u);
  EXPECT_NE(table.errors[0].find("failed at t = 0 s"), std::string::npos) << table.errors[0];
  EXPECT_NE(table.errors[0].find("ARKODE flag -"), std::string::npos) << table.errors[0];
}

}  // namespace
}  // namespace drape::reference
