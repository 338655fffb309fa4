#include "sheet/cantilever.h"

#include <cmath>

#include "sheet/root.h"
#include "sheet/units.h"

namespace drape {

namespace {

constexpr double kRightAngle = 1.57079632679489661923;
constexpr double kStep = 0.02;  // of z, order 4: up to f/l = 0.985 the error of beta is below 3e-8 of it

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

// The classical scheme of Runge and Kutta.
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
  // The last step ends where phi is a right angle: Newton, phi' = turn.
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

// f/l rises as the end's angle falls from a right angle to 0, exponentially for soft cloth: phi(0) =
// (pi/2)/(1 + e^y).
Cantilever cantilever_with(double drop) {
  const auto at = [](double y) { return cantilever_of(kRightAngle / (1 + std::exp(y))); };
  return at(rising_root([&](double y) { return at(y).drop; }, drop, -12, 60));
}

double gost_10550_rigidity(double mass, double drop) {
  const double weight = mass * kStandardGravity / (5 * kGostLength);  // N/m
  return weight * std::pow(kGostOverhang, 3) / cantilever_with(drop / kGostOverhang).beta;
}

double bending_length_rigidity(double weight, double length) {
  return weight * kStandardGravity * length * length * length;
}

}  // namespace drape
