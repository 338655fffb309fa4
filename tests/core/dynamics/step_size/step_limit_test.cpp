// The step limit against the true largest frequency of the lattice. Bound: core/README.md, section 4.
#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "reference/forces.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// The largest eigenvalue of M^-1/2 K M^-1/2, with K the reference solver's stiffness by central differences.
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

// Without bending the bound is rigorous; the error of the differences is 1e-6 of it.
TEST(StepLimit, BoundsEveryCrumpledLatticeWithoutBending) {
  double closest = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    scene::FabricSpec fabric = reference::curved_fabric();
    fabric.bending_warp = fabric.bending_weft = 0;
    Scene scene = reference::rectangle(fabric, 0.064, 0.05, 0.01);
    scene.bias_model = seed % 2 ? scene::BiasModel::kOdd : scene::BiasModel::kTension;
    Assembled a = assemble(scene);
    crumple(a, 0.0002 * seed, seed);
    const double ratio = omega2_true(a) / step_limit_omega2(a.system, *a.motion.kernel, a.state);
    closest = std::max(closest, ratio);
    EXPECT_LE(ratio, 1 + 1e-5) << "seed " << seed;
  }
  std::printf("40 crumpled lattices: the true omega reaches %.4f of the bound\n", std::sqrt(closest));
}

// With bending: sharp folds also stiffen by their geometry, which the safety factor of the automatic step
// covers.
TEST(StepLimit, BoundsCrumpledLatticesWithBendingWithinTheSafetyFactor) {
  double closest = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    scene::FabricSpec fabric = reference::curved_fabric();
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

// Pieces that the outline cuts and splits: the bound does not depend on the outline. Without bending it is
// rigorous; with bending, sharp folds stiffen hinges only within the safety factor.
TEST(StepLimit, BoundsCrumpledCutPieces) {
  for (const bool bending : {false, true}) {
    double closest = 0;
    for (unsigned seed = 1; seed <= 24; ++seed) {
      scene::FabricSpec fabric = reference::curved_fabric();
      if (!bending) fabric.bending_warp = fabric.bending_weft = 0;
      else if (seed % 3 == 0) fabric.bending_warp *= 1000;
      Assembled a = assemble(cut_piece(fabric, kCutShapes[seed % 4]));
      crumple(a, (bending ? 0.0001 : 0.0002) * seed, seed);
      const double ratio = omega2_true(a) / step_limit_omega2(a.system, *a.motion.kernel, a.state);
      closest = std::max(closest, ratio);
      EXPECT_LE(std::sqrt(ratio), bending ? 1 / 0.8 : 1 + 1e-5) << "seed " << seed;
    }
    std::printf("24 crumpled cut pieces %s bending: the true omega reaches %.4f of the bound\n",
                bending ? "with" : "without", std::sqrt(closest));
  }
}

// Clamps inside cells are stiffer than the hinges they replace, by up to 1/s^2 at s = 0.2: a term of their
// own covers them. Bending alone, much stiffer than the yarns, at rest and folded up to the safety factor.
TEST(StepLimit, BoundsClampedPieces) {
  double closest = 0, unaided = 0;
  for (const bool region : {false, true})
    for (double s = 0.1; s <= 1; s += 0.1) {
      scene::FabricSpec fabric = reference::curved_fabric();
      fabric.bending_warp *= 1e4;
      fabric.bending_weft *= 1e4;
      Scene scene = cut_piece(fabric, Shape::kRectangle);
      scene::PinSpec pin;
      pin.name = "clamp";
      pin.piece = 0;
      pin.clamp = true;
      if (region)
        pin.region = {{0, 0}, {0.074, 0}, {0.074, 0.02 + 0.01 * (1 - s)}, {0, 0.02 + 0.01 * (1 - s)}};
      else pin.edges = {0}, scene.pieces[0].grid_origin = Vec2{0, 0.01 * s};
      scene.pins = {pin};
      Assembled a = assemble(scene);
      ASSERT_FALSE(a.system.irregular.clamps.empty());
      const double truth = omega2_true(a);
      closest = std::max(closest, truth / a.state.omega2);
      EXPECT_LE(truth, a.state.omega2 * (1 + 1e-5)) << "s = " << s;
      for (model::ClampHinge& c : a.system.irregular.clamps) c.excess = 0;
      unaided = std::max(unaided, truth / step_limit_omega2(a.system, *a.motion.kernel, a.state));
    }
  std::printf("clamps at rest: the true omega reaches %.4f of the bound, %.4f without their term\n",
              std::sqrt(closest), std::sqrt(unaided));
}

// At rest the mass and stiffness of a cut cell shrink together: the outline lowers neither the bound nor the
// true limit.
TEST(StepLimit, IsNotLoweredByTheOutline) {
  scene::FabricSpec fabric = reference::curved_fabric();
  fabric.bending_warp *= 100;
  const Assembled whole = assemble(reference::rectangle(fabric, 0.08, 0.06, 0.01));
  const double bound = whole.state.omega2, largest = omega2_true(whole);
  for (Shape shape : kCutShapes) {
    const Assembled a = assemble(cut_piece(fabric, shape));
    const double ratio = std::sqrt(omega2_true(a) / largest);
    EXPECT_LE(std::abs(a.state.omega2 / bound - 1), 1e-12) << shape_name(shape);
    EXPECT_LE(ratio, 1.05) << shape_name(shape);
    std::printf("%s at rest: the true omega is %.4f of the whole sheet's\n", shape_name(shape), ratio);
  }
}

// At rest: [4 max k + 8 k_d + 16 (B1 + B2)/b^2]/(rho b^2), and the limiting link has a name.
TEST(StepLimit, AtRestIsTheFormulaOfAFlatLattice) {
  scene::FabricSpec fabric;
  fabric.name = "linear";
  fabric.areal_density = 0.2;
  fabric.warp = reference::straight(300);
  fabric.weft = reference::straight(100);
  fabric.bias = reference::diagram({0, 0.1}, {0, 0.1 * 40 * 0.05});
  fabric.bending_warp = 3e-5;
  fabric.bending_weft = 1e-5;
  Scene scene = reference::rectangle(fabric, 0.1, 0.1, 0.01);
  scene.bias_model = scene::BiasModel::kTension;
  scene.clamp_correction = false;
  const Assembled a = assemble(scene);
  const double expected = (4 * 300 + 8 * 40 / 2.0 + 16 * 4e-5 / 1e-4) / (0.2 * 1e-4);
  EXPECT_NEAR(a.state.omega2, expected, 1e-12 * expected);
  EXPECT_NEAR(step_limit_of(a.system, expected), 2 / std::sqrt(expected), 1e-15);
  EXPECT_NE(step_limit_link(a.system, a.scene, a.state).find("warp link of piece 'sheet'"),
            std::string::npos);
}

}  // namespace
}  // namespace drape::dynamics
