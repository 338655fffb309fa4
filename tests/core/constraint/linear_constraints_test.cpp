// Pins as constraints: redundancy found, contradictions told, held points held. core/README.md, section 4.
#include <gtest/gtest.h>

#include "cloth_fixture.h"

namespace drape::constraint {

using namespace tests;
namespace {

const std::vector<PinBase> kPins = {{"first"}, {"second"}};

TEST(LinearConstraints, FixesNodesAndKeepsIndependentRows) {
  const Array inverse_mass(6, 2.0);
  const std::vector<ConstraintRow> rows = {
      {0, {0, 1}, {0.5, 0.5}, {1, 0, 0}},  // left with node 1 once node 0 is fixed
      {0, {0}, {1.0}, {0, 0, 0}},
      {1, {2, 3}, {0.25, 0.75}, {5, 0, 0}},
      {1, {2, 3}, {0.75, 0.25}, {3, 0, 0}},
      {1, {2, 3}, {0.5, 0.5}, {4, 0, 0}}};  // the mean of the two before
  std::vector<Problem> problems;
  const Constraints c = constraints_make(rows, inverse_mass, kPins, problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(c.fixed.size(), 2u);
  EXPECT_EQ(c.fixed[1].node, 1u);
  EXPECT_NEAR(c.fixed[1].target.start[0], 2, 1e-15);
  EXPECT_EQ(c.rows.size(), 2u);
}

TEST(LinearConstraints, NamesThePinThatContradicts) {
  const Array inverse_mass(6, 2.0);
  std::vector<Problem> problems;
  constraints_make({{0, {4}, {1.0}, {0, 0, 0}}, {1, {4}, {1.0}, {0.5, 0, 0}}}, inverse_mass, kPins, problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].place, "pin.second");
  constraints_make({{0, {2, 3}, {0.5, 0.5}, {0, 0, 0}}, {1, {2, 3}, {0.5, 0.5}, {0, 0.1, 0}}}, inverse_mass,
                   kPins, problems);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[1].place, "pin.second");
}

// Both long edges pinned on a width of 4.4 cells: one of them lies inside cut cells, each row on two nodes.
TEST(LinearConstraints, HoldsAnEdgeThatLiesInsideCutCells) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.044, 0.06, 0.01, true);
  scene.pins = {reference::pin_edges("left", {3}), reference::pin_edges("right", {1})};
  Assembled a = assemble(scene);
  EXPECT_EQ(a.system.constraints.fixed.size(), 7u);
  EXPECT_EQ(a.system.constraints.rows.size(), 7u);
  std::string event;
  ASSERT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 0.1, event), dynamics::Advance::kDone);
  for (const HeldRow& row : a.system.constraints.rows) {
    Vec3 at{0, 0, 0};
    for (std::size_t k = 0; k < row.on.node.size(); ++k) {
      at[0] += row.on.weight[k] * a.state.x[row.on.node[k]];
      at[1] += row.on.weight[k] * a.state.y[row.on.node[k]];
      at[2] += row.on.weight[k] * a.state.z[row.on.node[k]];
    }
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(at[k], row.target.start[k], 1e-15);
  }
}

}  // namespace
}  // namespace drape::constraint
