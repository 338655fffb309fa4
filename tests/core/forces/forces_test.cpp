// The common suite of every force: against the judge, against its own energy, and against the symmetries of
// space. Equations: core/README.md, section 3.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "cloth_fixture.h"
#include "forces/hinge_energy.h"
#include "outputs/energy.h"
#include "reference/forces.h"

namespace drape {
namespace {

struct LawCase {
  const char* name;
  bool warp, weft, bias, bending;
  BiasModel model = BiasModel::kOdd;
  double crumple = 0.15;  // of a cell: strains to 30 %, folds to 60 degrees
  Scaling scaling = Scaling::kWidth;
};

const LawCase kLaws[] = {{"warp", true, false, false, false},
                         {"weft", false, true, false, false},
                         {"bias_odd", false, false, true, false},
                         {"bias_tension", false, false, true, false, BiasModel::kTension},
                         {"bias_paper", false, false, true, false, BiasModel::kPaper},
                         {"bending", false, false, false, true},
                         {"bending_sharp_folds", false, false, false, true, BiasModel::kOdd, 0.8},
                         {"paper_area", true, true, true, true, BiasModel::kOdd, 0.15, Scaling::kPaperArea},
                         {"all", true, true, true, true},
                         {"all_sharp_folds", true, true, true, true, BiasModel::kOdd, 0.8}};

// 7 x 5 whole cells and a cut row on each axis: 8 x 6 cells, edges and corners of every kind.
Scene scene_of(const LawCase& law, bool cut = true) {
  FabricSpec fabric = reference::curved_fabric();
  if (!law.warp) fabric.warp = {};
  if (!law.weft) fabric.weft = {};
  if (!law.bias) fabric.bias = {};
  if (!law.bending) fabric.bending_warp = fabric.bending_weft = 0;
  const double odd = cut ? 0.004 : 0;
  Scene scene = reference::rectangle(fabric, 0.07 + odd, 0.05 + odd / 2, 0.01);
  scene.bias_model = law.model;
  scene.scaling = law.scaling;
  return scene;
}

class EveryForce : public testing::TestWithParam<LawCase> {};
INSTANTIATE_TEST_SUITE_P(Laws, EveryForce, testing::ValuesIn(kLaws),
                         [](const auto& law) { return law.param.name; });

// Both sides round each of about 30 terms a node once or twice; 1e-12 of the largest force leaves room for
// that only.
TEST_P(EveryForce, IsTheJudges) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Assembled a = assemble(scene_of(GetParam()));
    crumple(a, GetParam().crumple * 0.01, seed);
    const Eigen::VectorXd core = forces_by(kernel_pick(), a);
    const Eigen::VectorXd judge = reference::forces(reference::lattice_make(a.scene), positions(a));
    ASSERT_EQ(core.size(), judge.size());
    EXPECT_LE((core - judge).lpNorm<Eigen::Infinity>(), 1e-12 * judge.lpNorm<Eigen::Infinity>())
        << "seed " << seed;
  }
}

// F = -dE/dr by central differences: error eps^2 E''' / 6 + (rounding of E) / eps, at eps = 1e-7 m of 1e-2 m
// cells.
TEST_P(EveryForce, IsMinusTheGradientOfItsEnergy) {
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 7);
  const Eigen::VectorXd force = forces_by(kernel_pick(), a);
  const auto energy = [&] {
    System weightless = a.system;
    weightless.gravity = {0, 0, 0};
    const drape_energy e = energy_potential(weightless, a.state);
    return e.stretch + e.shear + e.bending;
  };
  const double eps = 1e-7, scale = force.lpNorm<Eigen::Infinity>();
  Eigen::Index k = 0;
  for (std::size_t n : a.system.particle)
    for (Array* r : {&a.state.x, &a.state.y, &a.state.z}) {
      const double at = (*r)[n];
      (*r)[n] = at + eps;
      const double above = energy();
      (*r)[n] = at - eps;
      const double below = energy();
      (*r)[n] = at;
      EXPECT_NEAR(force[k++], -(above - below) / (2 * eps), 1e-6 * scale);
    }
}

TEST_P(EveryForce, HasNoNetForceAndNoNetTorque) {
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 3);
  const Eigen::VectorXd force = forces_by(kernel_pick(), a), r = positions(a);
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
  // A length rounds to 1e-16 of itself; times the stiffness, 600 N/m of 1 cm, and 8 links.
  EXPECT_LE(forces_by(kernel_pick(), a).lpNorm<Eigen::Infinity>(), 8 * 600 * 0.01 * 4e-16);
}

TEST_P(EveryForce, TurnsWithTheCloth) {
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 5);
  const Eigen::VectorXd before = forces_by(kernel_pick(), a);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -3).normalized()).matrix();
  for (std::size_t n : a.system.particle) {
    const Eigen::Vector3d r = turn * Eigen::Vector3d(a.state.x[n], a.state.y[n], a.state.z[n]);
    a.state.x[n] = r[0];
    a.state.y[n] = r[1];
    a.state.z[n] = r[2];
  }
  const Eigen::VectorXd after = forces_by(kernel_pick(), a);
  const double scale = before.lpNorm<Eigen::Infinity>();
  for (Eigen::Index k = 0; k < before.size(); k += 3)
    EXPECT_LE((after.segment<3>(k) - turn * before.segment<3>(k)).norm(), 1e-12 * scale);
}

TEST_P(EveryForce, IsTheSameBitForBitInEveryLane) {
  const Kernel* scalar = kernel_named("scalar");
  if (!scalar) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  Assembled a = assemble(scene_of(GetParam()));
  crumple(a, GetParam().crumple * 0.01, 11);
  const Eigen::VectorXd expected = forces_by(*scalar, a);
  for (const char* name : {"avx2", "avx512"}) {
    const Kernel* kernel = kernel_named(name);
    EXPECT_TRUE(!kernel || forces_by(*kernel, a) == expected) << name;
  }
  const Eigen::VectorXd portable = forces_by(kKernelPortable, a);
  EXPECT_LE((portable - expected).lpNorm<Eigen::Infinity>(), 1e-12 * expected.lpNorm<Eigen::Infinity>());
}

// psi(cos theta) = theta / sin theta to 120 degrees; its continuation meets it with two derivatives.
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
}  // namespace drape
