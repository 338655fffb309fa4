#include "laboratory/anderson.h"

#include <Eigen/QR>

namespace drape::laboratory {
namespace {

constexpr std::size_t kKept = 8;       // changes
constexpr double kIndependent = 1e-4;  // of the largest change: what less is left of tells nothing new

}  // namespace

Eigen::VectorXd anderson_next(Anderson& m, const Eigen::VectorXd& x, const Eigen::VectorXd& left) {
  m.x.push_back(x);
  m.left.push_back(left);
  if (m.x.size() > kKept + 1) m.x.erase(m.x.begin()), m.left.erase(m.left.begin());
  const std::size_t changes = m.x.size() - 1;
  if (changes == 0) return x + left;
  Eigen::MatrixXd by_x(x.size(), Eigen::Index(changes)), by_left(x.size(), Eigen::Index(changes));
  for (std::size_t k = 0; k < changes; ++k) {
    by_x.col(Eigen::Index(k)) = m.x[k + 1] - m.x[k];
    by_left.col(Eigen::Index(k)) = m.left[k + 1] - m.left[k];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(by_left);
  qr.setThreshold(kIndependent);
  return x + left - (by_x + by_left) * qr.solve(left);
}

}  // namespace drape::laboratory
