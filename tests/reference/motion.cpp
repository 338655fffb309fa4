// Equations: core/README.md, section 4. With a the free acceleration, 0 on the fixed particles, as M^-1 is,
//
//     lambda = -(A M^-1 A^T)^-1 A a,     r'' = a + M^-1 A^T lambda,
//
// the pins act on the cloth by A^T lambda, and on a fixed one so that it stays: by -m a_free - A^T lambda.
#include "reference/motion.h"

#include "reference/forces.h"

namespace drape::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRankTolerance = 1e-10;  // of A M^-1 A^T

// Pivoted QR of M^-1/2 A^T takes the order of pivoted Cholesky of A M^-1 A^T; its pivots are their roots.
void keep_independent_rows(const MatrixXd& all, const std::vector<int>& pins, Motion& motion) {
  const MatrixXd scaled = motion.inverse_mass.cwiseSqrt().asDiagonal() * all.transpose();
  Eigen::ColPivHouseholderQR<MatrixXd> qr(scaled);
  qr.setThreshold(std::sqrt(kRankTolerance));
  motion.A.resize(qr.rank(), all.cols());
  for (Index k = 0; k < qr.rank(); ++k) {
    const Index row = qr.colsPermutation().indices()[k];
    motion.A.row(k) = all.row(row);
    motion.row_pin.push_back(pins[std::size_t(row)]);
  }
  motion.gram.compute(motion.A * motion.inverse_mass.asDiagonal() * motion.A.transpose());
}

}  // namespace

Motion motion_make(const Scene& scene) {
  Motion motion;
  motion.lattice = lattice_make(scene);
  motion.gravity = {scene.gravity[0], scene.gravity[1], scene.gravity[2]};
  motion.damping = scene.damping;
  const Lattice& lattice = motion.lattice;
  motion.holder.assign(std::size_t(lattice.count), -1);
  motion.inverse_mass.resize(lattice.count);
  for (int n = 0; n < lattice.count; ++n) motion.inverse_mass[n] = 1 / lattice.mass[std::size_t(n)];

  std::vector<const Row*> others;
  for (const Row& row : lattice.rows) {
    if (row.point.node.size() > 1) {
      others.push_back(&row);
      continue;
    }
    int& holder = motion.holder[std::size_t(row.point.node[0])];
    if (holder < 0) holder = row.pin;
    motion.inverse_mass[row.point.node[0]] = 0;
  }
  if (others.empty()) return motion;

  MatrixXd all = MatrixXd::Zero(Index(others.size()), lattice.count);
  std::vector<int> pins;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Point& point = others[k]->point;
    for (std::size_t m = 0; m < point.node.size(); ++m) all(Index(k), point.node[m]) = point.weight[m];
    pins.push_back(others[k]->pin);
  }
  keep_independent_rows(all, pins, motion);
  return motion;
}

VectorXd constrain(const Motion& motion, VectorXd& x) {
  const Lattice& lattice = motion.lattice;
  VectorXd world = VectorXd::Zero(3 * Index(lattice.pins.size()));
  const VectorXd free = x;
  for (int n = 0; n < lattice.count; ++n) {
    if (motion.holder[std::size_t(n)] >= 0) x.segment<3>(3 * n).setZero();
  }

  VectorXd on_cloth = VectorXd::Zero(x.size());  // A^T lambda
  for (Index axis = 0; axis < 3 && motion.A.rows() > 0; ++axis) {
    const VectorXd along = x(Eigen::seqN(axis, lattice.count, 3));
    const VectorXd lambda = -motion.gram.solve(motion.A * along);
    on_cloth(Eigen::seqN(axis, lattice.count, 3)) = motion.A.transpose() * lambda;
    for (Index k = 0; k < lambda.size(); ++k) world[3 * motion.row_pin[std::size_t(k)] + axis] -= lambda[k];
  }
  for (int n = 0; n < lattice.count; ++n) {
    const int pin = motion.holder[std::size_t(n)];
    x.segment<3>(3 * n) += motion.inverse_mass[n] * on_cloth.segment<3>(3 * n);
    if (pin < 0) continue;
    world.segment<3>(3 * pin) +=
        lattice.mass[std::size_t(n)] * free.segment<3>(3 * n) + on_cloth.segment<3>(3 * n);
  }
  return world;
}

VectorXd motion_rate(const Motion& motion, const VectorXd& y) {
  const int N = motion.lattice.count;
  const auto r = y.head(3 * N), v = y.segment(3 * N, 3 * N);
  VectorXd a = forces(motion.lattice, r);
  for (int n = 0; n < N; ++n) {
    a.segment<3>(3 * n) /= motion.lattice.mass[std::size_t(n)];
    a.segment<3>(3 * n) += motion.gravity - motion.damping * v.segment<3>(3 * n);
  }
  const VectorXd world = constrain(motion, a);
  VectorXd rate(y.size());
  rate << v, a, world;
  return rate;
}

VectorXd motion_start(const Motion& motion) {
  VectorXd v = motion.lattice.velocity;
  const VectorXd impulse = constrain(motion, v);
  VectorXd y(motion.lattice.position.size() + v.size() + impulse.size());
  y << motion.lattice.position, v, impulse;
  return y;
}

}  // namespace drape::reference
