#include "laboratory/elastica.h"

#include <array>
#include <cmath>
#include <numbers>

namespace drape {
namespace {

constexpr double kRight = std::numbers::pi / 2;
constexpr double kStep = 2e-3;  // of v, at most: an error of 1e-11 by Runge and Kutta's fourth order

using Course = std::array<double, 4>;  // phi, phi', int sin phi, int cos phi

Course rate(double v, const Course& y) { return {y[1], v * std::sin(y[0]), std::sin(y[0]), std::cos(y[0])}; }

Course step(double v, const Course& y, double h) {
  const auto on = [&](const Course& k, double by) {
    Course to = y;
    for (std::size_t i = 0; i < 4; ++i) to[i] += by * k[i];
    return to;
  };
  const Course k1 = rate(v, y), k2 = rate(v + h / 2, on(k1, h / 2)), k3 = rate(v + h / 2, on(k2, h / 2)),
               k4 = rate(v + h, on(k3, h));
  Course to = y;
  for (std::size_t i = 0; i < 4; ++i) to[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return to;
}

// From the free end, which hangs at delta from the vertical, to the clamp.
Elastica elastica_of_end(double delta) {
  Course y{delta, 0, 0, 0};
  double v = 0;
  for (;;) {
    const Course next = step(v, y, kStep);
    if (next[0] >= kRight) break;
    y = next;
    v += kStep;
  }
  double h = kStep / 2;
  for (int k = 0; k < 8; ++k) {  // Newton
    const Course at = step(v, y, h);
    h -= (at[0] - kRight) / at[1];
  }
  y = step(v, y, h);
  v += h;
  return {v * v * v, y[2] / v, y[3] / v};
}

double end_at(double x) { return kRight * std::exp(-x); }

// The elastica at which a rising quantity is `value`; by bisection in x, delta = pi/2 exp(-x).
template <class Quantity>
double end_where(Quantity quantity, double value) {
  double low = 1e-12, high = 700;
  for (int k = 0; k < 70; ++k) {
    const double middle = (low + high) / 2;
    (quantity(elastica_of_end(end_at(middle))) < value ? low : high) = middle;
  }
  return end_at((low + high) / 2);
}

double beta_of(const Elastica& e) { return e.beta; }

}  // namespace

Elastica elastica_of_load(double beta) { return elastica_of_end(end_where(beta_of, beta)); }

Elastica elastica_of_drop(double drop) {
  return elastica_of_end(end_where([](const Elastica& e) { return e.down; }, drop));
}

Elastica elastica_of_slope(double angle) {
  const auto slope = [](const Elastica& e) { return std::atan2(e.down, e.out); };
  return elastica_of_end(end_where(slope, angle));
}

std::vector<Vec2> elastica_shape(double beta, int n) {
  const double length = std::cbrt(beta);
  const int parts = std::max(1, int(std::ceil(length / (n * kStep))));
  const double h = length / (n * parts);
  std::vector<Vec2> shape(std::size_t(n) + 1);
  Course y{end_where(beta_of, beta), 0, 0, 0};
  for (int k = 0; k < n * parts; ++k) {
    y = step(k * h, y, h);
    if ((k + 1) % parts == 0) shape[std::size_t(n - (k + 1) / parts)] = {y[2] / length, y[3] / length};
  }
  const Vec2 whole = shape[0];
  for (Vec2& p : shape) p = {whole[0] - p[0], whole[1] - p[1]};
  return shape;
}

}  // namespace drape
