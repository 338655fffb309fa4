#include "constraint/constraint.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

namespace drape {
namespace {

constexpr double kRankTolerance = 1e-10;   // of A M^-1 A^T, relative to its largest diagonal
constexpr double kTargetTolerance = 1e-9;  // m, between rows that say the same

using Fixed = std::map<std::size_t, Vec3>;

// Takes fixed nodes out of a row; the rest must still reach the target.
void row_reduce(ConstraintRow& row, const Fixed& fixed) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < row.node.size(); ++k) {
    const auto f = fixed.find(row.node[k]);
    if (f == fixed.end()) {
      row.node[kept] = row.node[k];
      row.weight[kept++] = row.weight[k];
    } else {
      for (int c = 0; c < 3; ++c) row.target[c] -= row.weight[k] * f->second[c];
    }
  }
  row.node.resize(kept);
  row.weight.resize(kept);
}

double size_of(const Vec3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Eigen::MatrixXd gram_of(const std::vector<ConstraintRow>& rows, const Array& inverse_mass) {
  const auto n = Eigen::Index(rows.size());
  std::map<std::size_t, std::vector<std::pair<Eigen::Index, double>>> by_node;
  for (Eigen::Index r = 0; r < n; ++r)
    for (std::size_t k = 0; k < rows[r].node.size(); ++k)
      by_node[rows[r].node[k]].push_back({r, rows[r].weight[k]});
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [node, entries] : by_node)
    for (const auto& [r, wr] : entries)
      for (const auto& [s, ws] : entries) gram(r, s) += wr * ws * inverse_mass[node];
  return gram;
}

// Pivoted Cholesky: the rows that are independent, largest pivot first; each dropped row is checked against
// the kept.
std::vector<ConstraintRow> rows_independent(std::vector<ConstraintRow> rows, const Array& inverse_mass,
                                            const std::vector<PinSpec>& pins,
                                            std::vector<Problem>& problems) {
  if (rows.empty()) return rows;
  const Eigen::MatrixXd gram = gram_of(rows, inverse_mass);
  const auto n = gram.rows();
  Eigen::VectorXd pivot = gram.diagonal();
  const double floor = kRankTolerance * pivot.maxCoeff();
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(n, n);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index step = 0; step < n; ++step) {
    Eigen::Index best;
    if (pivot.maxCoeff(&best) <= floor) break;
    const auto c = Eigen::Index(kept.size());
    lower.col(c) =
        (gram.col(best) - lower.leftCols(c) * lower.row(best).head(c).transpose()) / std::sqrt(pivot(best));
    pivot -= lower.col(c).cwiseAbs2();
    pivot(best) = 0;
    kept.push_back(best);
  }
  const auto rank = Eigen::Index(kept.size());
  Eigen::MatrixXd basis(rank, rank), targets(rank, 3);
  for (Eigen::Index a = 0; a < rank; ++a) {
    targets.row(a) << rows[kept[a]].target[0], rows[kept[a]].target[1], rows[kept[a]].target[2];
    for (Eigen::Index b = 0; b < rank; ++b) basis(a, b) = gram(kept[a], kept[b]);
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(basis);
  for (Eigen::Index r = 0; r < n; ++r) {
    if (std::find(kept.begin(), kept.end(), r) != kept.end()) continue;
    Eigen::VectorXd overlap(rank);
    for (Eigen::Index a = 0; a < rank; ++a) overlap(a) = gram(r, kept[a]);
    const Eigen::RowVector3d said = solver.solve(overlap).transpose() * targets;
    const Vec3 off{rows[r].target[0] - said[0], rows[r].target[1] - said[1], rows[r].target[2] - said[2]};
    if (size_of(off) > kTargetTolerance)
      problems.push_back({"pin." + pins[rows[r].pin].name,
                          "contradicts the other pins by " + std::to_string(size_of(off)) + " m"});
  }
  std::sort(kept.begin(), kept.end());
  std::vector<ConstraintRow> result;
  for (Eigen::Index r : kept) result.push_back(std::move(rows[r]));
  return result;
}

}  // namespace

Constraints constraints_make(std::vector<ConstraintRow> rows, const Array& inverse_mass,
                             const std::vector<PinSpec>& pins, std::vector<Problem>& problems) {
  Constraints c;
  Fixed fixed;
  // A row on one node fixes it, which may leave another row with one node.
  for (bool again = true; again;) {
    again = false;
    std::vector<ConstraintRow> open;
    for (ConstraintRow& row : rows) {
      row_reduce(row, fixed);
      if (row.node.empty()) {
        if (size_of(row.target) > kTargetTolerance)
          problems.push_back(
              {"pin." + pins[row.pin].name, "contradicts another pin at the same particle by " +
                                                std::to_string(size_of(row.target)) + " m"});
      } else if (row.node.size() == 1) {
        for (double& t : row.target) t /= row.weight[0];
        fixed[row.node[0]] = row.target;
        c.fixed.push_back({row.node[0], row.pin, row.target});
        again = true;
      } else {
        open.push_back(std::move(row));
      }
    }
    rows = std::move(open);
  }
  c.rows = rows_independent(std::move(rows), inverse_mass, pins, problems);
  constraints_refactor(c, inverse_mass);
  return c;
}

void constraints_refactor(Constraints& c, const Array& inverse_mass) {
  const auto n = Eigen::Index(c.rows.size());
  c.inverse_mass.clear();
  for (const ConstraintRow& row : c.rows)
    for (std::size_t node : row.node) c.inverse_mass.push_back(inverse_mass[node]);
  c.factor.assign(std::size_t(n * n), 0.0);
  if (n == 0) return;
  const Eigen::MatrixXd lower = gram_of(c.rows, inverse_mass).llt().matrixL();
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index s = 0; s <= r; ++s) c.factor[std::size_t(r * n + s)] = lower(r, s);
}

void constraints_solve(const Constraints& c, double* b) {
  const std::size_t n = c.rows.size();
  const double* f = c.factor.data();
  for (int k = 0; k < 3; ++k) {
    for (std::size_t r = 0; r < n; ++r) {
      double sum = b[3 * r + k];
      for (std::size_t s = 0; s < r; ++s) sum -= f[r * n + s] * b[3 * s + k];
      b[3 * r + k] = sum / f[r * n + r];
    }
    for (std::size_t r = n; r-- > 0;) {
      double sum = b[3 * r + k];
      for (std::size_t s = r + 1; s < n; ++s) sum -= f[s * n + r] * b[3 * s + k];
      b[3 * r + k] = sum / f[r * n + r];
    }
  }
}

}  // namespace drape
