// Diagrams from the samples of a tensile tester: known curves with seeded noise.
#include "laboratory/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "laboratory/write_smoothed.h"
#include "math/monotone_curve.h"
#include "scene_file.h"

namespace drape::laboratory {

using namespace tests;
namespace {

constexpr double kNoise = 0.3;  // N
constexpr int kSamples = 801;
constexpr double kEnd = 0.1;  // strain

// A warp that stiffens, N at a strain.
double pull_at(double strain) {
  const double percent = 100 * strain;
  return 12 * percent + 3 * std::pow(percent, 2.2);
}

double soft_at(double strain) { return 3 * std::pow(100 * strain, 2.2); }

template <class F>
scene::DiagramSpec record(F force, double noise, int count = kSamples, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> off(0, 1);
  scene::DiagramSpec d;
  for (int k = 0; k < count; ++k) {
    d.elongation.push_back(kEnd * k / (count - 1));
    d.force.push_back(force(d.elongation.back()) + noise * off(random));
  }
  return d;
}

// Root mean square of the distance between the interpolant and a curve.
template <class F>
double distance(const SmoothedDiagram& d, F force) {
  const math::Curve curve = math::curve_make(d.diagram.elongation, d.diagram.force, {});
  constexpr int kPlaces = 1000;
  double square = 0;
  for (int k = 0; k <= kPlaces; ++k) {
    const double e = kEnd * k / kPlaces, off = math::curve_value(curve, e) - force(e);
    square += off * off;
  }
  return std::sqrt(square / (kPlaces + 1));
}

void expect_diagram(const SmoothedDiagram& d) {
  EXPECT_EQ(d.problem, "");
  EXPECT_LE(d.diagram.elongation.size(), std::size_t(math::kCurvePoints));
  ASSERT_GE(d.diagram.elongation.size(), 2u);
  EXPECT_EQ(d.diagram.elongation[0], 0);
  EXPECT_EQ(d.diagram.force[0], 0);
  for (std::size_t k = 1; k < d.diagram.force.size(); ++k) {
    EXPECT_GT(d.diagram.elongation[k], d.diagram.elongation[k - 1]);
    EXPECT_GE(d.diagram.force[k], d.diagram.force[k - 1]);
  }
}

// The standard error of a sample variance of n samples is sqrt(2/n), of the scatter half of that. Third
// differences of neighbours correlate, which makes it about twice as large; three of these.
TEST(Smooth, EstimatesTheNoiseOfALoadCell) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const SmoothedDiagram d = diagram_smooth(record(pull_at, kNoise, kSamples, seed), 0);
    EXPECT_NEAR(d.resolution / kNoise, 1, 3 * 2 * std::sqrt(0.5 / kSamples)) << seed;
  }
}

// A curve whose residual is as large as the noise is at most as far from the truth as the samples are. The
// residual may exceed the resolution by three times sqrt(2/n)/2 (monotone_fit.h), and the points by 2 %.
TEST(Smooth, GivesAKnownCurveBackWithinTheNoise) {
  const double largest = kNoise * (1.02 + 1.5 * std::sqrt(2.0 / kSamples));
  for (const unsigned seed : {1u, 2u, 3u, 4u})
    for (const bool soft : {false, true}) {
      const auto curve = soft ? soft_at : pull_at;
      const SmoothedDiagram d = diagram_smooth(record(curve, kNoise, kSamples, seed), kNoise);
      expect_diagram(d);
      EXPECT_LT(distance(d, curve), kNoise) << seed << soft;
      EXPECT_LE(d.rms, largest) << seed << soft;
      EXPECT_GT(d.rms, 0.9 * kNoise) << "so much is noise: " << seed << soft;
      EXPECT_GT(d.path_before, 20) << seed << soft;
      EXPECT_LE(d.path_after, 1.5) << seed << soft;
      EXPECT_EQ(d.pretension, 0) << seed << soft;
      EXPECT_EQ(d.slack, 0) << "a soft beginning is no slack: " << seed << soft;
    }
}

// Of a straight diagram nothing but the noise travels.
TEST(Smooth, GivesAStraightLineBack) {
  const auto line = [](double e) { return 2000 * e; };
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const SmoothedDiagram d = diagram_smooth(record(line, kNoise, kSamples, seed), kNoise);
    expect_diagram(d);
    EXPECT_LT(distance(d, line), kNoise) << seed;
    EXPECT_LE(d.path_after, 1.5) << seed;
  }
}

// The pretension is the parabola through the first tenth of the samples at 0. Its standard error is
// 3 sigma/sqrt(80); of the truth it misses less, and four of them are allowed.
TEST(Smooth, SubtractsAPretensionAndLeavesTheBreakOut) {
  constexpr double kPretension = 2;
  const double error = 4 * 3 * kNoise / std::sqrt(kSamples / 10);
  for (const unsigned seed : {1u, 2u, 3u}) {
    scene::DiagramSpec samples =
        record([](double e) { return pull_at(e) + kPretension; }, kNoise, kSamples, seed);
    for (const double force : {60.0, 5.0, 2.0})
      samples.elongation.push_back(samples.elongation.back() + 3e-4), samples.force.push_back(force);
    const SmoothedDiagram d = diagram_smooth(samples, 0);
    expect_diagram(d);
    EXPECT_NEAR(d.pretension, kPretension, error) << seed;
    EXPECT_GE(d.record.after_break, 3u) << seed;
    EXPECT_LT(d.record.after_break, 20u) << seed;
    EXPECT_LT(distance(d, pull_at), kNoise + error) << seed;
    EXPECT_LE(d.path_after, 1.5) << seed;
  }
}

// Where the slack ends is known as well as force over slope: 4 sigma 3/sqrt(80)/(12 N per percent).
TEST(Smooth, LeavesASlackOut) {
  const auto slack = [](double e) { return e < 0.01 ? 0 : pull_at(e - 0.01); };
  const double error = 4 * kNoise * 3 / std::sqrt(kSamples / 10) / 1200;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const SmoothedDiagram d = diagram_smooth(record(slack, kNoise, kSamples, seed), 0);
    expect_diagram(d);
    EXPECT_NEAR(d.slack, 0.01, error) << seed;
    EXPECT_NEAR(d.diagram.elongation.back(), kEnd - d.slack, 1e-7) << seed;  // six digits of percent
  }
}

TEST(Smooth, KeepsASmoothDiagram) {
  const scene::DiagramSpec samples = record(pull_at, 0, 15);
  const SmoothedDiagram d = diagram_smooth(samples, 0.5);
  EXPECT_TRUE(d.is_smooth);
  EXPECT_EQ(d.diagram.force, samples.force);
  EXPECT_EQ(d.diagram.elongation, samples.elongation);
  EXPECT_LT(d.path_after, 1.2);
}

// But for a pretension of its record, which is exact there.
TEST(Smooth, ShiftsASmoothRecord) {
  const SmoothedDiagram d = diagram_smooth(record([](double e) { return pull_at(e) + 2; }, 0, 15), 0);
  EXPECT_FALSE(d.is_smooth);
  EXPECT_EQ(d.pretension, 2);
  ASSERT_EQ(d.diagram.force.size(), 15u);
  for (std::size_t k = 0; k < 15; ++k)  // six digits
    EXPECT_NEAR(d.diagram.force[k], pull_at(d.diagram.elongation[k]), 5e-6 * 600) << k;
}

// Samples in any order, some of one elongation, give the diagram of their means.
TEST(Smooth, TakesRepeatedAndUnsortedSamples) {
  scene::DiagramSpec samples = record(pull_at, kNoise);
  std::mt19937 random(7);
  std::normal_distribution<double> off(0, 1);
  for (std::size_t k = 0; k + 1 < kSamples; k += 5) {
    samples.elongation[k + 1] = samples.elongation[k];
    samples.force[k + 1] = pull_at(samples.elongation[k]) + kNoise * off(random);
  }
  for (std::size_t k = 3; k + 1 < kSamples; k += 7) {
    std::swap(samples.elongation[k], samples.elongation[k - 1]);
    std::swap(samples.force[k], samples.force[k - 1]);
  }
  const SmoothedDiagram d = diagram_smooth(samples, kNoise);
  expect_diagram(d);
  EXPECT_TRUE(d.record.reordered);
  EXPECT_LT(distance(d, pull_at), kNoise);
}

TEST(Smooth, TellsWhatIsNoDiagram) {
  scene::DiagramSpec d;
  d.elongation = {0, 0.01};
  d.force = {0.1, 0};
  EXPECT_EQ(diagram_smooth(d, 0).problem,
            "has 1 elongation from 0 to its greatest force; wanted: at least 3");
  d.elongation = {0, 0.01, 0.02, 0.03};
  d.force = {0, -1, -2, -1};
  EXPECT_EQ(diagram_smooth(d, 0).problem, "has no force above 0 N; wanted: a strip that pulls");
}

// The text keeps its comments and line ends; the samples stay as they were written.
TEST(WriteSmoothed, KeepsTheTextAndTheSamples) {
  const std::string text =
      "# Ours, \xc2\xb5\r\nareal_density = 0.2   # kg/m2\r\n"
      "weft = { elongation_percent = [0, 1, 2.50], force_cN = [0, 300,\r\n  900] } # here\r\n"
      "[warp]\r\nelongation_percent = [0, 1, 2]  # of the gauge\r\nforce = [\r\n 0.2, # a pretension\r\n 5, "
      "4]\r\n";
  scene::DiagramSpec warp;
  warp.elongation = {0, 0.01, 0.02};
  warp.force = {0, 4, 4.25};
  scene::DiagramSpec weft = warp;
  weft.force_as = {"force_cN", "cN", 100};
  std::vector<Problem> problems;
  const std::string stored = write_smoothed(text, "f", {warp, weft, {}}, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(stored,
            "# Ours, \xc2\xb5\r\nareal_density = 0.2   # kg/m2\r\n"
            "weft = { elongation_percent = [0.0, 1.0, 2.0], force_cN = [0.0, 400.0, 425.0], raw = { "
            "elongation_percent = [0, 1, 2.50], force_cN = [0, 300,\r\n  900] } } # here\r\n"
            "[warp]\r\nelongation_percent = [0.0, 1.0, 2.0]  # of the gauge\r\nforce = [0.0, 4.0, 4.25]\r\n"
            "raw = { elongation_percent = [0, 1, 2], force = [\r\n 0.2, # a pretension\r\n 5, 4] }\r\n");
  EXPECT_EQ(write_smoothed(stored, "f", {warp, weft, {}}, problems), stored) << "a second time";
  EXPECT_EQ(write_smoothed("weft = 5\n", "f", {warp, {}, {}}, problems), "");
  EXPECT_EQ(problems.size(), 1u);
}

}  // namespace
}  // namespace drape::laboratory
