// Pieces in space: core/README.md, section 1.
#include "piece/place.h"

#include <numbers>

#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

double dot(Vec3 a, Vec3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 minus(Vec3 a, Vec3 b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// The upright plane y = 2 rolled about the z axis: P' has the distance R from the axis and the same height.
// Arcs have the lengths of the lines. The middle line, above the axis along the normal, keeps its direction.
TEST(Place, CylinderKeepsHeightsAndLengths) {
  for (const double side : {2.0, -2.0, 0.0}) {  // in front of the axis, behind it, through it
    scene::PlaceSpec place;
    place.origin = {0, side, 1};
    place.axis_y = {0, 0, 1};  // axis_x x axis_y = -y
    place.radius = {0.5, 0.5};
    for (const double x : {-1.0, -0.3, 0.0, 0.7})
      for (const double y : {0.0, 0.4}) {
        const Vec3 p = place_point(place, {x, y});
        EXPECT_NEAR(p[2], 1 + y, 1e-15);
        EXPECT_NEAR(std::hypot(p[0], p[1]), 0.5, 1e-15);
        const double normal = side > 0 ? 1 : -1;  // along y: from the axis to the plane, or axis_x x axis_y
        // f = d.t/R, t = e x n = -+x
        const double f = -normal * x / 0.5;
        EXPECT_NEAR(p[1], normal * 0.5 * std::cos(f), 1e-15);
        EXPECT_NEAR(p[0], -normal * 0.5 * std::sin(f), 1e-15);
        const double d = 1e-5;
        const Vec3 q = minus(place_point(place, {x + d, y + d}), p);
        EXPECT_NEAR(std::sqrt(dot(q, q)), d * std::numbers::sqrt2, 1e-14);
      }
  }
}

// The ellipse x = a sin f, y = b cos f: P' lies on it, at the arc length of the plane's point. Simpson's
// rule (n = 2000 intervals of f: (f/n)^4/180 of the fourth derivative of s', below 1e-10 for a ratio of 3).
TEST(Place, EllipseKeepsArcLengths) {
  for (const Vec2 radius : {Vec2{0.2, 0.12}, {0.1, 0.3}, {0.3, 0.3}})
    for (const double side : {2.0, -2.0}) {
      scene::PlaceSpec place;
      place.origin = {0, side, 1};
      place.axis_y = {0, 0, 1};
      place.radius = radius;
      const auto [a, b] = radius;
      for (int k = -40; k <= 40; ++k) {
        const double x = 0.05 * k;  // up to three times round
        const Vec3 p = place_point(place, {x, 0.4});
        const double out = side > 0 ? 1 : -1;
        EXPECT_NEAR(p[2], 1.4, 1e-15);
        EXPECT_NEAR(p[0] * p[0] / (a * a) + p[1] * p[1] / (b * b), 1, 1e-14);
        // The angle of the position, in the turn in which x lies.
        double f = std::atan2(p[0] / a, out * p[1] / b), s = 0;
        const auto arc = [&](double to) {
          double sum = 0;
          const int n = 2000;
          for (int i = 0; i <= n; ++i)
            sum += (i == 0 || i == n ? 1
                    : i % 2          ? 4
                                     : 2) *
                   std::hypot(a * std::cos(to * i / n), b * std::sin(to * i / n));
          return sum * to / (3 * n);
        };
        const double turn = 2 * std::numbers::pi, perimeter = arc(turn);
        s = arc(f) + std::round((x - arc(f)) / perimeter) * perimeter;
        EXPECT_NEAR(s, x, 1e-10) << "a " << a << " b " << b << " side " << side;
      }
    }
}

// A chord of the arc length h has the length h (1 - (k h)^2/24 + ...), with k the curvature, on an ellipse
// at most max(a, b)/min(a, b)^2: placed cloth starts strained by less than that.
TEST(Place, EllipseStrainsByTheChordOnly) {
  scene::PlaceSpec place;
  place.origin = {0, 2, 0};
  place.axis_y = {0, 0, 1};
  for (const Vec2 radius : {Vec2{0.2, 0.12}, {0.1, 0.3}}) {
    place.radius = radius;
    const double h = 0.01, k = std::max(radius[0], radius[1]) / std::pow(std::min(radius[0], radius[1]), 2);
    for (int i = -100; i < 100; ++i) {
      const Vec3 d = minus(place_point(place, {h * (i + 1), 0}), place_point(place, {h * i, 0}));
      const double strain = std::sqrt(dot(d, d)) / h - 1;
      EXPECT_LE(strain, 1e-12);
      EXPECT_GE(strain, -1.01 * k * k * h * h / 24);
    }
  }
}

// The imperfection is along the normal of the ellipse: (x/a^2, y/b^2).
TEST(Place, ImperfectionOfAnEllipseIsNormal) {
  scene::PieceSpec piece = rectangle(0, 0, 1, 1, 0.1);
  piece.place.origin = {0, 2, 0};
  piece.place.axis_y = {0, 0, 1};
  piece.place.radius = {0.5, 0.2};
  Scene scene = scene_of(piece);
  scene.imperfection_amplitude = 0.01;
  for (const Vec2 p : {Vec2{0.1, 0.9}, {0.6, 0.2}, {0.9, 0.9}}) {
    const Vec3 foot = place_point(piece.place, p), off = minus(place_start(scene, 0, p), foot);
    EXPECT_NEAR(off[0] * foot[1] / 0.04 - off[1] * foot[0] / 0.25, 0, 1e-15);
    EXPECT_EQ(off[2], 0);
    EXPECT_GT(std::abs(off[0]) + std::abs(off[1]), 0);
  }
}

// Steele, Lea, Flood: splitmix64 from state 0 gives e220a8397b1dcdaf, 6e789e6aa1b965f4, ...
TEST(Place, ImperfectionIsTheSumOfItsWaves) {
  scene::PieceSpec piece = rectangle(-1, 2, 3, 4, 0.1);  // diagonal 5
  piece.place.origin = {0, 0, 1};
  Scene scene = scene_of(piece);
  scene.imperfection_amplitude = 0.01;
  std::uint64_t state = 0;
  const auto uniform = [&] {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return double((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
  };
  const double first = uniform();
  EXPECT_EQ(first, double(0xe220a8397b1dcdafULL >> 11) / 9007199254740992.0);
  state = 0;
  const double turn = 2 * std::numbers::pi;
  double a[8], b[8];
  for (int k = 0; k < 8; ++k) a[k] = turn * uniform(), b[k] = turn * uniform();
  for (const Vec2 p : {Vec2{-1, 2}, {0.3, 2.7}, {2, 6}}) {
    double h = 0;
    for (int k = 1; k <= 8; ++k)
      h += 0.01 / 8 *
           std::sin(turn * ((p[0] + 1) * std::cos(a[k - 1]) + (p[1] - 2) * std::sin(a[k - 1])) /
                        (5 * std::pow(2, -k / 2.0)) +
                    b[k - 1]);
    const Vec3 at = place_start(scene, 0, p);
    EXPECT_EQ(at[0], p[0]);
    EXPECT_EQ(at[1], p[1]);
    EXPECT_NEAR(at[2], 1 + h, 1e-15);
    EXPECT_LE(std::abs(h), 0.01);
    EXPECT_NE(h, 0);
  }
  // Another seed and another piece have other waves: the state of piece 1 is seed + 1000003.
  const Vec3 here = place_start(scene, 0, {0.5, 3});
  scene.pieces.push_back(scene.pieces[0]);
  const Vec3 other = place_start(scene, 1, {0.5, 3});
  EXPECT_NE(here[2], other[2]);
  scene.imperfection_seed = 1000003;
  EXPECT_EQ(place_start(scene, 0, {0.5, 3})[2], other[2]);
}

// On a cylinder the imperfection is radial.
TEST(Place, ImperfectionOfACylinderIsRadial) {
  scene::PieceSpec piece = rectangle(0, 0, 1, 1, 0.1);
  piece.place.origin = {0, 2, 0};
  piece.place.axis_y = {0, 0, 1};
  piece.place.radius = {0.5, 0.5};
  Scene scene = scene_of(piece);
  scene.imperfection_amplitude = 0.01;
  Scene plane = scene;
  plane.pieces[0].place = {};
  for (const Vec2 p : {Vec2{0.1, 0.9}, {0.6, 0.2}}) {
    const Vec3 at = place_start(scene, 0, p), round = place_point(piece.place, p);
    const double h = place_start(plane, 0, p)[2];
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(at[k], round[k] * (1 + h / 0.5), 1e-15);
    EXPECT_EQ(at[2], round[2]);
  }
}

}  // namespace
}  // namespace drape::piece
