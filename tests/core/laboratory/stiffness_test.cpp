// The tangent stiffness is minus the derivative of the kernel's forces.
#include "laboratory/stiffness.h"

#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "cut_pieces.h"

namespace drape::laboratory {

using namespace tests;
namespace {

// K = -dF/dr by central differences over 1e-7 m: the curvature of the laws over the length of a cell leaves
// 1e-6 of the largest entry. A cut piece with irregular elements, and a clamp.
TEST(Stiffness, IsMinusTheDerivativeOfTheForces) {
  Scene scene = cut_piece(reference::curved_fabric(), Shape::kSlits);
  scene::PinSpec pin = reference::pin_edges("edge", {0});
  pin.clamp = true;
  scene.pins = {pin};
  Assembled a = assemble(scene);
  ASSERT_FALSE(a.system.irregular.clamps.empty());
  crumple(a, 0.0015, 5);
  const Unknowns unknowns = unknowns_make(a.system, 3);
  Triplets triplets;
  stiffness_add(a.system, a.state, Stiffness::kTangent, unknowns, triplets);
  Eigen::SparseMatrix<double> k(unknowns.count, unknowns.count);
  k.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::MatrixXd full = k;
  const double largest = full.cwiseAbs().maxCoeff(), eps = 1e-7;
  EXPECT_LE((full - full.transpose()).cwiseAbs().maxCoeff(), 1e-14 * largest);
  Eigen::Index column = 0;
  for (std::size_t n : a.system.particle)
    for (Array* r : {&a.state.x, &a.state.y, &a.state.z}) {
      const double at = (*r)[n];
      (*r)[n] = at + eps;
      const Eigen::VectorXd above = forces_by(dynamics::kernel_pick(), a);
      (*r)[n] = at - eps;
      const Eigen::VectorXd below = forces_by(dynamics::kernel_pick(), a);
      (*r)[n] = at;
      EXPECT_LE((full.col(column++) + (above - below) / (2 * eps)).lpNorm<Eigen::Infinity>(), 1e-6 * largest);
    }
}

}  // namespace
}  // namespace drape::laboratory
