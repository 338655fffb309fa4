// The path of a curve's slope: sum |f'| over its turns/(max f' - min f').
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/monotone_curve.h"

namespace drape::math {
namespace {

struct Points {
  std::vector<double> e, f;
};

template <class F>
Points points_of(F f, int count, double end) {
  Points p;
  for (int k = 0; k < count; ++k) p.e.push_back(end * k / (count - 1)), p.f.push_back(f(p.e.back()));
  return p;
}

// f = e + a sin(2 pi n e)/(2 pi n) has the slope 1 + a cos(2 pi n e). On [0, 1] this goes 2 n times from one
// end of its range to the other: path 2 n. The interpolant's slope is off by O(h^2), and at the end points,
// where it is that of a secant, by (a/2) (2 pi n h)^2/3 of the range 2 a; each turn counts twice.
TEST(SlopePath, OfAWaveIsTwoForEachOfItsPeriods) {
  for (const int waves : {1, 2, 5}) {
    const int count = 400 * waves;
    const double w = 2 * std::numbers::pi * waves, h = w / (count - 1);
    const auto [e, f] = points_of([&](double x) { return x + 0.5 * std::sin(w * x) / w; }, count, 1);
    EXPECT_NEAR(slope_path(e, f), 2 * waves, 4 * waves * h * h) << waves;
  }
}

// The same closed form where the curve is a table of a law.
TEST(SlopePath, OfACurveIsThatOfItsPoints) {
  const double w = 2 * std::numbers::pi;
  const auto [e, f] = points_of([&](double x) { return x + 0.5 * std::sin(w * x) / w; }, kCurvePoints, 1);
  for (const Continuation& below :
       {Continuation{}, Continuation{.odd = true}, Continuation{.compression = 0}})
    EXPECT_NEAR(curve_slope_path(curve_make(e, f, below)), slope_path(e, f), 1e-12);
}

TEST(SlopePath, OfAStraightDiagramIsOne) {
  const auto [e, f] = points_of([](double x) { return 7 * x; }, 10, 0.3);
  EXPECT_EQ(slope_path(e, f), 1);
  for (const Continuation& below :
       {Continuation{}, Continuation{.odd = true}, Continuation{.compression = 0.2}})
    EXPECT_EQ(curve_slope_path(curve_make(e, f, below)), 1);
  EXPECT_EQ(slope_path({0, 0.1, 0.2, 0.3}, {0, 3.333, 6.667, 10}), 1);  // rounded to four digits
}

// A curve whose slope only rises or only falls has 1. The interpolant through n points of such a curve dips
// in its first and last segment only. There the slope is the secant's, and between them the bump takes back
// 30/16 (k_1 - k_0)/2 of a rise of (k_1 - k_0)/2 at the middle: less than 4/n in all.
TEST(SlopePath, OfAConvexOrConcaveDiagramGoesToOne) {
  for (const int count : {16, 32, 64})
    for (const double power : {2.0, 2.5, 0.7}) {
      const auto [e, f] =
          points_of([&](double x) { return power > 1 ? x + std::pow(x, power) : 2 * x - x * x; }, count, 1);
      const double path = slope_path(e, f);
      EXPECT_GE(path, 1);
      EXPECT_LT(path, 1 + 4.0 / count) << count << ", " << power;
    }
}

TEST(SlopePath, OfNoiseGrowsWithItsSamples) {
  const auto zigzag = [](double x) { return 100 * x + (std::lround(x * 1000) % 2 ? 1 : 0); };
  const auto [e, f] = points_of(zigzag, 1001, 1);
  EXPECT_GT(slope_path(e, f), 900);
}

}  // namespace
}  // namespace drape::math
