// The interpolant of core/README.md, section 2, and the odd bias law of section 3, by their own properties.
#include "reference/curve.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace drape::reference {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Points {
  std::vector<double> e{0}, f{0};
};

// Rising points with flat stretches and kinks: every fourth force step is 0; the others span three decades.
Points random_points(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Points p;
  for (int i = 1; i <= 12; ++i) {
    p.e.push_back(p.e.back() + 0.002 + 0.02 * unit(random));
    p.f.push_back(p.f.back() + (i % 4 == 0 ? 0 : std::pow(10, 3 * unit(random) - 1)));
  }
  return p;
}

// Gauss-Legendre with four points: exact for polynomials to degree 7, as f and f' are.
template <class Function>
double gauss(Function function, double a, double b) {
  constexpr std::array<double, 2> x{0.339981043584856265, 0.861136311594052575};
  constexpr std::array<double, 2> w{0.652145154862546143, 0.347854845137453857};
  double sum = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    sum += w[k] * (function((a + b - (b - a) * x[k]) / 2) + function((a + b + (b - a) * x[k]) / 2));
  }
  return sum * (b - a) / 2;
}

TEST(ReferenceCurve, PassesThroughEveryPointFromBothSides) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Points p = random_points(seed);
    const Curve c = curve_make(p.e, p.f, Below::kOdd);
    for (std::size_t i = 1; i < p.e.size(); ++i) {
      const double reach = 2 * kEpsilon * p.e[i];  // f moves by less than f' times this
      const double slack = 16 * kEpsilon * p.f.back() + 4 * reach * curve_slope(c, p.e[i]);
      EXPECT_NEAR(curve_value(c, p.e[i]), p.f[i], slack);
      EXPECT_NEAR(curve_value(c, p.e[i] - reach), p.f[i], slack);
      EXPECT_NEAR(curve_value(c, p.e[i] + reach), p.f[i], slack);
    }
  }
}

TEST(ReferenceCurve, RisesWhereThePointsRise) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Points p = random_points(seed);
    const Curve c = curve_make(p.e, p.f, Below::kOdd);
    for (std::size_t i = 0; i + 1 < p.e.size(); ++i) {
      const double s = (p.f[i + 1] - p.f[i]) / (p.e[i + 1] - p.e[i]);
      for (int k = 0; k <= 200; ++k) {
        const double e = p.e[i] + (p.e[i + 1] - p.e[i]) * k / 200.0;
        EXPECT_GE(curve_slope(c, e), -64 * kEpsilon * s) << "seed " << seed << ", elongation " << e;
      }
    }
  }
}

TEST(ReferenceCurve, SteepestAllowedEndSlopesLeaveAnEighthOfTheSecant) {
  Curve c = curve_make({0, 0.1}, {0, 10}, Below::kOdd);
  c.k = {200, 200};
  EXPECT_NEAR(curve_slope(c, 0.05), 100.0 / 8, 1e-12);
}

TEST(ReferenceCurve, StraightDiagramIsExact) {
  const double s = 130;
  std::vector<double> e{0, 0.01, 0.013, 0.05, 0.2}, f;
  for (double x : e) f.push_back(s * x);
  const Curve c = curve_make(e, f, Below::kCompression, 1, 0.002);
  for (double x : {-0.3, -0.002, -0.001, 0.0, 0.005, 0.0115, 0.03, 0.19, 0.2, 0.7}) {
    EXPECT_NEAR(curve_value(c, x), s * x, 8 * kEpsilon * s);
    EXPECT_NEAR(curve_slope(c, x), s, 64 * kEpsilon * s);
    EXPECT_NEAR(curve_energy(c, x), s * x * x / 2, 8 * kEpsilon * s);
  }
}

// On segment i |f''| <= (6 |j| + 60 |q|) t (1 - t)/d. So the mean of f'' over a distance delta next to a
// point is at most (6 |j| + 60 |q|) delta/(2 d^2), which vanishes with delta; a jump of f'' would stay.
TEST(ReferenceCurve, CurvatureVanishesAtEveryPoint) {
  const Points p = random_points(3);
  const Curve c = curve_make(p.e, p.f, Below::kOdd);
  for (std::size_t i = 0; i < p.e.size(); ++i) {
    for (int side : {-1, 1}) {
      const std::size_t left = side < 0 ? i - 1 : i;
      if ((i == 0 && side < 0) || left + 1 >= p.e.size()) continue;
      const double d = p.e[left + 1] - p.e[left], delta = 1e-4 * d;
      const double q = (p.f[left + 1] - p.f[left]) / d - (c.k[left] + c.k[left + 1]) / 2;
      const double bound = (6 * std::abs(c.k[left + 1] - c.k[left]) + 60 * std::abs(q)) * delta / (2 * d * d);
      const double curvature = (curve_slope(c, p.e[i] + side * delta) - curve_slope(c, p.e[i])) / delta;
      const double rounding = 64 * kEpsilon * (c.k[left] + c.k[left + 1] + std::abs(q)) / delta;
      EXPECT_LE(std::abs(curvature), bound + rounding) << "point " << i << ", side " << side;
    }
  }
}

TEST(ReferenceCurve, SlopeAndEnergyBelongToTheValue) {
  const Points p = random_points(7);
  for (const Curve& c :
       {curve_make(p.e, p.f, Below::kCompression, 0.3, 0.004),
        curve_make(p.e, p.f, Below::kCompression, 0, 0.004), curve_make(p.e, p.f, Below::kOdd)}) {
    std::vector<double> breaks;
    if (c.below == Below::kCompression) breaks = {-0.02, -0.004};
    if (c.below == Below::kOdd) breaks = {-p.e[2], -p.e[1]};
    for (double e : p.e) breaks.push_back(e);
    breaks.push_back(p.e.back() + 0.05);
    const double value_scale = p.f.back() + 0.05 * c.k.back();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const double a = breaks[i], b = breaks[i + 1];
      const double rise = gauss([&](double e) { return curve_slope(c, e); }, a, b);
      const double work = gauss([&](double e) { return curve_value(c, e); }, a, b);
      EXPECT_NEAR(curve_value(c, b) - curve_value(c, a), rise, 64 * kEpsilon * value_scale);
      EXPECT_NEAR(curve_energy(c, b) - curve_energy(c, a), work, 64 * kEpsilon * value_scale);
    }
    EXPECT_EQ(curve_energy(c, 0), 0);
  }
}

TEST(ReferenceCurve, ContinuationsBelowZero) {
  const std::vector<double> e{0, 0.01, 0.03}, f{0, 1, 4};
  const Curve press = curve_make(e, f, Below::kCompression, 0.4, 0.002);
  EXPECT_DOUBLE_EQ(curve_slope(press, -0.002), 40);  // r k_0
  EXPECT_DOUBLE_EQ(curve_slope(press, -0.5), 40);
  EXPECT_DOUBLE_EQ(curve_slope(press, -0.001), 70);  // halfway, the smoothstep is 1/2
  EXPECT_NEAR(curve_slope(press, -1e-12), 100, 1e-9);
  const Curve pull = curve_make(e, f, Below::kCompression, 0, 0.002);
  EXPECT_DOUBLE_EQ(curve_value(pull, -0.3), -100 * 0.002 / 2);  // what the blend has gathered, k_0 c/2
  EXPECT_EQ(curve_slope(pull, -0.3), 0);
  const Curve odd = curve_make(e, f, Below::kOdd);
  for (double x : {0.004, 0.02, 0.05}) EXPECT_EQ(curve_value(odd, -x), -curve_value(odd, x));
}

TEST(ReferenceCurve, WithoutPointsIsOff) {
  const Curve off = curve_make({}, {}, Below::kOdd);
  for (double e : {-0.1, 0.0, 0.1}) {
    EXPECT_EQ(curve_value(off, e), 0);
    EXPECT_EQ(curve_slope(off, e), 0);
    EXPECT_EQ(curve_energy(off, e), 0);
  }
}

double odd_residual(const Curve& g, const std::vector<double>& P) {
  double largest = 0;
  for (std::size_t i = 1; i < g.e.size(); ++i) {
    const double l1 = 1 + g.e[i], l2 = std::sqrt(2 - l1 * l1);
    const double made = curve_value(g, g.e[i]) + curve_value(g, std::abs(l2 - 1)) * l1 / l2;
    largest = std::max(largest, std::abs(made - P[i]));
  }
  return largest / P[g.e.size() - 1];
}

TEST(ReferenceOddLaw, SolvesItsEquation) {
  for (double last : {0.02, 0.0675, 0.12, 0.15}) {
    for (int n : {1, 3, 14}) {
      std::vector<double> e, P;
      for (int i = 0; i <= n; ++i) {
        const double x = double(i) / n;
        e.push_back(last * x);
        P.push_back(130 * (0.2 * x + 0.8 * x * x));
      }
      EXPECT_LE(odd_residual(odd_law(e, P), P), 1e-13) << n << " points to " << last;
    }
  }
}

// Near locking g(|e2|) l1/l2 exceeds g(L) several times. Adding half of the residual, the sweeps diverge.
TEST(ReferenceOddLaw, SolvesItsEquationNearLocking) {
  const std::vector<double> P{0, 10, 40};
  EXPECT_LE(odd_residual(odd_law({0, 0.2, 0.4}, P), P), 1e-12);
}

// One point: g is straight, g(|e2|) = g |e2|/L, so g = P/(1 + |e2| l1/(L l2)).
TEST(ReferenceOddLaw, StraightDiagramHasAClosedForm) {
  const double L = 0.1, P = 50, l1 = 1 + L, l2 = std::sqrt(2 - l1 * l1);
  EXPECT_NEAR(odd_law({0, L}, {0, P}).f[1], P / (1 + (1 - l2) * l1 / (L * l2)), 1e-13 * P);
}

TEST(ReferenceOddLaw, LeavesOutPointsBeyondLocking) {
  const double lock = std::numbers::sqrt2 - 1;
  EXPECT_EQ(below_locking({0, 0.1, lock - 2e-6, lock - 0.5e-6, lock, 0.5}).size(), 3u);
  const Curve g = odd_law({0, 0.1, 0.45}, {0, 5, 40});
  EXPECT_EQ(g.e.size(), 2u);
  EXPECT_DOUBLE_EQ(curve_slope(g, 0.45), g.f[1] / 0.1);
}

// A slack toe: the short diagonal, strained by a little more than L, would need a pull of the opposite sign,
// g(L) = -g(|e2|) l1/l2 < 0. The law stays at 0 there, and solves its equation at the points beyond.
TEST(ReferenceOddLaw, DoesNotFallBehindASlackToe) {
  const std::vector<double> e{0, 0.02, 0.04, 0.06}, P{0, 0, 18, 30};
  const Curve g = odd_law(e, P);
  EXPECT_EQ(g.f[1], 0);
  for (std::size_t i : {2u, 3u}) {
    const double l1 = 1 + e[i], l2 = std::sqrt(2 - l1 * l1);
    EXPECT_NEAR(g.f[i] + curve_value(g, 1 - l2) * l1 / l2, P[i], 1e-12 * P[3]);
  }
}

TEST(ReferenceOddLaw, ReportsWhenItHasNoAnswer) {
  EXPECT_THROW(odd_law({0, 0.5}, {0, 40}), std::runtime_error);
}

}  // namespace
}  // namespace drape::reference
