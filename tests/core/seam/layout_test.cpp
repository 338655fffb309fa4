// Seam layout: counts, ends and spacings (core/README.md, section 6; case m of the model).
#include "seam/layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/test_cloth.h"

namespace drape::seam {
namespace {

using reference::rectangle;
using reference::threads;

// Two pieces whose edge 0 is sewn: straight, or with a curve.
Scene two_pieces(const scene::PieceSpec& a, const scene::PieceSpec& b) {
  Scene scene = rectangle(threads(100), 0.1, 0.1, 0.01);
  scene.pieces = {a, b};
  scene::SeamSpec seam;
  seam.name = "join";
  for (int k = 0; k < 2; ++k) seam.side[k] = {k, {0}, false};
  scene.seams = {seam};
  return scene;
}

scene::PieceSpec square(double side, double cell) {
  scene::PieceSpec piece = rectangle(threads(100), side, side, cell).pieces[0];
  return piece;
}

scene::PieceSpec half_circle(double diameter, double cell) {
  scene::PieceSpec piece = square(diameter, cell);
  piece.curves = {{0, {}, diameter / 2, false, true}};
  return piece;
}

scene::PieceSpec s_curve(double length, double cell) {
  scene::PieceSpec piece = square(length, cell);
  piece.curves = {{0, {{length / 3, length / 3}, {2 * length / 3, -length / 3}}, 0, false, true}};
  return piece;
}

scene::PieceSpec quarter(double radius, double cell) {
  scene::PieceSpec piece;
  piece.name = "quarter";
  piece.fabric = 0;
  piece.cell = cell;
  piece.outline = {{radius, 0}, {0, radius}, {0, 0}};
  piece.curves = {{0, {}, radius, false, true}};
  return piece;
}

double arc(const std::vector<Vec2>& line, Vec2 from, Vec2 to) {  // along the line between two of its points
  double sum = 0;
  bool on = false;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const auto within = [&](Vec2 p) {
      const Vec2 a = line[k], b = line[k + 1];
      const double l = std::hypot(b[0] - a[0], b[1] - a[1]);
      return std::hypot(p[0] - a[0], p[1] - a[1]) + std::hypot(b[0] - p[0], b[1] - p[1]) <=
             l * (1 + 1e-12) + 1e-15;
    };
    Vec2 begin = line[k], end = line[k + 1];
    if (!on && within(from)) begin = from, on = true;
    if (!on) continue;
    const bool last = within(to);
    if (last) end = to;
    sum += std::hypot(end[0] - begin[0], end[1] - begin[1]);
    if (last) return sum;
  }
  return sum;
}

TEST(SeamLayout, GivesBothSidesAsManyParticlesAndBothEnds) {
  const std::vector<std::pair<scene::PieceSpec, scene::PieceSpec>> cases = {
      {square(0.1, 0.01), square(0.1, 0.014)},       {square(0.1, 0.01), square(0.13, 0.01)},
      {half_circle(0.1, 0.01), square(0.157, 0.02)}, {quarter(0.1, 0.007), half_circle(0.08, 0.01)},
      {s_curve(0.1, 0.003), square(0.09, 0.0031)},   {square(0.01, 0.01), square(0.011, 0.05)},
  };
  for (const auto& [a, b] : cases) {
    const Scene scene = two_pieces(a, b);
    const SeamLayout layout = seam_layout(scene, scene.seams[0]);
    const double longest = std::max(layout.length[0], layout.length[1]), cell = std::min(a.cell, b.cell);
    const std::size_t n = layout.point[0].size() - 1;
    EXPECT_EQ(layout.point[1].size(), n + 1);
    EXPECT_GE(double(n) * cell, longest * (1 - 1e-9));  // no coarser than the finer grid
    EXPECT_LT((double(n) - 1) * cell, longest);
    for (int k = 0; k < 2; ++k) {
      const scene::PieceSpec& piece = scene.pieces[std::size_t(k)];
      const std::vector<Vec2> line = seam_line(piece, scene.seams[0].side[k]);
      EXPECT_EQ(layout.point[k].front(), piece.outline[0]);
      EXPECT_EQ(layout.point[k].back(), piece.outline[1]);
      EXPECT_NEAR(layout.spacing[k] * double(n), layout.length[k], 1e-12 * layout.length[k]);
      double sum = 0;
      for (std::size_t p = 0; p < n; ++p) {
        const double step = arc(line, layout.point[k][p], layout.point[k][p + 1]);
        EXPECT_NEAR(step, layout.spacing[k], 1e-12 * layout.length[k]);
        sum += step;
      }
      EXPECT_NEAR(sum, layout.length[k], 1e-12 * layout.length[k]);
    }
  }
}

// pi r/2 of a quarter circle, to the sagitta of its chords: 8/3 s^2/c^2 relative with c^2 = 8 r s, s =
// b/1000.
TEST(SeamLayout, MeasuresAlongTheCurve) {
  const Scene scene = two_pieces(quarter(0.1, 0.01), square(0.1, 0.01));
  const SeamLayout layout = seam_layout(scene, scene.seams[0]);
  const double exact = std::numbers::pi / 2 * 0.1;
  EXPECT_NEAR(layout.length[0], exact, 1e-5 / 0.1 * exact);
}

TEST(SeamLayout, RunsOverSeveralEdgesEitherWay) {
  Scene scene = two_pieces(square(0.1, 0.01), square(0.1, 0.01));
  scene::SeamSide& side = scene.seams[0].side[0];
  side.edges = {0, 3};  // in the outline's order: 3, then 0
  std::vector<Vec2> line = seam_line(scene.pieces[0], side);
  EXPECT_EQ(line, (std::vector<Vec2>{{0, 0.1}, {0, 0}, {0.1, 0}}));
  side.reverse = true;
  line = seam_line(scene.pieces[0], side);
  EXPECT_EQ(line, (std::vector<Vec2>{{0.1, 0}, {0, 0}, {0, 0.1}}));
  side.edges = {0, 2};
  EXPECT_TRUE(seam_chain(scene.pieces[0], side).empty());
}

// Whole outlines: the last particle would coincide with the first.
TEST(SeamLayout, ClosesOnItself) {
  Scene scene = two_pieces(square(0.1, 0.01), square(0.1, 0.01));
  for (scene::SeamSide& side : scene.seams[0].side) side.edges = {1, 2, 3, 0};
  const SeamLayout layout = seam_layout(scene, scene.seams[0]);
  EXPECT_EQ(layout.point[0].size(), 40u);
  EXPECT_EQ(layout.point[0][0], (Vec2{0.1, 0}));
}

// The direction across the outline to the cloth, whichever way the outline and the seam run.
TEST(SeamLayout, KnowsTheInside) {
  for (bool clockwise : {false, true})
    for (bool reverse : {false, true}) {
      Scene scene = two_pieces(square(0.1, 0.01), square(0.1, 0.01));
      if (clockwise) scene.pieces[0].outline = {{0.1, 0}, {0, 0}, {0, 0.1}, {0.1, 0.1}};
      scene.seams[0].side[0].reverse = reverse;
      const SeamLayout layout = seam_layout(scene, scene.seams[0]);
      for (const Vec2& v : layout.inward[0]) EXPECT_NEAR(v[1], 1, 1e-15);
    }
}

// The points of a flat half disc are in the opposite order to its outline with the arc.
TEST(SeamLayout, KnowsTheInsideOfCurves) {
  for (double bow : {5e-4, -5e-4}) {
    scene::PieceSpec piece = square(0.1, 0.01);
    piece.outline = {{0, 0}, {0.05, bow}, {0.1, 0}};
    piece.curves = {{2, {}, 0.05, false, true}};
    Scene scene = two_pieces(piece, square(0.1, 0.01));
    scene.seams[0].side[0].edges = {0, 1};
    const SeamLayout layout = seam_layout(scene, scene.seams[0]);
    for (const Vec2& v : layout.inward[0]) EXPECT_GT(v[1], 0.99);
  }
}

}  // namespace
}  // namespace drape::seam
