// Figures as laboratory sheets state them land as the cloth that they describe; bad ones are told in their
// own keys and units.
#include <gtest/gtest.h>

#include <cmath>

#include "fault_case.h"
#include "standards/cantilever.h"

namespace drape::scene {

using namespace tests;
namespace {

const std::string kOwn = "[fabric.wool]\n";  // the scene's own keys follow

std::string scene_with(const std::string& own) {
  return "[scene]\nname = \"a\"\n" + kOwn + "file = \"wool.toml\"\n" + own +
         "[[piece]]\nname = \"p\"\nfabric = \"wool\"\ncell = 0.1\noutline = [[0, 0], [1, 0], [1, 1], [0, "
         "1]]\n";
}

FabricSpec fabric_of(const std::string& text, const std::string& own = "") {
  const SceneFolder folder;
  folder.write("wool.toml", text);
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load(folder.write("scene.toml", scene_with(own)), problems);
  for (const Problem& p : problems) ADD_FAILURE() << problem_text(p);
  return scene.fabrics.empty() ? FabricSpec{} : scene.fabrics[0];
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-15 + 1e-14 * std::abs(b[i])) << i;
}

TEST(DatasheetConversion, KesIsConverted) {
  const FabricSpec f = fabric_of(kKes);
  EXPECT_NEAR(f.areal_density, 0.245, 1e-16);
  EXPECT_NEAR(f.thickness, 0.00062, 1e-18);
  // 500 gf/cm = 490.3325 N/m on the strip of 50 mm
  EXPECT_NEAR(f.warp.force.back(), 490.3325 * 0.05, 1e-13);
  EXPECT_NEAR(f.warp.elongation.back(), 0.05735, 1e-17);
  EXPECT_NEAR(f.weft.elongation.back(), 0.05135, 1e-17);
  EXPECT_LT(f.warp.force[5], f.warp.force[10] / 2);  // LT < 1: it stiffens
  EXPECT_NEAR(f.bending_warp, 0.09 * 9.80665e-5, 1e-19);
  EXPECT_NEAR(f.bending_weft, 0.07 * 9.80665e-5, 1e-19);
  // G, the mean of both: F/width = 4 G e for small e, and holds no jaws
  EXPECT_FALSE(f.bias.jaws);
  EXPECT_NEAR(f.bias.force[1] / (0.05 * 4 * 0.55 * 56.188 * 0.01), 1, 0.03);
  EXPECT_TRUE(f.warp.jaws);
}

TEST(DatasheetConversion, FastIsConverted) {
  const FabricSpec f = fabric_of(kFast);
  EXPECT_NEAR(f.areal_density, 0.168, 1e-16);
  EXPECT_NEAR(f.thickness, 0.00052, 1e-18);
  expect_near(f.warp.elongation, {0, 0.0067, 0.0187, 0.046});
  expect_near(f.weft.force, {0, 4.903325 * 0.05, 19.6133 * 0.05, 98.0665 * 0.05});
  EXPECT_NEAR(f.bending_warp, 5.56e-6, 0.005e-6);  // the sheet's own B
  EXPECT_NEAR(f.bending_weft, 5.02e-6, 0.005e-6);
  EXPECT_NEAR(f.bias.force[1] / (0.05 * 4 * (123 / 4.7) * 0.01), 1, 0.03);
}

// A strip by the name of its standard; forces on the width that it has.
TEST(DatasheetConversion, StripsByName) {
  const auto strip = [](const std::string& name) {
    const FabricSpec f = fabric_of(kFast + "", "strip = \"" + name + "\"\n");
    return std::vector<double>{f.strip_width, f.strip_gauge, f.warp.force[1] / 4.903325};
  };
  expect_near(strip("GOST 3813"), {0.05, 0.2, 0.05});
  expect_near(strip("GOST 3813 wool"), {0.05, 0.1, 0.05});
  expect_near(strip("ISO 13934-1"), {0.05, 0.2, 0.05});
  expect_near(strip("ISO 13934-1 100 mm"), {0.05, 0.1, 0.05});
  expect_near(strip("ASTM D5035 1R"), {0.025, 0.075, 0.025});
  expect_near(strip("ASTM D5035 2C"), {0.05, 0.075, 0.05});
}

// 1 lbf = 4.4482216 N, 1 kgf = 9.80665 N; 1.5 mm on 75 mm is 2 %, 0.1 in is 2.54 mm.
TEST(DatasheetConversion, OtherUnitsOfDiagrams) {
  const FabricSpec f = fabric_of(kStrips);
  EXPECT_EQ(f.strip_gauge, 0.075);
  expect_near(f.warp.elongation, {0, 0.02, 0.04});
  expect_near(f.warp.force, {0, 2 * 4.4482216152605, 5 * 4.4482216152605});
  expect_near(f.warp.correction, {1, 0.9, 0.95});
  expect_near(f.weft.elongation, {0, 0.00254 / 0.075});
  expect_near(f.weft.force, {0, 9.80665});
  expect_near(f.bias.force, {0, 0.00980665 * 25});
  EXPECT_FALSE(f.bias.jaws);
}

TEST(DatasheetConversion, Bending) {
  const auto warp = [](const std::string& bending) {
    return fabric_of("areal_density = 0.132\nthickness = 1e-3\nbending = { " + bending + " }\n").bending_warp;
  };
  const double c = 0.132 * 9.80665 * 0.019 * 0.019 * 0.019;
  EXPECT_NEAR(warp("length_mm = 19"), c, 1e-14 * c);
  EXPECT_NEAR(warp("overhang_mm = [38, 30]"), c, 1e-14 * c);
  const double pt2 =
      warp("gost_10550 = { mass_g = [3.17, 3.15], deflection_mm = [63.5, 65.1] }, poisson = 0.2");
  EXPECT_NEAR(pt2, standards::gost_10550_rigidity(3.17e-3, 0.0635) / 0.03, 1e-14 * pt2);
  EXPECT_NEAR(pt2, 2700e-10 / 0.03, 10e-10 / 0.03);  // the worked example of examples/fabrics
}

// What the scene says goes before what the fabric's file says, by whatever key.
TEST(DatasheetConversion, SceneOverridesTheFile) {
  const FabricSpec f = fabric_of(kKes,
                                 "areal_density = 0.3\nbending = { rigidity_uN_cm2 = [2000, 1500] }\n"
                                 "warp = { elongation_percent = [0, 1], force = [0, 8] }\n");
  EXPECT_EQ(f.areal_density, 0.3);
  EXPECT_NEAR(f.bending_warp, 2000e-10 / 0.03, 1e-20);
  EXPECT_EQ(f.warp.elongation.size(), 2u);
  EXPECT_EQ(f.weft.elongation.size(), 11u);
  const FabricSpec g = fabric_of(kFabric, "kes = { W = 20, G = 1, B = 0.1 }\n");
  EXPECT_NEAR(g.areal_density, 0.2, 1e-16);
  EXPECT_NEAR(g.bending_weft, 9.80665e-6, 1e-20);
  EXPECT_EQ(g.bias.force.size(), 11u);
  EXPECT_TRUE(g.bias.correction.empty());
  EXPECT_EQ(g.warp.force.back(), 7);
}

// One figure of a strip over a standard's leaves the other.
TEST(DatasheetConversion, PartOfAStripOverridesItsName) {
  const FabricSpec f = fabric_of("areal_density = 0.2\nthickness = 1e-3\nstrip = \"ASTM D5035 2R\"\n",
                                 "strip = { width = 0.025 }\n");
  EXPECT_EQ(f.strip_width, 0.025);
  EXPECT_EQ(f.strip_gauge, 0.075);
}

}  // namespace
}  // namespace drape::scene
