// A scene without faults is read in SI units, and omitted keys take their defaults.
#include "validation/load.h"

#include <gtest/gtest.h>

#include "scene_file.h"

namespace drape::scene {

using namespace tests;
namespace {

Scene scene_of(const SceneFolder& folder, const std::string& scene, const std::string& fabric = kFabric) {
  folder.write("wool.toml", fabric);
  std::vector<Problem> problems;
  const Scene read = validation::scene_load(folder.write("scene.toml", scene), problems);
  for (const Problem& p : problems) ADD_FAILURE() << problem_text(p);
  return read;
}

TEST(SceneRead, EveryKeyIsRead) {
  const SceneFolder folder;
  const Scene s = scene_of(folder, kScene);
  EXPECT_EQ(s.name, "sheet_2");
  EXPECT_EQ(s.duration, 2);
  EXPECT_EQ(s.gravity, (Vec3{0, 0.5, -9.81}));
  EXPECT_EQ(s.integrator, Integrator::kPaper);
  EXPECT_EQ(s.step, 1e-5);
  EXPECT_EQ(s.communication, 0.002);
  EXPECT_EQ(s.damping, 0.25);
  EXPECT_TRUE(s.energy);
  EXPECT_EQ(s.scaling, Scaling::kPaperArea);
  EXPECT_EQ(s.bias_model, BiasModel::kTension);
  EXPECT_FALSE(s.clamp_correction);

  ASSERT_EQ(s.pieces.size(), 1u);
  const PieceSpec& piece = s.pieces[0];
  EXPECT_EQ(piece.name, "sheet");
  EXPECT_EQ(piece.fabric, 0);
  EXPECT_EQ(piece.cell, 0.01);
  EXPECT_EQ(piece.outline, (std::vector<Vec2>{{0, 0}, {0.4, 0}, {0.4, 0.6}, {0, 0.6}}));
  EXPECT_EQ(piece.velocity, (Vec3{0, 0, 1}));
  EXPECT_EQ(piece.place.origin, (Vec3{0, 0, 1}));
  EXPECT_EQ(piece.place.axis_x, (Vec3{1, 0, 0}));
  EXPECT_EQ(piece.place.axis_y, (Vec3{0, 0, 1}));

  ASSERT_EQ(s.pins.size(), 2u);
  EXPECT_EQ(s.pins[0].name, "bar");
  EXPECT_EQ(s.pins[0].piece, 0);
  EXPECT_EQ(s.pins[0].edges, std::vector<int>{2});
  EXPECT_TRUE(s.pins[0].at.empty());
  EXPECT_EQ(s.pins[1].at, (std::vector<Vec2>{{0.1, 0.1}, {0.2, 0.1}}));
  ASSERT_EQ(s.probes.size(), 1u);
  EXPECT_EQ(s.probes[0].name, "hem");
  EXPECT_EQ(s.probes[0].piece, 0);
  EXPECT_EQ(s.probes[0].at, (Vec2{0.2, 0}));
}

TEST(SceneRead, WhatTheSceneSaysOfItself) {
  const SceneFolder folder;
  std::string text = kScene;
  text.insert(text.find("duration"),
              "description = \"A sheet\"\nauthor = \"Ada\"\nversion = \"3\"\ncopyright = \"(c)\"\nlicense = "
              "\"CC0\"\n");
  const About about = scene_of(folder, text).about;
  EXPECT_EQ(about.description, "A sheet");
  EXPECT_EQ(about.author, "Ada");
  EXPECT_EQ(about.version, "3");
  EXPECT_EQ(about.copyright, "(c)");
  EXPECT_EQ(about.license, "CC0");
  EXPECT_EQ(scene_of(folder, kScene).about.author, "");
}

TEST(SceneRead, EveryKeyOfAClothIsRead) {
  const SceneFolder folder;
  const Scene s = scene_of(folder, kCloth);
  EXPECT_EQ(s.mode, Mode::kFit);
  EXPECT_EQ(s.wind, (Vec3{1.5, 0, -2}));
  EXPECT_EQ(s.imperfection_amplitude, 0.001);
  EXPECT_EQ(s.imperfection_seed, 7);
  EXPECT_TRUE(s.has_air);
  EXPECT_EQ(s.air_density, 1.3);
  EXPECT_EQ(s.air_normal, 1.1);
  EXPECT_EQ(s.air_tangential, 0.02);
  EXPECT_EQ(s.outline, OutlineModel::kPaper);
  EXPECT_EQ(s.fabrics[0].friction, (Vec2{0.4, 0.25}));
  EXPECT_EQ(s.fabrics[0].damping, 0.001);

  const PieceSpec& piece = s.pieces[0];
  ASSERT_EQ(piece.curves.size(), 3u);
  EXPECT_EQ(piece.curves[0].edge, 0);
  EXPECT_EQ(piece.curves[0].bezier, (std::vector<Vec2>{{0.1, -0.05}, {0.3, 0.05}}));
  EXPECT_EQ(piece.curves[1].edge, 1);
  EXPECT_EQ(piece.curves[1].radius, 0.5);
  EXPECT_TRUE(piece.curves[1].bezier.empty());
  EXPECT_FALSE(piece.curves[1].large);
  EXPECT_TRUE(piece.curves[1].right);
  EXPECT_EQ(piece.curves[2].edge, 4);
  EXPECT_EQ(piece.holes,
            (std::vector<std::vector<Vec2>>{{{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2}},
                                            {{0.25, 0.25}, {0.3, 0.25}, {0.3, 0.3}, {0.25, 0.3}}}));
  EXPECT_EQ(piece.grain, 0.3);
  EXPECT_EQ(piece.grid_origin, (Vec2{0.01, -0.02}));
  EXPECT_EQ(piece.place.radius, (Vec2{0.3, 0.3}));
  EXPECT_EQ(piece.place.axis_point, (Vec3{0.2, 0, 0}));
  EXPECT_EQ(piece.place.axis, (Vec3{0, 0, 1}));

  ASSERT_EQ(s.pins.size(), 3u);
  EXPECT_TRUE(s.pins[0].clamp);
  EXPECT_EQ(s.pins[0].drive, Drive::kVelocity);
  EXPECT_FALSE(s.pins[1].clamp);
  EXPECT_EQ(s.pins[1].drive, Drive::kBoth);
  EXPECT_EQ(s.pins[1].region, (std::vector<Vec2>{{0.25, 0.05}, {0.35, 0.05}, {0.35, 0.15}, {0.25, 0.15}}));
  EXPECT_EQ(s.pins[2].drive, Drive::kPosition);
}

TEST(SceneRead, FabricFileAndItsOverridesAreReadInSiUnits) {
  const SceneFolder folder;
  const Scene s = scene_of(folder, kScene);
  ASSERT_EQ(s.fabrics.size(), 1u);
  const FabricSpec& f = s.fabrics[0];
  EXPECT_EQ(f.name, "wool");
  EXPECT_EQ(f.areal_density, 0.2);  // the scene's own, not the file's 0.15
  EXPECT_EQ(f.thickness, 0.0005);
  EXPECT_EQ(f.strip_width, 0.05);
  EXPECT_EQ(f.strip_gauge, 0.1);
  EXPECT_EQ(f.compression, 0.5);
  EXPECT_EQ(f.compression_blend, 0.004);
  EXPECT_EQ(f.poisson, 0.3);
  // 1 uN cm^2 = 1e-6 N (1e-2 m)^2 = 1e-10 N m^2, over a width of 0.03 m; three roundings
  EXPECT_NEAR(f.bending_warp, 1370 * 1e-10 / 0.03, 1e-15 * f.bending_warp);
  EXPECT_NEAR(f.bending_weft, 900 * 1e-10 / 0.03, 1e-15 * f.bending_weft);
  EXPECT_EQ(f.warp.elongation, (std::vector<double>{0, 0.01, 0.025}));
  EXPECT_EQ(f.warp.force, (std::vector<double>{0, 3, 9}));  // one key of an inner table: the scene's
  EXPECT_EQ(f.warp.correction, (std::vector<double>{1, 0.9, 0.95}));
  EXPECT_EQ(f.weft.elongation, (std::vector<double>{0, 0.04}));
  EXPECT_TRUE(f.weft.correction.empty());
  EXPECT_EQ(f.bias.force, (std::vector<double>{0, 0.5, 2}));
}

TEST(SceneRead, WhatIsLeftOutTakesItsDefault) {
  const SceneFolder folder;
  const Scene s = scene_of(folder, R"(
[scene]
name = "a"
step = "auto"
[fabric.f]
areal_density = 1
thickness = 1e-3
[[piece]]
name = "p"
fabric = "f"
cell = 1
outline = [[0, 0], [0, 2], [-1, 2], [-1, 0]]
)");
  EXPECT_EQ(s.duration, 1);
  EXPECT_EQ(s.gravity, (Vec3{0, 0, -9.81}));
  EXPECT_EQ(s.integrator, Integrator::kLeapfrog);
  EXPECT_EQ(s.step, 0);
  EXPECT_EQ(s.communication, 1e-3);
  EXPECT_EQ(s.damping, 0);
  EXPECT_FALSE(s.energy);
  EXPECT_EQ(s.scaling, Scaling::kWidth);
  EXPECT_EQ(s.bias_model, BiasModel::kOdd);
  EXPECT_TRUE(s.clamp_correction);
  const FabricSpec& f = s.fabrics[0];
  EXPECT_EQ(f.strip_width, 0.05);
  EXPECT_EQ(f.strip_gauge, 0.2);
  EXPECT_TRUE(f.warp.force.empty() && f.weft.force.empty() && f.bias.force.empty());
  EXPECT_EQ(f.bending_warp, 0);
  EXPECT_EQ(f.bending_weft, 0);
  EXPECT_EQ(f.poisson, 0);
  EXPECT_EQ(f.compression, 1);
  EXPECT_EQ(f.compression_blend, 0.002);
  EXPECT_EQ(f.friction, (Vec2{0.3, 0.3}));
  EXPECT_EQ(f.damping, 0);
  EXPECT_EQ(s.mode, Mode::kDynamic);
  EXPECT_EQ(s.outline, OutlineModel::kCutCell);
  EXPECT_EQ(s.wind, (Vec3{0, 0, 0}));
  EXPECT_FALSE(s.has_air);
  EXPECT_EQ(s.air_density, 1.2);
  EXPECT_EQ(s.imperfection_amplitude, 0);
  EXPECT_TRUE(s.pieces[0].curves.empty() && s.pieces[0].holes.empty());
  EXPECT_EQ(s.pieces[0].grain, 0);
  EXPECT_FALSE(s.pieces[0].grid_origin);
  EXPECT_EQ(s.pieces[0].place.radius, (Vec2{0, 0}));
  EXPECT_EQ(s.pieces[0].velocity, (Vec3{0, 0, 0}));
  EXPECT_EQ(s.pieces[0].place.axis_y, (Vec3{0, 1, 0}));
}

// Axes given to seven digits become orthonormal to rounding; exact ones are unchanged.
TEST(SceneRead, AxesAreMadeOrthonormal) {
  const SceneFolder folder;
  std::string text = kScene;
  const std::string exact = "axis_x = [1, 0, 0], axis_y = [0, 0, 1]";
  text.replace(text.find(exact), exact.size(),
               "axis_x = [0.7071068, 0.7071068, 0], axis_y = [-0.4082483, 0.4082483, 0.8164966]");
  const PlaceSpec place = scene_of(folder, text).pieces[0].place;
  const auto dot = [](const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  constexpr double kRounding =
      4 * 2.3e-16;  // three products and their sum, once more through the square root
  EXPECT_NEAR(dot(place.axis_x, place.axis_x), 1, kRounding);
  EXPECT_NEAR(dot(place.axis_y, place.axis_y), 1, kRounding);
  EXPECT_NEAR(dot(place.axis_x, place.axis_y), 0, kRounding);
  EXPECT_NEAR(place.axis_x[0], 0.7071068, 1e-6);
  EXPECT_NEAR(place.axis_y[2], 0.8164966, 1e-6);
}

// Keys without effect are allowed: one number for both frictions, empty curves and holes, an air with only a
// density, the values of keys that allow only one.
TEST(SceneRead, WhatStatesNothing) {
  const SceneFolder folder;
  std::string text = kScene;
  const auto put = [&](const std::string& before, const std::string& more) {
    text.insert(text.find(before), more);
  };
  put("duration", "order = 2\nself_contact = false\nmode = \"dynamic\"\nwind = [0, 0, 0]\n");
  put("[options]", "[air]\ndensity = 1\n");
  put("areal_density", "friction = 0.2\n");
  put("outline", "curves = []\nholes = []\ngrain = 0\n");
  const Scene s = scene_of(folder, text);
  EXPECT_FALSE(s.has_air);
  EXPECT_EQ(s.air_density, 1);
  EXPECT_EQ(s.fabrics[0].friction, (Vec2{0.2, 0.2}));
  EXPECT_TRUE(s.pieces[0].curves.empty() && s.pieces[0].holes.empty());
}

// A cylinder's axis given to seven digits becomes parallel to the plane to rounding.
TEST(SceneRead, CylinderAxisIsMadeParallelToThePlane) {
  const SceneFolder folder;
  std::string text = kCloth;
  const std::string exact = "axis = [0, 0, 1]";
  text.replace(text.find(exact), exact.size(), "axis = [0.6, 0.0000003, 0.8000001]");
  const PlaceSpec place = scene_of(folder, text).pieces[0].place;
  constexpr double kRounding = 4 * 2.3e-16;
  EXPECT_NEAR(place.axis[1], 0, kRounding);  // the plane is that of x and z
  EXPECT_NEAR(std::hypot(place.axis[0], place.axis[1], place.axis[2]), 1, kRounding);
  EXPECT_NEAR(place.axis[0], 0.6, 1e-6);
}

// The lengths of the raw lists and their last points are those of the source. The smooth diagrams end where
// they do.
TEST(SceneRead, MeasuredWool) {
  const FabricFile wool = fabric_read(DRAPE_SOURCE_DIR "/examples/fabrics/wool.toml", Corrections::kKept);
  ASSERT_TRUE(wool.loaded);
  EXPECT_EQ(wool.fabric.areal_density, 0.15);
  const DiagramSpec &warp = wool.raw[0], &weft = wool.raw[1], &bias = wool.raw[2];
  ASSERT_EQ(warp.force.size(), 29u);
  ASSERT_EQ(weft.force.size(), 29u);
  ASSERT_EQ(bias.force.size(), 15u);
  const DiagramSpec* smooth[] = {&wool.fabric.warp, &wool.fabric.weft, &wool.fabric.bias};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(smooth[k]->force.size(), wool.raw[k].force.size());
    EXPECT_NEAR(smooth[k]->elongation.back(), wool.raw[k].elongation.back(), 1e-7);  // six digits of percent
  }
  // 0.05 m times the measured 2998.027613 and 1052.158273 N/m, entered to 1e-5 N
  EXPECT_NEAR(warp.force.back(), 0.05 * 2998.027613, 1e-5);
  EXPECT_NEAR(weft.force.back(), 0.05 * 1052.158273, 1e-5);
  // F = 0.05 m tau 2 l/cos g, l = sqrt(1 + sin g), with tau = 59.986 N/m at g = 0.14
  const double l = std::sqrt(1 + std::sin(0.14));
  EXPECT_NEAR(bias.elongation.back(), l - 1, 1e-7);
  EXPECT_NEAR(bias.force.back(), 0.05 * 59.986 * 2 * l / std::cos(0.14), 1e-5);
}

}  // namespace
}  // namespace drape::scene
