// The common suite of every force: against the reference solver, against its own energy, and against the
// symmetries of space. Equations: core/README.md, section 3.
#include <gtest/gtest.h>

#include <numbers>

#include <Eigen/Geometry>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "dynamics/potential_energy.h"
#include "forces/hinge_energy.h"
#include "model/elements.h"
#include "reference/forces.h"

namespace drape::forces {

using namespace tests;
namespace {

struct LawCase {
  const char* name;
  bool warp, weft, bias, bending;
  scene::BiasModel model = scene::BiasModel::kOdd;
  double crumple = 0.15;  // of a cell: strains to 30 %, folds to 60 degrees
  scene::Scaling scaling = scene::Scaling::kWidth;
  Shape shape = Shape::kRectangle;
};

const LawCase kLaws[] = {
    {"warp", true, false, false, false},
    {"weft", false, true, false, false},
    {"bias_odd", false, false, true, false},
    {"bias_tension", false, false, true, false, scene::BiasModel::kTension},
    {"bias_paper", false, false, true, false, scene::BiasModel::kPaper},
    {"bending", false, false, false, true},
    {"bending_sharp_folds", false, false, false, true, scene::BiasModel::kOdd, 0.8},
    {"paper_area", true, true, true, true, scene::BiasModel::kOdd, 0.15, scene::Scaling::kPaperArea},
    {"all", true, true, true, true},
    {"all_sharp_folds", true, true, true, true, scene::BiasModel::kOdd, 0.8},
    {"stretch_dart", true, true, false, false, scene::BiasModel::kOdd, 0.15, scene::Scaling::kWidth,
     Shape::kDart},
    {"shear_slits", false, false, true, false, scene::BiasModel::kOdd, 0.15, scene::Scaling::kWidth,
     Shape::kSlits},
    {"bending_dart", false, false, false, true, scene::BiasModel::kOdd, 0.15, scene::Scaling::kWidth,
     Shape::kDart},
    {"bending_slits", false, false, false, true, scene::BiasModel::kOdd, 0.8, scene::Scaling::kWidth,
     Shape::kSlits},
    {"all_triangle", true, true, true, true, scene::BiasModel::kOdd, 0.15, scene::Scaling::kWidth,
     Shape::kTriangle},
    {"all_disc", true, true, true, true, scene::BiasModel::kOdd, 0.15, scene::Scaling::kWidth,
     Shape::kDiscWithHole},
    {"all_dart", true, true, true, true, scene::BiasModel::kOdd, 0.15, scene::Scaling::kWidth, Shape::kDart},
    {"all_slits", true, true, true, true, scene::BiasModel::kOdd, 0.8, scene::Scaling::kWidth,
     Shape::kSlits}};

// The rectangle: 7 x 5 whole cells and a cut row on each axis, with edges and corners of every kind.
Scene scene_of(const LawCase& law) {
  scene::FabricSpec fabric = reference::curved_fabric();
  if (!law.warp) fabric.warp = {};
  if (!law.weft) fabric.weft = {};
  if (!law.bias) fabric.bias = {};
  if (!law.bending) fabric.bending_warp = fabric.bending_weft = 0;
  Scene scene = cut_piece(fabric, law.shape);
  scene.bias_model = law.model;
  scene.scaling = law.scaling;
  return scene;
}

class EveryForce : public testing::TestWithParam<LawCase> {};
INSTANTIATE_TEST_SUITE_P(Laws, EveryForce, testing::ValuesIn(kLaws),
                         [](const auto& law) { return law.param.name; });

// Both sides round each of about 30 terms a node once or twice. The tolerance of 1e-12 of the largest force
// allows for that only.
TEST_P(EveryForce, IsThatOfTheReference) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Assembled a = assemble(scene_of(GetParam()));
    crumple(a, GetParam().crumple * 0.01, seed);
    const Eigen::VectorXd core = forces_by(dynamics::kernel_pick(), a);
    const Eigen::VectorXd expected = reference::forces(reference::lattice_make(a.scene), positions(a));
    ASSERT_EQ(core.size(), expected.size());
    EXPECT_LE((core - expected).lpNorm<Eigen::Infinity>(), 1e-12 * expected.lpNorm<Eigen::Infinity>())
        << "seed " << seed;
  }
}

// F = -dE/dr by central differences: error eps^2 E''' / 6 + (rounding of E) / eps, at eps = 1e-7 m of 1e-2 m
// cells.
TEST_P(EveryForce, IsMinusTheGradientOfItsEnergy) {
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 7);
  const Eigen::VectorXd force = forces_by(dynamics::kernel_pick(), a);
  const auto energy = [&] {
    System weightless = a.system;
    weightless.gravity = {0, 0, 0};
    const drape_energy e = dynamics::potential_energy(weightless, a.state);
    return e.stretch + e.shear + e.bending;
  };
  expect_minus_gradient(a, force, energy, 1e-7);
}

TEST_P(EveryForce, HasNoNetForceAndNoNetTorque) {
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 3);
  const Eigen::VectorXd force = forces_by(dynamics::kernel_pick(), a), r = positions(a);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = sum;
  for (Eigen::Index k = 0; k < r.size(); k += 3) {
    const Eigen::Vector3d f = force.segment<3>(k), at = r.segment<3>(k);
    sum += f;
    torque += at.cross(f);
  }
  const double scale = force.lpNorm<1>();
  EXPECT_LE(sum.norm(), 1e-15 * scale);
  EXPECT_LE(torque.norm(), 1e-15 * scale * 0.1);
}

TEST_P(EveryForce, IsZeroAtRest) {
  Assembled a = assemble(scene_of(GetParam()));
  // A length is rounded by 1e-16 of itself; times the stiffness, 600 N/m of 1 cm, and 8 links.
  EXPECT_LE(forces_by(dynamics::kernel_pick(), a).lpNorm<Eigen::Infinity>(), 8 * 600 * 0.01 * 4e-16);
}

TEST_P(EveryForce, TurnsWithTheCloth) {
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 5);
  const Eigen::VectorXd before = forces_by(dynamics::kernel_pick(), a);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -3).normalized()).matrix();
  for (std::size_t n : a.system.particle) {
    const Eigen::Vector3d r = turn * Eigen::Vector3d(a.state.x[n], a.state.y[n], a.state.z[n]);
    a.state.x[n] = r[0];
    a.state.y[n] = r[1];
    a.state.z[n] = r[2];
  }
  const Eigen::VectorXd after = forces_by(dynamics::kernel_pick(), a);
  const double scale = before.lpNorm<Eigen::Infinity>();
  for (Eigen::Index k = 0; k < before.size(); k += 3)
    EXPECT_LE((after.segment<3>(k) - turn * before.segment<3>(k)).norm(), 1e-12 * scale);
}

TEST_P(EveryForce, IsTheSameBitForBitInEveryLane) {
  const dynamics::Kernel* scalar = dynamics::kernel_named("scalar");
  if (!scalar) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 11);
  const Eigen::VectorXd expected = forces_by(*scalar, a);
  for (const char* name : {"avx2", "avx512"}) {
    const dynamics::Kernel* kernel = dynamics::kernel_named(name);
    EXPECT_TRUE(!kernel || forces_by(*kernel, a) == expected) << name;
  }
  const Eigen::VectorXd portable = forces_by(dynamics::kKernelPortable, a);
  EXPECT_LE((portable - expected).lpNorm<Eigen::Infinity>(), 1e-12 * expected.lpNorm<Eigen::Infinity>());
}

// The patch test: a linear map of the flat piece strains all links of a kind alike. At inner nodes with four
// whole cells the net force is zero. The virial is that of the stress on the piece's whole area A,
//     -sum f.r = A sum over the four kinds of p(e) (1 + e),     whatever the outline cuts.
TEST(Patch, LinearDisplacementGivesTheExactStressOnEveryCutPiece) {
  for (Shape shape : kCutShapes) {
    Assembled a = assemble(cut_piece(reference::curved_fabric(), shape));
    const scene::PieceSpec& piece = a.scene.pieces[0];
    const model::Lattice& l = a.system.lattices[0];
    const Eigen::Matrix2d map = (Eigen::Matrix2d() << 1.05, 0.03, -0.02, 1.09).finished();
    for (std::size_t n : a.system.particle) {
      const Eigen::Vector2d to = map * Eigen::Vector2d(a.state.x[n], a.state.y[n]);
      a.state.x[n] = to[0];
      a.state.y[n] = to[1];
    }
    const Eigen::Vector2d weft(std::cos(piece.grain), std::sin(piece.grain)), warp(-weft[1], weft[0]);
    const auto stress = [](const math::Curve& law, double ratio) {
      return math::curve_value(law, ratio - 1) * ratio;
    };
    double virial = stress(l.law.weft, (map * weft).norm()) + stress(l.law.warp, (map * warp).norm());
    for (double sign : {1.0, -1.0})
      virial += stress(l.law.bias, (map * (weft + sign * warp)).norm() / std::numbers::sqrt2);
    double area = 0;
    for (double of_node : a.system.area) area += of_node;
    const Eigen::VectorXd f = forces_by(dynamics::kernel_pick(), a);
    EXPECT_NEAR(-f.dot(positions(a)), area * virial, 1e-12 * area * virial) << shape_name(shape);

    std::vector<int> whole(a.system.nodes, 0);
    model::cells_visit(a.system, l, [&](const std::size_t* corner, double share) {
      for (int k = 0; k < 4; ++k) whole[corner[k]] += std::abs(share - 1) < 1e-12;
    });
    int inside = 0;
    for (std::size_t k = 0; k < a.system.particle.size(); ++k) {
      if (whole[a.system.particle[k]] != 4) continue;
      ++inside;
      EXPECT_LE(f.segment<3>(Eigen::Index(3 * k)).norm(), 1e-10 * f.lpNorm<Eigen::Infinity>());
    }
    EXPECT_GE(inside, 4) << shape_name(shape);
  }
}

// Darts and slits give the grid twins, and with them irregular elements; a rectangle has none.
TEST(IrregularElements, IsThereWhereTheOutlineSplitsCellsAndOnlyThere) {
  for (Shape shape : {Shape::kRectangle, Shape::kDart, Shape::kSlits}) {
    const Assembled a = assemble(cut_piece(reference::curved_fabric(), shape));
    const model::IrregularElements& side = a.system.irregular;
    const bool split = shape != Shape::kRectangle;
    EXPECT_EQ(a.system.lattices[0].twins > 0, split) << shape_name(shape);
    EXPECT_EQ(side.links.size() + side.hinges.size() + side.cells.size() > 0, split);
    EXPECT_EQ(side.node.empty(), !split);
  }
}

// psi(cos theta) = theta / sin theta up to 120 degrees; its continuation joins with two derivatives.
TEST(Bending, EnergyIsHalfTheAngleSquaredToASharpFoldAndSmoothBeyond) {
  for (double theta = 0.01; theta <= 2.09; theta += 0.01)
    EXPECT_NEAR(hinge_energy(std::cos(theta)), theta * theta / 2, 1e-13);
  const double step = 1e-3, fold = -0.5;
  const auto third = [&](double y) {
    return (hinge_energy(y + 1.5 * step) - 3 * hinge_energy(y + step / 2) + 3 * hinge_energy(y - step / 2) -
            hinge_energy(y - 1.5 * step)) /
           (step * step * step);
  };
  EXPECT_NEAR(third(fold - 2 * step), third(fold + 2 * step), 0.02 * std::abs(third(fold)));
}

}  // namespace
}  // namespace drape::forces
