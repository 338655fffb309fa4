#include "laboratory/anderson.h"

#include <Eigen/QR>

namespace drape::laboratory {
namespace {

constexpr std::size_t kMaxChanges = 8;  // stored changes
constexpr double kIndependent =
    1e-4;  // relative to the largest change: smaller pivots are dropped as dependent

}  // namespace

Eigen::VectorXd anderson_next(Anderson& m, const Eigen::VectorXd& x, const Eigen::VectorXd& residual) {
  m.x.push_back(x);
  m.residual.push_back(residual);
  if (m.x.size() > kMaxChanges + 1) m.x.erase(m.x.begin()), m.residual.erase(m.residual.begin());
  const std::size_t changes = m.x.size() - 1;
  if (changes == 0) return x + residual;
  Eigen::MatrixXd by_x(x.size(), Eigen::Index(changes)), by_residual(x.size(), Eigen::Index(changes));
  for (std::size_t k = 0; k < changes; ++k) {
    by_x.col(Eigen::Index(k)) = m.x[k + 1] - m.x[k];
    by_residual.col(Eigen::Index(k)) = m.residual[k + 1] - m.residual[k];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(by_residual);
  qr.setThreshold(kIndependent);
  return x + residual - (by_x + by_residual) * qr.solve(residual);
}

}  // namespace drape::laboratory
