#include "standards/cantilever.h"

#include <algorithm>
#include <cmath>

#include "math/bisection.h"
#include "standards/units.h"

namespace drape::standards {

namespace {

constexpr double kRightAngle = 1.57079632679489661923;
constexpr double kStep = 0.02;  // of z; the relative error of beta is below 3e-8 up to f/l = 0.985

struct Point {
  double phi, turn;    // turn = phi'
  double drop, reach;  // integrals of cos phi and sin phi
};

Point slope(double z, const Point& p) {
  const double sine = std::sin(p.phi);
  return {p.turn, z * sine, std::cos(p.phi), sine};
}

Point ahead(const Point& p, double h, const Point& d) {
  return {p.phi + h * d.phi, p.turn + h * d.turn, p.drop + h * d.drop, p.reach + h * d.reach};
}

// One step of the classical Runge-Kutta method.
Point step(double z, const Point& p, double h) {
  const Point a = slope(z, p), b = slope(z + h / 2, ahead(p, h / 2, a));
  const Point c = slope(z + h / 2, ahead(p, h / 2, b)), d = slope(z + h, ahead(p, h, c));
  return ahead(ahead(p, h / 6, a), h / 3, ahead(ahead(b, 1, c), 0.5, d));
}

}  // namespace

Cantilever cantilever_of(double end) {
  Point p{end, 0, 0, 0};
  double z = 0;
  for (Point next; (next = step(z, p, kStep)).phi < kRightAngle; z += kStep) p = next;
  // Newton's method finds the length of the last step, which ends where phi is a right angle; phi' = turn.
  double h = 0;
  Point last = p;
  for (int k = 0; k < 8; ++k) {
    const double slope = last.turn > 0 ? last.turn : kStep;
    h = std::fmin(kStep, std::fmax(0.0, h + (kRightAngle - last.phi) / slope));
    last = step(z, p, h);
  }
  z += h;
  return {z * z * z, last.drop / z, last.reach / z};
}

namespace {

// The angle phi(0) of the free end at which `quantity` equals `value`. The quantity must increase as the free
// end approaches the vertical. For soft cloth phi(0) is exponentially small, so the search is over y with
// phi(0) = (pi/2)/(1 + e^y).
template <class Quantity>
double end_where(Quantity quantity, double value) {
  const auto end = [](double y) { return kRightAngle / (1 + std::exp(y)); };
  return end(math::bisect_rising([&](double y) { return quantity(cantilever_of(end(y))); }, value, -12, 700));
}

double end_of_load(double beta) {
  return end_where([](const Cantilever& c) { return c.beta; }, beta);
}

}  // namespace

Cantilever cantilever_with(double drop) {
  return cantilever_of(end_where([](const Cantilever& c) { return c.drop; }, drop));
}

Cantilever cantilever_of_load(double beta) { return cantilever_of(end_of_load(beta)); }

Cantilever cantilever_of_slope(double angle) {
  return cantilever_of(end_where([](const Cantilever& c) { return std::atan2(c.drop, c.reach); }, angle));
}

std::vector<std::array<double, 2>> cantilever_shape(double beta, int n) {
  const double length = std::cbrt(beta);
  const int parts = std::max(1, int(std::ceil(length / (n * kStep))));
  const double h = length / (n * parts);
  std::vector<std::array<double, 2>> shape(std::size_t(n) + 1);
  Point p{end_of_load(beta), 0, 0, 0};
  for (int k = 1; k <= n * parts; ++k) {
    p = step((k - 1) * h, p, h);
    if (k % parts == 0) shape[std::size_t(n - k / parts)] = {p.reach / length, p.drop / length};
  }
  const std::array<double, 2> whole = shape[0];
  for (std::array<double, 2>& at : shape) at = {whole[0] - at[0], whole[1] - at[1]};
  return shape;
}

double gost_10550_rigidity(double mass, double drop) {
  const double weight = mass * kStandardGravity / (5 * kGostLength);  // N/m
  return weight * std::pow(kGostOverhang, 3) / cantilever_with(drop / kGostOverhang).beta;
}

double bending_length_rigidity(double weight, double length) {
  return weight * kStandardGravity * length * length * length;
}

}  // namespace drape::standards
