// Curves against their formulas, and every fault of an outline. core/README.md, section 1.
#include "piece/outline/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numbers>
#include <random>

namespace drape::piece {
namespace {

constexpr double kPi = std::numbers::pi;

scene::PieceSpec square() {
  scene::PieceSpec piece;
  piece.cell = 0.1;
  piece.outline = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  return piece;
}

std::vector<std::string> faults_of(const scene::PieceSpec& piece) {
  std::vector<Problem> problems;
  outline_problems(piece, "piece.p", problems);
  std::vector<std::string> texts;
  for (const Problem& p : problems) texts.push_back(scene::problem_text(p));
  return texts;
}

// |p - centre| = r for every point of an arc, and it goes round as told: area under the chord = r^2 (a - sin
// a)/2 less what the chords cut off, at most 2/3 of the sag along the arc.
TEST(Outline, ArcsLieOnTheirCircleAndTurnAsSpecified) {
  for (const double radius : {1.0, 1.2, 7.0, 1e4})
    for (const bool large : {false, true})
      for (const bool right : {false, true}) {
        scene::PieceSpec piece = square();
        scene::CurveSpec arc;
        arc.edge = 0;
        arc.radius = radius;
        arc.large = large;
        arc.right = right;
        piece.curves = {arc};
        const std::vector<Vec2> points = outline_edge(piece, 0);
        EXPECT_EQ(points.front(), (Vec2{0, 0}));
        EXPECT_EQ(points.back(), (Vec2{2, 0}));
        // edge 0 runs along +x: where the angle rises the arc bulges to -y; its centre is above or below
        const double angle = 2 * (large ? kPi - std::asin(1 / radius) : std::asin(1 / radius));
        const double centre = std::sqrt(radius * radius - 1) * (large == right ? -1 : 1);
        for (const Vec2& p : points)
          ASSERT_NEAR(std::hypot(p[0] - 1, p[1] - centre), radius, 1e-14 * radius * radius + 1e-15);
        const double bulge = (right ? 1 : -1) * radius * radius * (angle - std::sin(angle)) / 2;
        const double cut = angle * radius * piece.cell * 1e-3 * 2 / 3;
        EXPECT_LE(std::abs(polygon_area(points) - bulge), cut * (1 + 1e-9) + 1e-9 * std::abs(bulge));
        const std::size_t n =
            std::size_t(std::max(1.0, std::ceil(angle / (2 * std::acos(1 - piece.cell * 1e-3 / radius)))));
        if (radius < 1e3) {
          EXPECT_EQ(points.size(), n + 1);
        }
      }
}

// Chords stay within b/1000 of the curve: its points at the middle of each chord's parameter.
TEST(Outline, BezierChordsStayWithinTheirSag) {
  scene::PieceSpec piece = square();
  for (const double cell : {0.5, 0.1, 0.02})
    for (const bool cubic : {false, true}) {
      piece.cell = cell;
      scene::CurveSpec curve;
      curve.edge = 0;
      curve.bezier = {{0.5, -1.5}};
      if (cubic) curve.bezier.push_back({1.75, -0.25});
      piece.curves = {curve};
      const std::vector<Vec2> points = outline_edge(piece, 0);
      const int n = int(points.size()) - 1;
      for (int k = 0; k < n; ++k) {
        const double t = (k + 0.5) / n, s = 1 - t;
        Vec2 r;
        for (std::size_t a = 0; a < 2; ++a)
          r[a] = cubic ? 3 * s * s * t * curve.bezier[0][a] + 3 * s * t * t * curve.bezier[1][a] +
                             t * t * t * (a ? 0 : 2)
                       : 2 * s * t * curve.bezier[0][a] + t * t * (a ? 0 : 2);
        const Vec2 p = points[std::size_t(k)], q = points[std::size_t(k) + 1];
        const double off = std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) /
                           std::hypot(q[0] - p[0], q[1] - p[1]);
        ASSERT_LE(off, cell * 1e-3);
      }
      EXPECT_TRUE(faults_of(piece).empty());
    }
}

TEST(Outline, LoopsTurnTheRightWayAndRememberTheirEdges) {
  scene::PieceSpec piece = square();
  piece.holes = {{{0.5, 0.5}, {1, 0.5}, {1, 1}}};
  for (int turn = 0; turn < 2; ++turn) {
    const std::vector<OutlineLoop> loops = outline_flatten(piece);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(polygon_area(loops[0].points), 4);
    EXPECT_EQ(polygon_area(loops[1].points), -0.125);
    EXPECT_EQ(outline_area(loops), 3.875);
    for (std::size_t l = 0; l < 2; ++l)
      for (std::size_t k = 0, n = loops[l].points.size(); k < n; ++k) {
        const std::vector<Vec2>& given = l ? piece.holes[0] : piece.outline;
        const Vec2 p = given[std::size_t(loops[l].edge[k])];
        const Vec2 q = given[std::size_t(loops[l].edge[k] + 1) % given.size()];
        const Vec2 from = loops[l].points[k], to = loops[l].points[(k + 1) % n];
        EXPECT_TRUE((from == p && to == q) || (from == q && to == p));
      }
    std::reverse(piece.outline.begin(), piece.outline.end());
    std::reverse(piece.holes[0].begin(), piece.holes[0].end());
  }
  EXPECT_NEAR(outline_distance(outline_flatten(piece), {0.9, 0.6}), 0.1, 1e-15);
  EXPECT_EQ(outline_distance(outline_flatten(piece), {0.3, 0.3}), 0);
  EXPECT_EQ(outline_distance(outline_flatten(piece), {5, 6}), 5);
}

TEST(Outline, EveryFaultIsOneSentence) {
  const auto reported = [](const scene::PieceSpec& piece) {
    const std::vector<std::string> texts = faults_of(piece);
    std::string all;
    for (const std::string& t : texts) all += t + "\n";
    return all;
  };
  EXPECT_EQ(reported(square()), "");
  scene::PieceSpec p = square();
  p.outline = {{0, 0}, {1, 0}};
  EXPECT_EQ(reported(p), "piece.p.outline has 2 points; allowed: at least 3\n");
  p.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
  EXPECT_EQ(reported(p), "piece.p.outline repeats its first point at the end; an outline closes by itself\n");
  p.outline = {{0, 0}, {1, 0}, {1, 0}, {1, 1}};
  EXPECT_EQ(reported(p), "piece.p.outline[2] = [1, 0] m repeats point 1; allowed: more than 2e-09 m away\n");
  p.outline = {{0, 0}, {1, 1}, {2, 2}, {1.5, 1.5}};
  EXPECT_EQ(reported(p), "piece.p.outline encloses no area\n");
  p.outline = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  EXPECT_EQ(reported(p), "piece.p.outline is no simple outline: edge 0 crosses edge 2 at [1, 1] m\n");
  p.outline = {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}};  // a vertex on an edge: both its edges touch it
  EXPECT_EQ(reported(p),
            "piece.p.outline is no simple outline: edge 0 touches edge 2 at [1, 0] m\n"
            "piece.p.outline is no simple outline: edge 0 touches edge 3 at [1, 0] m\n");
  p.outline = {{0, 0}, {2, 0}, {2, 2}, {2, 1}, {0, 1}};  // folds back
  EXPECT_EQ(reported(p),
            "piece.p.outline is no simple outline: edge 1 touches edge 2 at [2, 1] m\n"
            "piece.p.outline is no simple outline: edge 1 touches edge 3 at [2, 1] m\n");
  p = square();
  p.cell = 2.5;
  EXPECT_EQ(reported(p), "piece.p.cell = 2.5 m; allowed: at most the piece's shorter side, 2 m\n");
  p.cell = 1e-5;
  EXPECT_EQ(reported(p),
            "piece.p.cell = 1e-05 m makes about 4.00004e+10 nodes; allowed: at most 4e+06 a piece\n");
}

TEST(Outline, FaultsOfCurves) {
  const auto reported = [](const scene::CurveSpec& curve, int times = 1) {
    scene::PieceSpec piece = square();
    for (int k = 0; k < times; ++k) piece.curves.push_back(curve);
    const std::vector<std::string> texts = faults_of(piece);
    return texts.size() == 1 ? texts[0] : std::to_string(texts.size()) + " faults";
  };
  scene::CurveSpec c;
  c.edge = 4;
  c.radius = 1;
  EXPECT_EQ(
      reported(c),
      "piece.p.curves[0].edge = 4; allowed: 0 to 3 (edge i runs from point i of the outline to the next)");
  c.edge = 1;
  EXPECT_EQ(reported(c), "0 faults");
  EXPECT_EQ(reported(c, 2),
            "piece.p.curves[1].edge = 1 has a curve already, curves[0]; allowed: one an edge");
  c.radius = 0.99;
  EXPECT_EQ(reported(c), "piece.p.curves[0].arc = 0.99 m; allowed: at least 1 m, half the chord of edge 1");
  c.bezier = {{0, 0}, {1, 1}, {2, 2}};
  EXPECT_EQ(reported(c),
            "piece.p.curves[0].bezier has 3 control points; allowed: 1 (quadratic) or 2 (cubic)");
  c.bezier = {{5, 6}, {5, -4}};  // y - 1 is odd about the middle and 0 three times: a loop
  EXPECT_EQ(reported(c).substr(0, 62), "piece.p.outline is no simple outline: edge 1 crosses itself at");
  c.bezier = {{-1, 1}};  // its top is at x = 0.5
  EXPECT_EQ(reported(c), "0 faults");
  c.bezier = {{-3, 1}};  // x = -0.5
  EXPECT_EQ(reported(c).substr(0, 61), "piece.p.outline is no simple outline: edge 1 crosses edge 3 a");
}

TEST(Outline, FaultsOfHoles) {
  const auto reported = [](const std::vector<std::vector<Vec2>>& holes) {
    scene::PieceSpec piece = square();
    piece.holes = holes;
    const std::vector<std::string> texts = faults_of(piece);
    return texts.size() == 1 ? texts[0] : std::to_string(texts.size()) + " faults";
  };
  const std::vector<Vec2> hole = {{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}};
  EXPECT_EQ(reported({hole}), "0 faults");
  EXPECT_EQ(reported({{{3, 3}, {4, 3}, {4, 4}}}), "piece.p.holes[0] lies outside the outline, at [4, 4] m");
  EXPECT_EQ(reported({{{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}}).substr(0, 40),
            "piece.p.holes[0] lies outside the outlin");
  EXPECT_EQ(reported({hole, {{0.7, 0.7}, {1, 0.7}, {1, 1}}}),
            "piece.p.holes[1] lies inside holes[0], at [1, 1] m; holes do not nest");
  EXPECT_EQ(reported({{{0.5, 0.5}, {1, 0.5}, {2, 1}}}),
            "2 faults");  // edges 1 and 2 touch edge 1 of the outline
  EXPECT_EQ(reported({{{0.5, 0.5}, {1, 0.5}, {3, 1}, {1, 1}}}), "2 faults");  // edges 1 and 2 cross it
  EXPECT_EQ(reported({{{0.5, 0.5}, {1, 0.5}, {0.5, 1}, {1, 1}}}),
            "piece.p.holes[0] is no simple outline: edge 1 crosses edge 3 at [0.75, 0.75] m");
  EXPECT_EQ(reported({{{0.5, 0.5}, {1, 0.5}}}), "piece.p.holes[0] has 2 points; allowed: at least 3");
}

// The bucketed search finds what comparing all pairs finds.
TEST(Outline, CrossingsAreThoseOfAllPairs) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> u(0, 1);
  int simple = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    scene::PieceSpec piece;
    piece.cell = 0.01;
    const int n = 3 + int(random() % 5);
    for (int k = 0; k < n; ++k) piece.outline.push_back({u(random), u(random)});
    bool crosses = false;
    const auto side = [&](int a, int b, int c) {
      const Vec2 p = piece.outline[std::size_t(a % n)], q = piece.outline[std::size_t(b % n)],
                 r = piece.outline[std::size_t(c % n)];
      return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0;
    };
    for (int a = 0; a < n; ++a)
      for (int b = a + 2; b < n; ++b)
        if ((b + 1) % n != a && side(a, a + 1, b) != side(a, a + 1, b + 1) &&
            side(b, b + 1, a) != side(b, b + 1, a + 1))
          crosses = true;
    ASSERT_EQ(!faults_of(piece).empty(), crosses) << "trial " << trial;
    simple += !crosses;
  }
  EXPECT_GT(simple, 300);
}

TEST(Outline, TensOfThousandsOfSegments) {
  scene::PieceSpec piece;
  piece.cell = 0.01;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double f = 2 * kPi * k / n, r = k % 2 ? 1 : 0.25;
    piece.outline.push_back({r * std::cos(f), r * std::sin(f)});
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(faults_of(piece).empty());
  std::mt19937_64 random(3);
  std::shuffle(piece.outline.begin(), piece.outline.end(), random);
  EXPECT_EQ(faults_of(piece).size(), 10u);
  std::printf("20,000 points, a star and shuffled: %.3f s\n",
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace
}  // namespace drape::piece
