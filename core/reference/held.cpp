// Equations: core/README.md, section 4. a is the free acceleration; on fixed particles it is the expected
// one, and M^-1 is 0 there:
//
//     lambda = -(A M^-1 A^T)^-1 (A a - expected),     r'' = a + M^-1 A^T lambda,
//
// The pins act on the cloth by A^T lambda, and on a fixed particle by m (expected - a_free) - A^T lambda.
#include "reference/held.h"

namespace drape::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kRankTolerance = 1e-10;  // relative, for A M^-1 A^T

// Pivoted QR of M^-1/2 A^T has the pivot order of pivoted Cholesky of A M^-1 A^T; its pivots are their square
// roots.
void independent_rows_select(const MatrixXd& all, const std::vector<int>& rows, Held& held) {
  const MatrixXd scaled = held.inverse_mass.cwiseSqrt().asDiagonal() * all.transpose();
  Eigen::ColPivHouseholderQR<MatrixXd> qr(scaled);
  qr.setThreshold(std::sqrt(kRankTolerance));
  held.A.resize(qr.rank(), all.cols());
  for (Index k = 0; k < qr.rank(); ++k) {
    const Index row = qr.colsPermutation().indices()[k];
    held.A.row(k) = all.row(row);
    held.row.push_back(rows[std::size_t(row)]);
  }
  held.gram.compute(held.A * held.inverse_mass.asDiagonal() * held.A.transpose());
}

}  // namespace

Held held_make(const Lattice& lattice, const Sewing& sewing) {
  Held held;
  held.holder.assign(std::size_t(lattice.count), -1);
  held.inverse_mass.resize(lattice.count);
  for (int n = 0; n < lattice.count; ++n) held.inverse_mass[n] = 1 / lattice.mass[std::size_t(n)];

  std::vector<int> others;
  for (int k = 0; k < int(lattice.rows.size()); ++k) {
    const Point& point = lattice.rows[std::size_t(k)].point;
    if (point.node.size() > 1) {
      others.push_back(k);
      continue;
    }
    int& holder = held.holder[std::size_t(point.node[0])];
    if (holder < 0) holder = k;
    held.inverse_mass[point.node[0]] = 0;
  }
  std::vector<const std::array<Point, 2>*> welds;
  for (std::size_t k = 0; k < lattice.seams.size(); ++k)
    for (std::size_t p = 0; p < lattice.seams[k].pairs.size(); ++p)
      if (sewing[k][p] == Stage::kWelded) welds.push_back(&lattice.seams[k].pairs[p]);
  if (others.empty() && welds.empty()) return held;

  MatrixXd all = MatrixXd::Zero(Index(others.size() + welds.size()), lattice.count);
  for (std::size_t k = 0; k < welds.size(); ++k)
    for (std::size_t side = 0; side < 2; ++side) {
      const Point& point = (*welds[k])[side];
      for (std::size_t m = 0; m < point.node.size(); ++m)
        all(Index(others.size() + k), point.node[m]) += side == 0 ? -point.weight[m] : point.weight[m];
    }
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Point& point = lattice.rows[std::size_t(others[k])].point;
    for (std::size_t m = 0; m < point.node.size(); ++m) all(Index(k), point.node[m]) = point.weight[m];
  }
  others.resize(others.size() + welds.size(), -1);
  independent_rows_select(all, others, held);
  return held;
}

std::vector<Target> targets_of(const Lattice& lattice, const std::vector<Frame>& frames) {
  std::vector<Target> targets;
  for (const Row& row : lattice.rows) {
    const std::size_t pin = std::size_t(row.pin);
    targets.push_back(target_of(frames[pin], row.start - lattice.pins[pin].centre));
  }
  return targets;
}

Passed constraints_project(const Lattice& lattice, const Held& held, const std::vector<Vector3d>& expected,
                           const std::vector<Vector3d>& arm, VectorXd& x) {
  const Index pins = 3 * Index(lattice.pins.size());
  Passed passed{VectorXd::Zero(pins), VectorXd::Zero(pins)};
  const auto pass = [&](int row, const Vector3d& force) {
    if (row < 0) return;
    const int pin = lattice.rows[std::size_t(row)].pin;
    passed.force.segment<3>(3 * pin) += force;
    passed.torque.segment<3>(3 * pin) += arm[std::size_t(row)].cross(force);
  };
  const VectorXd free = x;
  for (int n = 0; n < lattice.count; ++n) {
    const int row = held.holder[std::size_t(n)];
    if (row >= 0) x.segment<3>(3 * n) = expected[std::size_t(row)];
  }

  VectorXd on_cloth = VectorXd::Zero(x.size());  // A^T lambda
  MatrixXd lambda(held.A.rows(), 3);
  for (Index axis = 0; axis < 3 && held.A.rows() > 0; ++axis) {
    const VectorXd along = x(Eigen::seqN(axis, lattice.count, 3));
    VectorXd violation = held.A * along;
    for (Index k = 0; k < violation.size(); ++k)
      if (const int row = held.row[std::size_t(k)]; row >= 0)
        violation[k] -= expected[std::size_t(row)][axis];
    lambda.col(axis) = -held.gram.solve(violation);
    on_cloth(Eigen::seqN(axis, lattice.count, 3)) = held.A.transpose() * lambda.col(axis);
  }
  for (Index k = 0; k < lambda.rows(); ++k) pass(held.row[std::size_t(k)], -lambda.row(k).transpose());
  for (int n = 0; n < lattice.count; ++n) {
    const int row = held.holder[std::size_t(n)];
    const Vector3d pull = on_cloth.segment<3>(3 * n);
    if (row >= 0)
      pass(row, lattice.mass[std::size_t(n)] * (free.segment<3>(3 * n) - x.segment<3>(3 * n)) + pull);
    x.segment<3>(3 * n) += held.inverse_mass[n] * pull;
  }
  return passed;
}

}  // namespace drape::reference
