// Curves read in lanes use the segment that a search from the first one finds: core/README.md, section 2.
#include "forces/tension.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simd/lane_scalar.h"

namespace drape::forces {
namespace {

using Lane = simd::ScalarLane<false>;

// Evenly spaced points; points crowded at 10 % beside a single one at 50 %; with and without compression.
std::vector<math::Curve> curves() {
  std::vector<math::Curve> all;
  for (const math::Continuation& below :
       {math::Continuation{true, 1, 0}, math::Continuation{false, 0.2, 0.002}}) {
    std::vector<double> e{0}, f{0}, crowded{0}, force{0};
    for (int i = 1; i <= 30; ++i) e.push_back(0.01 * i), f.push_back(i + 0.02 * i * i);
    for (int i = 0; i < 40; ++i) crowded.push_back(0.1 + 1e-5 * i), force.push_back(1 + 1e-3 * i * i);
    crowded.push_back(0.5), force.push_back(9);
    all.push_back(math::curve_make(e, f, below));
    all.push_back(math::curve_make(crowded, force, below));
  }
  return all;
}

void expect_read(const math::Curve& curve, double e) {
  const double value = math::curve_value(curve, e), slope = math::curve_slope(curve, e);
  // Both round some ten terms, the largest of which is no larger than the force or slope and their values at
  // 50 %.
  EXPECT_NEAR(CurveTension{&curve}(Lane(e)).v, value, 1e-14 * (std::abs(value) + 10)) << e;
  EXPECT_NEAR(CurveTension{&curve}.slope(Lane(e)).v, slope, 1e-12 * (std::abs(slope) + 1e3)) << e;
}

TEST(Tension, IsTheCurvesBetweenAtAndBesideItsPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> strain(-0.6, 0.8);
  for (const math::Curve& curve : curves()) {
    ASSERT_GE(curve.bin_ends, 1);
    for (int k = 0; k < 10000; ++k) expect_read(curve, strain(random));
    for (int k = 0; k + 1 < curve.segments; ++k) {
      const double end = curve.segment[k].end;
      for (double e : {std::nextafter(end, -1.0), end, std::nextafter(end, 1.0)}) expect_read(curve, e);
    }
    for (double e : {-1e6, -1.0, 1.0, 1e6}) {
      const double value = math::curve_value(curve, e);
      EXPECT_NEAR(CurveTension{&curve}(Lane(e)).v, value, 1e-14 * std::abs(value)) << e;
    }
    for (double e : {double(NAN), double(INFINITY)}) {
      EXPECT_FALSE(std::isfinite(CurveTension{&curve}(Lane(e)).v)) << e;
      EXPECT_FALSE(std::isfinite(math::curve_value(curve, e))) << e;
    }
  }
}

// A segment is never mistaken for its neighbour, although a bin may begin in either: the force at an end is
// that of the next segment, bit for bit.
TEST(Tension, TakesTheSegmentThatBeginsAtAnEnd) {
  for (const math::Curve& curve : curves())
    for (int k = 1; k < curve.segments; ++k) {
      const double end = curve.segment[k - 1].end;
      EXPECT_EQ(CurveTension{&curve}(Lane(end)).v,
                curve.segment[k].c0 + (end - curve.segment[k].origin) * curve.segment[k].c1)
          << k;
    }
}

TEST(Tension, OfALawThatIsOffIsNothing) {
  const math::Curve off;
  for (double e : {-1.0, 0.0, 0.3}) EXPECT_EQ(CurveTension{&off}(Lane(e)).v, 0);
}

}  // namespace
}  // namespace drape::forces
