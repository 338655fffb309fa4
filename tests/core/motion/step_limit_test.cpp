// The step limit against the true largest frequency of the lattice. Bound: core/README.md, section 4.
#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "reference/forces.h"

namespace drape {
namespace {

// The largest eigenvalue of M^-1/2 K M^-1/2, K the judge's stiffness by central differences.
double omega2_true(const Assembled& a) {
  const reference::Lattice lattice = reference::lattice_make(a.scene);
  const Eigen::VectorXd r = positions(a);
  const Eigen::Index n = r.size();
  Eigen::MatrixXd k(n, n);
  const double eps = 1e-7;
  for (Eigen::Index c = 0; c < n; ++c) {
    Eigen::VectorXd up = r, down = r;
    up[c] += eps;
    down[c] -= eps;
    k.col(c) = -(reference::forces(lattice, up) - reference::forces(lattice, down)) / (2 * eps);
  }
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      k(i, j) /= std::sqrt(lattice.mass[std::size_t(i / 3)] * lattice.mass[std::size_t(j / 3)]);
  k = ((k + k.transpose()) / 2).eval();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

// Without bending the bound is rigorous; the differences err by 1e-6 of it.
TEST(StepLimit, BoundsEveryCrumpledLatticeWithoutBending) {
  double closest = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    FabricSpec fabric = reference::curved_fabric();
    fabric.bending_warp = fabric.bending_weft = 0;
    Scene scene = reference::rectangle(fabric, 0.064, 0.05, 0.01);
    scene.bias_model = seed % 2 ? BiasModel::kOdd : BiasModel::kTension;
    Assembled a = assemble(scene);
    crumple(a, 0.0002 * seed, seed);
    const double ratio = omega2_true(a) / step_limit_omega2(a.system, *a.motion.kernel, a.state);
    closest = std::max(closest, ratio);
    EXPECT_LE(ratio, 1 + 1e-5) << "seed " << seed;
  }
  std::printf("40 crumpled lattices: the true omega reaches %.4f of the bound\n", std::sqrt(closest));
}

// Bending beside it: sharp folds stiffen by their geometry too, which the automatic step's safety factor covers.
TEST(StepLimit, BoundsCrumpledLatticesWithBendingWithinTheSafetyFactor) {
  double closest = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    FabricSpec fabric = reference::curved_fabric();
    fabric.bending_warp *= seed % 4 ? 1 : 1000;
    Assembled a = assemble(reference::rectangle(fabric, 0.064, 0.05, 0.01));
    crumple(a, 0.0001 * seed, seed);
    const double ratio = omega2_true(a) / step_limit_omega2(a.system, *a.motion.kernel, a.state);
    closest = std::max(closest, ratio);
    EXPECT_LE(std::sqrt(ratio), 1 / 0.8) << "seed " << seed;
  }
  std::printf("40 crumpled lattices with bending: the true omega reaches %.4f of the bound\n",
              std::sqrt(closest));
}

// At rest: [4 max k + 8 k_d + 16 (B1 + B2)/b^2]/(rho b^2), and the worst link has a name.
TEST(StepLimit, AtRestIsTheFormulaOfAFlatLattice) {
  FabricSpec fabric;
  fabric.name = "linear";
  fabric.areal_density = 0.2;
  fabric.warp = reference::straight(300);
  fabric.weft = reference::straight(100);
  fabric.bias = reference::diagram({0, 0.1}, {0, 0.1 * 40 * 0.05});
  fabric.bending_warp = 3e-5;
  fabric.bending_weft = 1e-5;
  Scene scene = reference::rectangle(fabric, 0.1, 0.1, 0.01);
  scene.bias_model = BiasModel::kTension;
  scene.clamp_correction = false;
  const Assembled a = assemble(scene);
  const double expected = (4 * 300 + 8 * 40 / 2.0 + 16 * 4e-5 / 1e-4) / (0.2 * 1e-4);
  EXPECT_NEAR(a.state.omega2, expected, 1e-12 * expected);
  EXPECT_NEAR(step_limit_of(a.system, expected), 2 / std::sqrt(expected), 1e-15);
  EXPECT_NE(step_limit_link(a.system, a.scene, a.state).find("warp link of piece 'sheet'"),
            std::string::npos);
}

}  // namespace
}  // namespace drape
