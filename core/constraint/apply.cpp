#include "constraint/apply.h"

namespace drape {
namespace {

// b <- A f - target (target only where `at` is set)
void rows_residual(const Constraints& c, const Field& f, bool at, double* b) {
  for (std::size_t r = 0; r < c.rows.size(); ++r) {
    const ConstraintRow& row = c.rows[r];
    for (int k = 0; k < 3; ++k) b[3 * r + k] = at ? -row.target[k] : 0.0;
    for (std::size_t n = 0; n < row.node.size(); ++n) {
      b[3 * r] += row.weight[n] * f.x[row.node[n]];
      b[3 * r + 1] += row.weight[n] * f.y[row.node[n]];
      b[3 * r + 2] += row.weight[n] * f.z[row.node[n]];
    }
  }
}

// f <- f - s M^-1 A^T y
void rows_correct(const Constraints& c, const double* y, double s, const Field& f) {
  std::size_t m = 0;
  for (std::size_t r = 0; r < c.rows.size(); ++r) {
    const ConstraintRow& row = c.rows[r];
    for (std::size_t n = 0; n < row.node.size(); ++n, ++m) {
      const double w = s * row.weight[n] * c.inverse_mass[m];
      f.x[row.node[n]] -= w * y[3 * r];
      f.y[row.node[n]] -= w * y[3 * r + 1];
      f.z[row.node[n]] -= w * y[3 * r + 2];
    }
  }
}

double weight_sum(const ConstraintRow& row) {
  double sum = 0;
  for (double w : row.weight) sum += w;
  return sum;
}

}  // namespace

void constraints_apply(const Constraints& c, const Array& mass, double h, double kick, double weight,
                       double* y, State& s) {
  const Field r{s.x.data(), s.y.data(), s.z.data()}, v{s.vx.data(), s.vy.data(), s.vz.data()};
  for (const FixedNode& f : c.fixed) {  // v was 0 before the kick: force = m v/kick
    const double impulse = mass[f.node] / kick * weight;
    Vec3& sum = s.pin_impulse[std::size_t(f.pin)];
    sum[0] += impulse * v.x[f.node];
    sum[1] += impulse * v.y[f.node];
    sum[2] += impulse * v.z[f.node];
    v.x[f.node] = v.y[f.node] = v.z[f.node] = 0;
    r.x[f.node] = f.target[0];
    r.y[f.node] = f.target[1];
    r.z[f.node] = f.target[2];
  }
  if (c.rows.empty()) return;
  rows_residual(c, r, true, y);  // A r = h kick A a, for the rows held before the step
  constraints_solve(c, y);
  rows_correct(c, y, 1, r);
  rows_correct(c, y, 1 / h, v);
  for (std::size_t k = 0; k < c.rows.size(); ++k) {
    const double impulse = weight_sum(c.rows[k]) / (h * kick) * weight;
    for (int d = 0; d < 3; ++d) s.pin_impulse[std::size_t(c.rows[k].pin)][d] += impulse * y[3 * k + d];
  }
}

void constraints_project(const Constraints& c, const Array& mass, double* y, Field field,
                         std::vector<Vec3>* force) {
  for (const FixedNode& f : c.fixed) {
    if (force) {
      Vec3& sum = (*force)[std::size_t(f.pin)];
      sum[0] += mass[f.node] * field.x[f.node];
      sum[1] += mass[f.node] * field.y[f.node];
      sum[2] += mass[f.node] * field.z[f.node];
    }
    field.x[f.node] = field.y[f.node] = field.z[f.node] = 0;
  }
  if (c.rows.empty()) return;
  rows_residual(c, field, false, y);
  constraints_solve(c, y);
  rows_correct(c, y, 1, field);
  if (!force) return;
  for (std::size_t k = 0; k < c.rows.size(); ++k)
    for (int d = 0; d < 3; ++d)
      (*force)[std::size_t(c.rows[k].pin)][d] += weight_sum(c.rows[k]) * y[3 * k + d];
}

}  // namespace drape
