#include "laboratory/monotone_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "math/monotone_curve.h"

namespace drape::laboratory {
namespace {

constexpr int kKnots = 65;

using Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// The normal equations in the unknowns c_j L/F, with L and F the greatest elongation and force.
struct Equations {
  Matrix square, roughness;  // A^T W A; the squares of second differences, scaled to its norm
  Vector right;              // A^T W f
  double force_square = 0;   // f^T W f
};

// Integrals of the hats from 0 to x (share of the length).
Vector hats_integral(double x) {
  constexpr double kWidth = 1.0 / (kKnots - 1);
  Vector row = Vector::Zero(kKnots);
  const auto last = std::clamp(Index(x / kWidth), Index(0), Index(kKnots - 2));
  const double t = x / kWidth - double(last);
  for (Index j = 0; j < last; ++j) row[j] += kWidth / 2, row[j + 1] += kWidth / 2;
  row[last] += kWidth * t * (1 - t / 2);
  row[last + 1] += kWidth * t * t / 2;
  return row;
}

Equations equations_of(const Samples& s, double length, double force) {
  Equations q;
  q.square = q.roughness = Matrix::Zero(kKnots, kKnots);
  q.right = Vector::Zero(kKnots);
  for (std::size_t i = 0; i < s.elongation.size(); ++i) {
    const Vector row = hats_integral(s.elongation[i] / length);
    const double f = s.force[i] / force;
    q.square.selfadjointView<Eigen::Lower>().rankUpdate(row, s.count[i]);
    q.right += s.count[i] * f * row;
    q.force_square += s.count[i] * f * f;
  }
  q.square = Matrix(q.square.selfadjointView<Eigen::Lower>());
  for (Index j = 1; j + 1 < kKnots; ++j) {
    Vector second = Vector::Zero(kKnots);
    second[j - 1] = second[j + 1] = 1, second[j] = -2;
    q.roughness += second * second.transpose();
  }
  q.roughness *= q.square.trace() / q.roughness.trace();
  return q;
}

// The minimum of x^T M x/2 - right^T x over the unknowns of `set`; 0 elsewhere.
Vector minimum_within(const Matrix& m, const Vector& right, const std::vector<Index>& set) {
  Vector x = Vector::Zero(right.size());
  if (!set.empty()) x(set) = Vector(Matrix(m(set, set)).ldlt().solve(Vector(right(set))));
  return x;
}

// The minimum under x >= 0, from a point that fulfils it.
Vector minimum_not_negative(const Matrix& m, const Equations& q, Vector x) {
  const double small = 1e-11 * q.right.cwiseAbs().maxCoeff();
  std::vector<Index> set;
  for (Index j = 0; j < kKnots; ++j)
    if (x[j] > 0) set.push_back(j);
  const auto is_out = [&](Index j) { return std::find(set.begin(), set.end(), j) == set.end(); };
  for (int step = 0; step < 30 * kKnots; ++step) {
    const Vector next = minimum_within(m, q.right, set);
    double share = 1;  // of the way to `next` that keeps x >= 0
    for (const Index j : set)
      if (next[j] <= 0 && x[j] > next[j]) share = std::min(share, x[j] / (x[j] - next[j]));
    x += share * (next - x);
    if (share < 1) {
      std::erase_if(set, [&](Index j) { return next[j] <= 0 && x[j] <= 1e-14; });
      for (Index j = 0; j < kKnots; ++j)
        if (is_out(j)) x[j] = 0;
      continue;
    }
    const Vector gain = q.right - m * x;
    Index best = -1;
    for (Index j = 0; j < kKnots; ++j)
      if (gain[j] > small && is_out(j) && (best < 0 || gain[j] > gain[best])) best = j;
    if (best < 0) return x;
    set.push_back(best);
  }
  return x;
}

double rms_of(const Equations& q, const Samples& s, const Vector& x, double force) {
  const double square = q.force_square - 2 * q.right.dot(x) + x.dot(q.square * x);
  return std::sqrt((std::max(square, 0.0) * force * force + samples_square(s)) / samples_total(s));
}

}  // namespace

MonotoneFit monotone_fit(const Samples& s, double resolution, double path) {
  constexpr double kLow = -9, kHigh = 9, kPart = 0.1;  // log10 of lambda
  constexpr int kHalvings = 30;
  const double force = *std::max_element(s.force.begin(), s.force.end());
  const double last_limit = resolution * std::sqrt(1 + 3 * std::sqrt(2 / samples_total(s)));
  const Equations q = equations_of(s, s.elongation.back(), force);
  const auto fit_of = [&](double power) {
    const Vector x =
        minimum_not_negative(q.square + std::pow(10, power) * q.roughness, q, Vector::Ones(kKnots));
    MonotoneFit fit;
    fit.length = s.elongation.back();
    fit.rms = rms_of(q, s, x, force);
    fit.is_near = fit.rms <= last_limit;
    for (Index j = 0; j < kKnots; ++j) fit.slope.push_back(std::max(x[j], 0.0) * force / fit.length);
    return fit;
  };
  MonotoneFit fit = fit_of(kHigh);
  if (fit.rms <= resolution) return fit;
  double low = kLow, high = kHigh;
  fit = fit_of(low);
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    const MonotoneFit next = fit_of(middle);
    if (next.rms <= resolution) low = middle, fit = next;
    else high = middle;
  }
  for (double power = low + kPart; power < kHigh && fit_slope_path(fit) > path; power += kPart) {
    const MonotoneFit next = fit_of(power);
    if (next.rms > last_limit) break;
    fit = next;
  }
  return fit;
}

double fit_value(const MonotoneFit& fit, double elongation) {
  const Vector row = hats_integral(std::clamp(elongation / fit.length, 0.0, 1.0));
  double value = 0;
  for (Index j = 0; j < kKnots; ++j) value += row[j] * fit.slope[std::size_t(j)] * fit.length;
  return value;
}

double fit_slope_path(const MonotoneFit& fit) {
  const auto [low, high] = std::minmax_element(fit.slope.begin(), fit.slope.end());
  if (*high - *low <= math::kConstantSlope * *high) return 1;
  double path = 0;
  for (std::size_t j = 1; j < fit.slope.size(); ++j) path += std::abs(fit.slope[j] - fit.slope[j - 1]);
  return path / (*high - *low);
}

Beginning samples_beginning(const Samples& s) {
  const std::size_t n = s.elongation.size(), count = std::min(n, std::max<std::size_t>(12, n / 10));
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double length = s.elongation[count - 1];
  for (std::size_t i = 0; i < count; ++i) {
    const double x = s.elongation[i] / length;
    const Eigen::Vector3d row(1, x, x * x);
    square += s.count[i] * row * row.transpose();
    right += s.count[i] * s.force[i] * row;
  }
  const Eigen::Vector3d parabola = square.ldlt().solve(right);
  return {parabola[0], parabola[1] / length};
}

}  // namespace drape::laboratory
