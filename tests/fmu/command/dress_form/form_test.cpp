// `drape form`: the dress form.
#include "command/dress_form/form.h"

#include <cmath>
#include <map>
#include <numbers>

#include "command/command_fixture.h"
#include "command/dress_form/spline.h"

namespace drape::command {
namespace {

const Measures kBodies[] = {{0.88, 0.68, 0.94, 1.66}, {0.76, 0.56, 0.82, 1.55}, {1.22, 1.06, 1.32, 1.72},
                            {0.7, 0.5, 0.7, 1.4},     {1.5, 1.4, 1.6, 2.0},     {1.1, 0.6, 1.0, 1.8}};

// The points (x, z) where the plane y = height cuts the mesh.
std::vector<Vec2> slice(const Mesh& mesh, double height) {
  std::vector<Vec2> cut;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[std::size_t(t[k])], &b = mesh.vertices[std::size_t(t[(k + 1) % 3])];
      if ((a[1] - height) * (b[1] - height) > 0 || a[1] == b[1]) continue;
      const double s = (height - a[1]) / (b[1] - a[1]);
      cut.push_back({a[0] + s * (b[0] - a[0]), a[2] + s * (b[2] - a[2])});
    }
  return cut;
}

// A closed surface of one piece without handles, counter-clockwise seen from outside. Every side of a
// triangle belongs to one other triangle, in the opposite direction; V - E + F = 2; the volume, sum a.(b x
// c)/6, is positive.
TEST(Form, IsClosed) {
  for (const Measures& measures : kBodies) {
    const Mesh mesh = form_make(measures);
    EXPECT_GE(mesh.triangles.size(), 5000u);
    EXPECT_LE(mesh.triangles.size(), 8000u);
    std::map<std::pair<int, int>, int> sides;
    double volume = 0;
    for (const auto& t : mesh.triangles) {
      Vec3 p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides[{t[k], t[(k + 1) % 3]}];
        p[k] = mesh.vertices[std::size_t(t[k])];
      }
      const Vec3 c{p[1][1] * p[2][2] - p[1][2] * p[2][1], p[1][2] * p[2][0] - p[1][0] * p[2][2],
                   p[1][0] * p[2][1] - p[1][1] * p[2][0]};
      volume += (p[0][0] * c[0] + p[0][1] * c[1] + p[0][2] * c[2]) / 6;
    }
    for (const auto& [side, count] : sides) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(sides.count({side.second, side.first}), 1u);
    }
    EXPECT_EQ(int(mesh.vertices.size()) - int(sides.size()) / 2 + int(mesh.triangles.size()), 2);
    // About that of a cylinder of its height with the mean of the three girths.
    const double girth = (measures.bust + measures.waist + measures.hips) / 3, tall = 0.46 * measures.height;
    EXPECT_GT(volume, 0.5 * tall * girth * girth / (4 * std::numbers::pi));
    EXPECT_LT(volume, 1.2 * tall * girth * girth / (4 * std::numbers::pi));
  }
}

// No triangle is a needle: the height on its longest side is above 0.2 mm.
TEST(Form, HasNoNeedles) {
  for (const Measures& measures : kBodies) {
    const Mesh mesh = form_make(measures);
    for (const auto& t : mesh.triangles) {
      double side[3], longest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = mesh.vertices[std::size_t(t[k])], &b = mesh.vertices[std::size_t(t[(k + 1) % 3])];
        side[k] = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        longest = std::max(longest, side[k]);
      }
      const double s = (side[0] + side[1] + side[2]) / 2;
      const double area = std::sqrt(std::max(0.0, s * (s - side[0]) * (s - side[1]) * (s - side[2])));
      ASSERT_GT(2 * area / longest, 2e-4);
    }
  }
}

// A tape round the sections of the mesh measures the requested girths, to the digits of the file.
TEST(Form, HasTheGirths) {
  for (const Measures& m : kBodies) {
    const Mesh mesh = form_make(m);
    EXPECT_NEAR(tape_length(slice(mesh, kBustHeight * m.height)), m.bust, 1e-6);
    EXPECT_NEAR(tape_length(slice(mesh, kWaistHeight * m.height)), m.waist, 1e-6);
    EXPECT_NEAR(tape_length(slice(mesh, kHipsHeight * m.height)), m.hips, 1e-6);
  }
}

// The default form is narrowest at the waist, from hips to bust. Near the bust no girth exceeds the bust by
// a centimetre.
TEST(Form, IsNarrowestAtTheWaist) {
  const Measures m;
  const Mesh mesh = form_make(m);
  double smallest = 10, at = 0;
  for (double y = kHipsHeight * m.height; y <= kBustHeight * m.height; y += 0.005)
    if (const double girth = tape_length(slice(mesh, y)); girth < smallest) smallest = girth, at = y;
  EXPECT_NEAR(at, kWaistHeight * m.height, 0.02);
  EXPECT_GT(smallest, 0.99 * m.waist);
  for (double y = kBustHeight * m.height - 0.05; y <= kBustHeight * m.height + 0.05; y += 0.005)
    EXPECT_LT(tape_length(slice(mesh, y)), m.bust + 0.01);
}

// Two points on each side of the tape's corners; points inside do not lengthen it.
TEST(Form, TapeIsTheConvexHull) {
  EXPECT_NEAR(tape_length({{0, 0}, {1, 0}, {0.5, 0.2}, {1, 1}, {0, 1}, {0.5, 0}, {0, 0}}), 4, 1e-15);
  EXPECT_NEAR(tape_length({{0, 0}, {3, 4}, {1.5, 2}}), 10, 1e-15);
}

// (0, 0), (1, 1), (2, 0): 4 M_1 = 6 (-1 - 1), so M_1 = -3 and y(1/2) = 1/2 + (1/8 - 1/2) (-3)/6 = 11/16.
TEST(Form, SplineIsNatural) {
  const std::vector<double> t{0, 1, 2}, y{0, 1, 0}, second = spline_fit(t, y);
  EXPECT_EQ(second, (std::vector<double>{0, -3, 0}));
  EXPECT_EQ(spline_at(t, y, second, 0, 0.5), 11 / 16.0);
  EXPECT_EQ(spline_at(t, y, second, 1, 1.5), 11 / 16.0);
  // A line stays a line, whatever the spacing.
  const std::vector<double> s{0, 0.3, 1, 4, 4.5}, line{1, 1.6, 3, 9, 10}, none = spline_fit(s, line);
  for (double m : none) EXPECT_NEAR(m, 0, 1e-14);
}

TEST_F(Command, FormWritesAnObj) {
  Done done = drape("form -o body.obj --bust 0.92 --waist 0.72 --hips 0.98 --height 1.70");
  ASSERT_EQ(done.code, 0) << done.text;
  std::size_t vertices = 0, faces = 0;
  for (const std::string& line : lines_of("body.obj")) vertices += line[0] == 'v', faces += line[0] == 'f';
  const Mesh mesh = form_make({0.92, 0.72, 0.98, 1.70});
  EXPECT_EQ(vertices, mesh.vertices.size());
  EXPECT_EQ(faces, mesh.triangles.size());
}

TEST_F(Command, FormRefusesMeasuresOutOfRange) {
  const Done done = drape("form -o body.obj --bust 92 --waist nan --hips -1 --height 170");
  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(done.text,
            "error: --bust = 92 m; allowed: 0.7 to 1.5 m\nerror: --waist = nan m; allowed: 0.5 to 1.4 m\n"
            "error: --hips = -1 m; allowed: 0.7 to 1.6 m\nerror: --height = 170 m; allowed: 1.4 to 2 m\n");
  EXPECT_FALSE(fs::exists(folder / "body.obj"));
  expect_refused("form -o none/body.obj", {"cannot write none/body.obj: No such file or directory"});
  expect_refused("form", {"--output is required"});
}

}  // namespace
}  // namespace drape::command
