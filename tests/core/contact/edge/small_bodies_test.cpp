// Bodies smaller than a cell, and faces narrower than one: nothing goes through the cloth, laid or thrown.
#include <gtest/gtest.h>

#include <random>

#include "contact/particle/contact.h"
#include "crossings_fixture.h"

namespace drape::contact {

using namespace tests;
namespace {

using namespace math::vector3;

Mesh turned(Mesh m, const Vec3& by) {
  const double angle = norm(by);
  if (angle == 0) return m;
  const Vec3 e = (1 / angle) * by;
  for (Vec3& p : m.point)
    p = std::cos(angle) * p + std::sin(angle) * cross(e, p) + ((1 - std::cos(angle)) * dot(e, p)) * e;
  return m;
}

// The convex hull of points on an ellipsoid. Every triangle with all others on one side is one of its faces.
Mesh polyhedron(int points, const Vec3& radius, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Mesh m;
  for (int k = 0; k < points; ++k) {
    const Vec3 u = unit({normal(random), normal(random), normal(random)});
    m.point.push_back({radius[0] * u[0], radius[1] * u[1], radius[2] * u[2]});
  }
  for (int a = 0; a < points; ++a)
    for (int b = 0; b < points; ++b)
      for (int c = 0; c < points; ++c) {
        if (!(a < b && a < c && b != c)) continue;
        const Vec3 &p = m.point[std::size_t(a)],
                   n = cross(m.point[std::size_t(b)] - p, m.point[std::size_t(c)] - p);
        bool face = true;
        for (int d = 0; d < points && face; ++d)
          face = d == a || d == b || d == c || dot(n, m.point[std::size_t(d)] - p) < 0;
        if (face) m.corner.push_back({a, b, c});
      }
  return m;
}

Vec3 top_of(const Mesh& m) {
  return *std::max_element(m.point.begin(), m.point.end(),
                           [](const Vec3& p, const Vec3& q) { return p[2] < q[2]; });
}

// A square of 4 cells a side, `thickness` over a body, thrown down at `speed` (m/s).
struct Throw {
  const char* what;
  Mesh body;
  double cell, speed;
  Vec2 shift;             // cells
  bool over_top = false;  // else over x = y = 0
};

// The most crossings of the cloth and the body at any time.
int worst_crossings(const Throw& t) {
  constexpr int kLooks = 20;
  const SceneFolder folder;
  const scene::FabricSpec fabric = linen();
  Scene scene = reference::rectangle(fabric, 4 * t.cell, 4 * t.cell, t.cell);
  const Vec3 top = t.over_top ? top_of(t.body) : Vec3{0, 0, top_of(t.body)[2]};
  scene.pieces[0].place.origin =
      top + Vec3{(-2 + t.shift[0]) * t.cell, (-2 + t.shift[1]) * t.cell, fabric.thickness};
  scene.pieces[0].velocity = {0, 0, -t.speed};
  scene.damping = 5;
  body_add(scene, folder, "body", t.body);
  Assembled a = assemble(scene);
  int worst = 0;
  bool touched = false;
  const double time = t.speed > 0 ? std::min(0.02, 6 * t.cell / t.speed) : 0.02;
  for (int k = 0; k < kLooks; ++k) {
    advance(a, time / kLooks);
    worst = std::max(worst, crossings(a, t.body));
    touched = touched || any_near(a.state);
  }
  EXPECT_TRUE(touched) << t.what;
  return worst;
}

void expect_none(const Throw& t) {
  EXPECT_EQ(worst_crossings(t), 0) << t.what << ", cell " << t.cell << " m, " << t.speed
                                   << " m/s, shifted by " << t.shift[0] << " cells";
}

TEST(SmallBodies, NarrowBarsGoThroughNoCloth) {
  for (const double width : {0.0005, 0.002, 0.006, 0.009})
    for (const double cell : {0.005, 0.01, 0.025})
      for (const double speed : {0.0, 0.5, 10.0, 50.0})
        for (const double shift : {0.0, 0.29})
          for (const double turn : {0.0, 0.4})
            expect_none(
                {"bar", turned(box(width, 8 * cell, width), {0, 0, turn}), cell, speed, {shift, 0.1}});
}

TEST(SmallBodies, RodsGoThroughNoCloth) {
  for (const int sides : {3, 12, 72, 300})
    for (const double cell : {0.01, 0.025})
      for (const double speed : {0.0, 0.5, 50.0})
        for (const double shift : {0.0, 0.37})
          expect_none(
              {"rod", turned(cylinder(0.0015, 8 * cell, sides), {0, 0, shift}), cell, speed, {shift, 0.1}});
}

// A needle is a pyramid of 4 mm and 86 degrees. Thrown at 20 m/s, cloth wraps round a plate of 0.2 mm until
// its cells are crumpled, and one may be cut.
TEST(SmallBodies, ThinPlatesAndNeedlesGoThroughNoCloth) {
  Mesh needle = pyramid(1.5);
  for (Vec3& p : needle.point) p = 0.02 * p;
  int cut = 0;
  for (const double cell : {0.005, 0.01, 0.025})
    for (const double speed : {0.0, 3.0, 20.0})
      for (const double shift : {0.0, 0.41})
        for (const Throw& t : {Throw{"plate on edge",
                                     turned(box(0.0002, 8 * cell, 4 * cell), {0, 0, shift}),
                                     cell,
                                     speed,
                                     {shift, 0.1}},
                               Throw{"flat plate",
                                     turned(box(3 * cell, 0.003, 0.0002), {0, 0, shift}),
                                     cell,
                                     speed,
                                     {shift, 0.1}},
                               Throw{"needle", needle, cell, speed, {shift, 0.23}}}) {
          if (speed < 5) expect_none(t);
          else cut += worst_crossings(t) > 0;
        }
  EXPECT_LE(cut, 1);
}

// Polyhedra of 1 mm to 1 m. Thrown at more than 5 m/s, cloth wraps round a small one until its cells are
// crumpled, and one in a hundred of them is cut.
TEST(SmallBodies, ConvexPolyhedraGoThroughNoCloth) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  int cut = 0;
  for (int k = 0; k < 100; ++k) {
    const double size = 0.001 * std::pow(500, share(random)), cell = 0.005 * std::pow(5, share(random));
    const Mesh body = polyhedron(
        4 + k % 8, {size, size * (0.4 + 0.6 * share(random)), size * (0.4 + 0.6 * share(random))}, random);
    const double speed = k % 3 == 0 ? 0 : 50 * share(random) * share(random);
    const Throw t{"polyhedron", body, cell, speed, {share(random), share(random)}, true};
    if (speed <= 5) expect_none(t);
    else cut += worst_crossings(t) > 0;
  }
  EXPECT_LE(cut, 2);
}

}  // namespace
}  // namespace drape::contact
