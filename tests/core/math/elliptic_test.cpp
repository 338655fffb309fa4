// The elliptic integral of the second kind against a quadrature of its integrand.
#include "math/elliptic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drape::math {
namespace {

// Gauss-Legendre, 5 points in each of `parts` intervals: the error falls with their number to the power
// of 10.
double quadrature(double angle, double modulus, int parts) {
  constexpr double kAt[] = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr double kWeight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const auto integrand = [&](double u) { return std::sqrt(1 - std::pow(modulus * std::sin(u), 2)); };
  const double half = angle / parts / 2;
  double total = 0;
  for (int part = 0; part < parts; ++part) {
    const double middle = (2 * part + 1) * half;
    total += half * kWeight[0] * integrand(middle);
    for (int k = 1; k < 3; ++k)
      total += half * kWeight[k] * (integrand(middle - half * kAt[k]) + integrand(middle + half * kAt[k]));
  }
  return total;
}

TEST(Elliptic, IsTheIntegralOfItsIntegrand) {
  for (const double modulus : {0.0, 1e-6, 0.1, 0.5, 0.8, 0.95, 0.99})
    for (const double angle : {1e-8, 0.3, 1.0, 1.5, 1.5707963, 1.6, 3.0, 3.2, 10.0, -0.7, -4.0})
      EXPECT_NEAR(elliptic_second(angle, modulus), quadrature(angle, modulus, 200),
                  1e-14 * std::max(1.0, std::abs(angle)))
          << "angle " << angle << ", modulus " << modulus;
}

TEST(Elliptic, KnownValues) {
  constexpr double kRight = std::numbers::pi / 2;
  EXPECT_EQ(elliptic_second(0, 0.7), 0);
  EXPECT_NEAR(elliptic_second(kRight, 0), kRight, 1e-15);
  EXPECT_NEAR(elliptic_second(kRight, 1), 1, 1e-15);  // a needle
  EXPECT_NEAR(elliptic_second(0.5, 1), std::sin(0.5), 1e-15);
  EXPECT_NEAR(elliptic_second(kRight, std::sqrt(0.5)), 1.3506438810476755, 2e-15);  // a lemniscate
}

}  // namespace
}  // namespace drape::math
