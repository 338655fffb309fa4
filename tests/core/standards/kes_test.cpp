// KES-F: units, and a diagram that reproduces the figures of the sheet.
#include "standards/kes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/monotone_curve.h"

namespace drape::standards {
namespace {

math::Curve curve_of(const Diagram& d) {
  std::vector<double> e;
  for (const double percent : d.percent) e.push_back(percent / 100);
  return math::curve_make(e, d.force_per_width, {});
}

TEST(Kes, Units) {
  EXPECT_NEAR(kKesShear, 56.2, 0.05);          // N/m per rad per gf/(cm deg)
  EXPECT_NEAR(kKesBending, 9.807e-5, 0.5e-8);  // N m per gf cm^2/cm
  EXPECT_NEAR(500 * kGramForcePerCm, 490.3, 0.05);
  EXPECT_EQ(kKesWeight, 0.01);
}

// LT = WT/(Fm EMT/2) on six denims: EMT, WT and LT of a published table, doi 10.1155/2016/4614168, table 5,
// columns B, D, F, whose figures agree with each other (means of warp and weft: the last digit of each,
// twice).
TEST(Kes, LinearityOfAPublishedSheet) {
  EXPECT_NEAR(kes_linearity(5.735, 9.400, 500), 0.655, 0.001);
  EXPECT_NEAR(kes_linearity(5.135, 8.675, 500), 0.676, 0.001);
  EXPECT_NEAR(kes_linearity(5.455, 8.950, 500), 0.657, 0.001);
  EXPECT_NEAR(kes_energy(5.735, kes_linearity(5.735, 9.4, 500), 500), 9.4, 1e-14);
}

// F(EMT) = Fm, the integral of F up to EMT = WT: to the rounding of some ten sums.
TEST(Kes, TensionGivesTheFiguresBack) {
  for (const double fm : {500.0, 50.0})
    for (const double lt : {0.2, 0.5, 0.676, 0.9, 1.0, 1.2, 1.8}) {
      const double emt = 5.135, wt = kes_energy(emt, lt, fm);
      const math::Curve curve = curve_of(kes_tension(emt, wt, fm));
      EXPECT_NEAR(math::curve_value(curve, emt / 100) / (fm * kGramForcePerCm), 1, 1e-14) << lt;
      EXPECT_NEAR(math::curve_energy(curve, emt / 100) / (wt * kGramForcePerCm), 1, 1e-13) << lt;
    }
}

// Between these points the diagram is the exponential: with F(EMT/2)/Fm = 1/(exp(a/2) + 1), all points lie
// on it and its slopes are above 0. Its own LT = 2 [1/a - 1/(exp(a) - 1)] is that of the sheet except for
// the interpolation, of fourth order in a/10 a segment.
TEST(Kes, TensionIsExponential) {
  for (const double lt : {0.2, 0.5, 0.676, 1.2, 1.8}) {
    const Diagram d = kes_tension(4, kes_energy(4, lt, 500), 500);
    ASSERT_EQ(d.percent.size(), 11u);
    const double fm = d.force_per_width.back(), a = 2 * std::log(fm / d.force_per_width[5] - 1);
    for (std::size_t i = 0; i <= 10; ++i) {
      EXPECT_NEAR(d.force_per_width[i], fm * std::expm1(a * double(i) / 10) / std::expm1(a), 1e-11 * fm);
      if (i) {
        EXPECT_GT(d.force_per_width[i], d.force_per_width[i - 1]);
      }
      EXPECT_GT(math::curve_slope(curve_of(d), d.percent[i] / 100), 0);
    }
    EXPECT_NEAR(2 * (1 / a - 1 / std::expm1(a)), lt, 1e-2 * std::pow(a / 10, 2) + 1e-4) << a;
  }
}

}  // namespace
}  // namespace drape::standards
