// Clamps: hinges between the direction that a pin holds and the links that leave it. Equations:
// core/README.md, sections 3 and 4.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "dynamics/potential_energy.h"
#include "forces/irregular_elements.h"
#include "reference/forces.h"

namespace drape::forces {

using namespace tests;
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct ClampCase {
  const char* name;
  std::vector<Vec2> at;
  std::vector<int> edges;
  std::vector<Vec2> region;
  Shape shape = Shape::kRectangle;
  Vec2 origin{0, 0};  // of the grid, if not at the first point
};
const ClampCase kClamps[] = {{"node", {{0.03, 0.02}}, {}, {}},
                             {"point_in_a_cell", {{0.033, 0.024}}, {}, {}},
                             {"edge_on_a_grid_line", {}, {0}, {}},
                             {"edge_within_cells", {}, {0}, {}, Shape::kRectangle, {0, 0.0063}},
                             {"corner_of_two_edges", {}, {1, 2}, {}, Shape::kRectangle, {0.003, 0.0063}},
                             {"slanted_edge", {}, {0}, {}, Shape::kTriangle},
                             {"region", {}, {}, {{0.017, 0.012}, {0.052, 0.017}, {0.035, 0.041}}},
                             {"edge_with_a_dart", {}, {2, 5}, {}, Shape::kDart, {0, 0.0031}},
                             {"edges_of_slits", {}, {3, 7}, {}, Shape::kSlits},
                             {"region_over_slits",
                              {},
                              {},
                              {{0.022, 0.012}, {0.067, 0.013}, {0.064, 0.047}, {0.021, 0.046}},
                              Shape::kSlits}};

Scene clamped(const ClampCase& c, const scene::FabricSpec& fabric = reference::curved_fabric()) {
  Scene scene = cut_piece(fabric, c.shape);
  if (c.origin != Vec2{0, 0}) scene.pieces[0].grid_origin = c.origin;
  scene::PinSpec pin;
  pin.name = "clamp";
  pin.piece = 0;
  pin.at = c.at;
  pin.edges = c.edges;
  pin.region = c.region;
  pin.clamp = true;
  scene.pins = {pin};
  return scene;
}

// The pin's rotation, about an arbitrary axis.
Eigen::Matrix3d turn_of(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d(2, -1, 3).normalized()).matrix();
}
void turn_pin(Assembled& a, const Eigen::Matrix3d& turn) {
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) a.state.pin_rotation[0][std::size_t(i)][std::size_t(k)] = turn(i, k);
}

Vector3d clamp_torque(const Assembled& a) {
  std::vector<Vec3> torque;
  clamp_torques(a.system, a.state, torque);
  return {torque[0][0], torque[0][1], torque[0][2]};
}

class EveryClamp : public testing::TestWithParam<ClampCase> {};
INSTANTIATE_TEST_SUITE_P(Clamps, EveryClamp, testing::ValuesIn(kClamps),
                         [](const auto& c) { return c.param.name; });

TEST_P(EveryClamp, IsThatOfTheReference) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Assembled a = assemble(clamped(GetParam()));
    ASSERT_FALSE(a.system.irregular.clamps.empty());
    crumple(a, 0.001, seed);
    const Eigen::Matrix3d turn = turn_of(0.1 * seed);
    turn_pin(a, turn);
    const reference::Lattice lattice = reference::lattice_make(a.scene);
    const VectorXd core = forces_by(dynamics::kernel_pick(), a),
                   expected = reference::forces(lattice, positions(a), {turn});
    EXPECT_LE((core - expected).lpNorm<Eigen::Infinity>(), 1e-12 * expected.lpNorm<Eigen::Infinity>());
    VectorXd alone = VectorXd::Zero(core.size());
    const Vector3d couple = reference::add_clamps(lattice, {turn}, positions(a), alone);
    EXPECT_LE((clamp_torque(a) - couple).norm(), 1e-12 * couple.norm());
  }
}

// F = -dE/dr; the torque on the pin is -dE/da for a rotation by a about each axis. Central differences at
// 1e-7 m and rad.
TEST_P(EveryClamp, IsMinusTheGradientOfItsEnergy) {
  scene::FabricSpec fabric = reference::curved_fabric();
  fabric.warp = fabric.weft = fabric.bias = {};
  Assembled a = assemble(clamped(GetParam(), fabric));
  crumple(a, 0.0015, 7);
  const Eigen::Matrix3d turn = turn_of(0.4);
  turn_pin(a, turn);
  const VectorXd force = forces_by(dynamics::kernel_pick(), a);
  const Vector3d torque = clamp_torque(a);
  const double eps = 1e-7;
  const auto energy = [&] { return dynamics::potential_energy(a.system, a.state).bending; };
  expect_minus_gradient(a, force, energy, eps);
  for (int axis = 0; axis < 3; ++axis) {
    double ends[2];
    for (int side : {0, 1}) {
      turn_pin(a, Eigen::AngleAxisd(side ? eps : -eps, Vector3d::Unit(axis)).matrix() * turn);
      ends[side] = energy();
    }
    EXPECT_NEAR(torque[axis], -(ends[1] - ends[0]) / (2 * eps), 1e-6 * torque.norm());
  }
}

// The forces between cloth and pin balance: no net force on the cloth, and its net torque is minus the
// pin's.
TEST_P(EveryClamp, TurnsThePinAgainstTheCloth) {
  Assembled a = assemble(clamped(GetParam()));
  crumple(a, 0.0015, 3);
  turn_pin(a, turn_of(0.7));
  const VectorXd force = forces_by(dynamics::kernel_pick(), a), r = positions(a);
  Vector3d sum = Vector3d::Zero(), torque = sum;
  for (Eigen::Index k = 0; k < r.size(); k += 3) {
    sum += force.segment<3>(k);
    torque += r.segment<3>(k).cross(force.segment<3>(k));
  }
  EXPECT_LE(sum.norm(), 1e-14 * force.lpNorm<1>());
  EXPECT_LE((torque + clamp_torque(a)).norm(), 1e-14 * force.lpNorm<1>() * 0.1);
}

TEST_P(EveryClamp, IsAtRestInFlatCloth) {
  Assembled a = assemble(clamped(GetParam()));
  EXPECT_LE(forces_by(dynamics::kernel_pick(), a).lpNorm<Eigen::Infinity>(), 8 * 600 * 0.01 * 4e-16);
}

}  // namespace
}  // namespace drape::forces
