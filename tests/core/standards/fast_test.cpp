// FAST, and the shear of a trellis that KES and FAST share.
#include "standards/fast.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fabric/material_law.h"
#include "standards/kes.h"
#include "standards/trellis.h"

namespace drape::standards {
namespace {

// A sheet of a plain-woven wool, 168 g/m^2 ("Fabric Assurance by Simple Testing", report of a student's
// laboratory, majortests.com and bartleby.com): C = 15.00 and 14.50 mm give B = 5.56 and 5.02 uN m, EB5 = 4.7
// % gives G = 26.17 N/m.
TEST(Fast, FormulasOfAPublishedSheet) {
  EXPECT_NEAR(1e6 * fast_bending(168, 15.0), 5.56, 0.005);
  EXPECT_NEAR(1e6 * fast_bending(168, 14.5), 5.02, 0.005);
  EXPECT_NEAR(fast_shear(4.7), 26.17, 0.005);
}

// 5 gf/cm on a strip at 45 degrees, F/width = 4 G e: FAST rounds 122.6 to 123.
TEST(Fast, ShearIsThatOfTheStrip) {
  EXPECT_NEAR(fast_shear(1) / (5 * kGramForcePerCm / (4 * 0.01)), 1, 0.5 / 123);
}

scene::FabricSpec sheared(double g) {
  const Diagram d = trellis_bias(g);
  scene::FabricSpec fabric;
  for (std::size_t i = 0; i < d.percent.size(); ++i) {
    fabric.bias.elongation.push_back(d.percent[i] / 100);
    fabric.bias.force.push_back(d.force_per_width[i] * fabric.strip_width);
  }
  fabric.bias.jaws = false;
  return fabric;
}

// The law reproduces the shear stress, tau = (cos g/2)[g(e1)/l1 + g(|e2|)/l2] = G g: exactly at the
// diagram's points, and between them within the x^2/24, x = sin g, by which the law departs from a straight
// line.
TEST(Trellis, LawHasTheShearStress) {
  const double shear = 0.9 * kKesShear;
  std::vector<Problem> problems;
  const fabric::Law law = fabric::law_make(sheared(shear), {}, 0.01, "fabric.f", problems);
  ASSERT_TRUE(problems.empty());
  EXPECT_NEAR(math::curve_slope(law.bias, 0) / (2 * shear), 1, 1e-4);
  const auto stress = [&](double g) {
    const double l1 = std::sqrt(1 + std::sin(g)), l2 = std::sqrt(1 - std::sin(g));
    return std::cos(g) / 2 *
           (math::curve_value(law.bias, l1 - 1) / l1 + math::curve_value(law.bias, 1 - l2) / l2);
  };
  for (const double degrees : {0.5, 1.0, 2.5, 5.0, 8.0, 12.0}) {
    const double g = degrees * kRadiansPerDegree;
    EXPECT_NEAR(stress(g) / (shear * g), 1, std::pow(std::sin(g), 2) / 24 + 1e-5) << degrees;
  }
  const double at_a_point = std::asin(1.06 * 1.06 - 1);
  EXPECT_NEAR(stress(at_a_point) / (shear * at_a_point), 1, 1e-12);
}

// Shear has no jaws: the law is the same whether or not the scene takes jaws out of diagrams.
TEST(Trellis, JawsAreNotTakenOut) {
  std::vector<Problem> problems;
  fabric::LawOptions with, without;
  with.clamp_correction = true, without.clamp_correction = false;
  scene::FabricSpec fabric = sheared(50);
  const fabric::Law a = fabric::law_make(fabric, with, 0.01, "", problems),
                    b = fabric::law_make(fabric, without, 0.01, "", problems);
  EXPECT_EQ(math::curve_value(a.bias, 0.05), math::curve_value(b.bias, 0.05));
  fabric.bias.jaws = true;
  const fabric::Law c = fabric::law_make(fabric, with, 0.01, "", problems);
  EXPECT_GT(math::curve_value(b.bias, 0.05), 1.2 * math::curve_value(c.bias, 0.05));
}

}  // namespace
}  // namespace drape::standards
