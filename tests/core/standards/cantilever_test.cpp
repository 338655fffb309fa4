// The heavy elastica, and two bending tests based on it.
#include "standards/cantilever.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace drape::standards {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

// The same equation from the clamp: th'' = -beta (1 - s) cos th, th(0) = 0, with the slope at the clamp that
// gives th'(1) = 0.
double drop_from_the_clamp(double beta) {
  constexpr int kSteps = 4000;
  const double h = 1.0 / kSteps;
  double slope_at_end = 0, drop = 0;
  const auto shoot = [&](double curvature) {
    double th = 0, w = curvature;
    drop = 0;
    for (int i = 0; i < kSteps; ++i) {  // Runge and Kutta's classical scheme, drop' = sin th
      const double s = i * h;
      const auto turn = [&](double at, double angle) { return -beta * (1 - at) * std::cos(angle); };
      const double k1 = w, m1 = turn(s, th);
      const double k2 = w + h / 2 * m1, m2 = turn(s + h / 2, th + h / 2 * k1);
      const double k3 = w + h / 2 * m2, m3 = turn(s + h / 2, th + h / 2 * k2);
      const double k4 = w + h * m3, m4 = turn(s + h, th + h * k3);
      drop += h / 6 *
              (std::sin(th) + 2 * std::sin(th + h / 2 * k1) + 2 * std::sin(th + h / 2 * k2) +
               std::sin(th + h * k3));
      th += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), w += h / 6 * (m1 + 2 * m2 + 2 * m3 + m4);
    }
    slope_at_end = w;
  };
  double low = 0, high = beta;
  for (int k = 0; k < 200 && high - low > 1e-15 * high; ++k) {
    const double middle = (low + high) / 2;
    shoot(middle);
    (slope_at_end < 0 ? low : high) = middle;
  }
  return drop;
}

// Two ways to compute the same curve, each of fourth order: from the clamp (30/4000)^4 = 3e-9, from the end
// with kStep 3e-8.
TEST(Elastica, FromTheEndAsFromTheClamp) {
  for (const double beta : {0.2, 1.0, 5.0, 8.004, 30.0}) {
    const double drop = drop_from_the_clamp(beta);
    EXPECT_NEAR(cantilever_with(drop).beta / beta, 1, 3.3e-8) << beta;
    EXPECT_NEAR(cantilever_with(drop).drop, drop, 1e-14);
  }
}

// Small loads: f/l = beta/8, less by O(beta^2) relatively. Large loads: the bend at the clamp is a boundary
// layer, phi' = 2 sqrt(Z) sin(phi/2), so 1 - f/l = (2 - sqrt 2)/sqrt(beta), less by the next power of
// 1/sqrt(beta).
TEST(Elastica, Limits) {
  const Cantilever stiff = cantilever_with(0.001);
  EXPECT_NEAR(stiff.drop / (stiff.beta / 8), 1, stiff.beta * stiff.beta);
  const Cantilever soft = cantilever_with(0.98);
  const double contact_distance = (2 - std::numbers::sqrt2) / std::sqrt(soft.beta);
  EXPECT_NEAR((1 - soft.drop) / contact_distance, 1, 1 / std::sqrt(soft.beta));
}

// Peirce's angle: the line to the end falls by 41.5 degrees at beta = 8.004, so that c = O/2 has B = W c^3
// g.
TEST(Elastica, Peirce) {
  EXPECT_NEAR(cantilever_of_slope(41.5 / kDegrees).beta, 8.004, 0.0005);  // half of the last digit
}

// Found by load, drop and slope, each to the rounding of the root of its own quantity.
TEST(Elastica, IsFoundByLoadDropAndSlope) {
  for (const double beta : {0.01, 1.0, 8.0, 40.0, 1000.0}) {
    const Cantilever c = cantilever_of_load(beta);
    EXPECT_NEAR(c.beta / beta, 1, 1e-9);
    EXPECT_NEAR(cantilever_with(c.drop).beta / beta, 1, 1e-7);
    EXPECT_NEAR(cantilever_of_slope(std::atan2(c.drop, c.reach)).beta / beta, 1, 1e-7);
  }
}

// At its end the shape is the cantilever, by steps of another size: h^4 of both, 3e-8.
TEST(Elastica, ShapeEndsWhereItsCantileverDoes) {
  for (const double beta : {0.01, 8.0, 1000.0}) {
    const Cantilever c = cantilever_of_load(beta);
    const auto shape = cantilever_shape(beta, 50);
    EXPECT_EQ(shape[0], (std::array<double, 2>{0, 0}));
    EXPECT_NEAR(shape[50][0], c.reach, 3e-8);
    EXPECT_NEAR(shape[50][1], c.drop, 3e-8);
  }
}

// The overhang of 65 mm with EI = 1370 uN cm2 on 30 mm; g/m2 -> drop and tip in mm.
TEST(Elastica, GivesTheOverhangOfTheBendingTest) {
  for (const auto& [grams, down, out] :
       {std::array{100.0, 59.561, 14.32}, std::array{120.0, 60.092, 12.77}, std::array{150.0, 60.660, 11.14},
        std::array{180.0, 61.068, 9.99}, std::array{200.0, 61.284, 9.40}}) {
    const Cantilever c = cantilever_of_load(1e-3 * grams * 9.81 * std::pow(0.065, 3) / (1370e-10 / 0.03));
    EXPECT_NEAR(65 * c.drop, down, 1.1e-3);
    EXPECT_NEAR(65 * c.reach, out, 0.011);
  }
}

// Rows of a report by GOST 10550-93 (ukrbukva.net, page 8,68738): m in g, f in mm, A by the standard's table,
// EI in uN cm^2.
struct Row {
  double m, f, A, rigidity;
};
constexpr Row kReport[] = {{0.66, 66.5, 125.81, 220.57}, {0.64, 62, 35.49, 758.23},
                           {0.24, 61, 30.92, 326.36},    {0.26, 54.5, 14.79, 739.14},
                           {0.74, 62, 35.49, 876.70},    {0.75, 55.5, 15.63, 2017.6}};

// EI = 42046 m/A to the digits of 42046, with the elastica's load for A. With the report's A it is the
// report's EI, to its digits.
TEST(Gost10550, Rigidity) {
  for (const Row& row : kReport) {
    const double beta = cantilever_with(row.f / 70).beta,
                 rigidity = 1e10 * gost_10550_rigidity(row.m * 1e-3, row.f * 1e-3);
    EXPECT_NEAR(rigidity * beta / row.m, 42046, 0.5);
    EXPECT_NEAR(rigidity * beta / row.A, row.rigidity, 2e-4 * row.rigidity) << row.f;
  }
}

// The standard's A is beta of the elastica: a strip of the load A drops by the report's value, to the half
// millimetre of its scale.
TEST(Gost10550, TableIsTheElastica) {
  for (const Row& row : kReport) {
    double low = 0.01, high = 0.99;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (cantilever_with(middle).beta < row.A ? low : high) = middle;
    }
    EXPECT_NEAR(70 * low, row.f, 0.5) << row.A;
  }
}

// 0.132 kg/m^2 and c = 19 mm: B = 8.88e-6 N m.
TEST(BendingLength, Rigidity) { EXPECT_NEAR(bending_length_rigidity(0.132, 0.019), 8.88e-6, 0.005e-6); }

}  // namespace
}  // namespace drape::standards
