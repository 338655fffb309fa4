// The fabrics shipped with Drape, and the worked example and the table of their page.
#include <gtest/gtest.h>

#include <cstdio>
#include <iterator>

#include "fabric/material_law.h"
#include "scene_file.h"

namespace drape::fabric {

using namespace tests;
namespace {

const std::filesystem::path kFolder = DRAPE_SOURCE_DIR "/examples/fabrics";

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  return names;
}

// Expects that a small scene with this file reads without fault and that the fabric has laws. Returns the
// fabric.
scene::FabricSpec expect_fabric(const std::filesystem::path& file) {
  const SceneFolder folder;
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load(folder.write("scene.toml", R"(
[scene]
name = "a"
[fabric.f]
file = ")" + file.string() + R"("
[[piece]]
name = "p"
fabric = "f"
cell = 0.1
outline = [[0, 0], [1, 0], [1, 1], [0, 1]]
)"),
                                             problems);
  const scene::FabricSpec fabric = scene.fabrics.empty() ? scene::FabricSpec{} : scene.fabrics[0];
  if (problems.empty()) {
    const Law law = law_make(fabric, {}, 0.1, "fabric.f", problems);
    EXPECT_TRUE(law.warp.segments && law.weft.segments && law.bias.segments && law.bending_warp > 0) << file;
  }
  for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
  return fabric;
}

std::string printed(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string slope_at_zero(const scene::FabricSpec& f, const scene::DiagramSpec& d) {  // N/m
  return printed("%.0f", d.force[1] / d.elongation[1] / f.strip_width);
}

std::string end_of(const scene::DiagramSpec& d) {
  return printed("%.3g", d.force.back()) + " at " + printed("%.3g", 100 * d.elongation.back());
}

// A row of the page's table, from the areal density on.
std::string row_of(const scene::FabricSpec& f) {
  constexpr double kMicroNcm2 = 1e10;  // uN cm2 per N m2
  constexpr double kWidth = 0.03;      // of all bending specimens here
  const auto rigidity = [](double b) { return printed("%.0f", b * kWidth * kMicroNcm2); };
  const auto three = [](const std::string& warp, const std::string& weft, const std::string& bias) {
    return warp + ", " + weft + ", " + bias + " | ";
  };
  return " | " + printed("%.3g", f.areal_density) + " | " +
         three(slope_at_zero(f, f.warp), slope_at_zero(f, f.weft), slope_at_zero(f, f.bias)) +
         three(end_of(f.warp), end_of(f.weft), end_of(f.bias)) + rigidity(f.bending_warp) + ", " +
         rigidity(f.bending_weft) + " |";
}

class ShippedFabric : public testing::TestWithParam<std::string> {};

TEST_P(ShippedFabric, IsReadAndHasLaws) { expect_fabric(kFolder / (GetParam() + ".toml")); }

// A law that follows the noise of a load cell costs time steps. `drape check` warns of a slope path above 2.
TEST_P(ShippedFabric, IsSmooth) {
  std::vector<Problem> problems;
  const Law law = law_make(expect_fabric(kFolder / (GetParam() + ".toml")), {}, 0.1, "fabric.f", problems);
  for (const math::Curve* curve : {&law.warp, &law.weft, &law.bias}) {
    EXPECT_GE(math::curve_slope_path(*curve), 1);
    EXPECT_LT(math::curve_slope_path(*curve), 2);
  }
}

// The description states first whether a figure was measured.
TEST_P(ShippedFabric, StatesMeasuredOrIllustrativeFirst) {
  const std::string text = text_of(kFolder / (GetParam() + ".toml"));
  const auto begins = [&](const char* word) {
    return text.find("\ndescription = \"\"\"\n" + std::string(word) + ": ") != std::string::npos;
  };
  EXPECT_TRUE(begins("Measured") || begins("Illustrative"));
}

TEST_P(ShippedFabric, HasItsRowOnThePage) {
  const std::string page = text_of(kFolder / "README.md"), file = GetParam() + ".toml";
  const std::size_t begin = page.find("\n| `" + file + "` |");
  ASSERT_NE(begin, std::string::npos) << "no row for " << file;
  const std::string row = page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1);
  const std::string figures = row_of(expect_fabric(kFolder / file));
  EXPECT_NE(row.find(figures), std::string::npos) << "the page has\n"
                                                  << row << "\nthe file gives\n"
                                                  << figures;
}

INSTANTIATE_TEST_SUITE_P(Fabrics, ShippedFabric, testing::ValuesIn(shipped()),
                         [](const auto& fabric) { return fabric.param; });

TEST(FabricsPage, WorkedExampleIsAFabric) {
  const std::string page = text_of(kFolder / "README.md"), fence = "```toml\n";
  const std::size_t begin = page.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t from = begin + fence.size();
  const SceneFolder folder;
  const std::string block = page.substr(from, page.find("```", from) - from);
  const scene::FabricSpec f = expect_fabric(folder.write("shirting.toml", block));
  EXPECT_EQ(f.areal_density, 0.132);
  // EI = 42046 m/A over 30 mm, as computed on the page from the sheet; given to 10 uN cm2
  const double half_digit = 5e-10 / 0.03;
  EXPECT_NEAR(f.bending_warp, 42046e-10 * 3.17 / 49.4 / 0.03, half_digit);
  EXPECT_NEAR(f.bending_weft, 42046e-10 * 3.15 / 81.2 / 0.03, half_digit);
}

// The page's sheets are read as printed.
TEST(FabricsPage, SheetsAreFabrics) {
  const std::string page = text_of(kFolder / "README.md");
  for (const char* sheet : {"```\n[kes]", "```\n[fast]"}) {
    const std::size_t begin = page.find(sheet);
    ASSERT_NE(begin, std::string::npos) << sheet;
    const SceneFolder folder;
    expect_fabric(
        folder.write("sheet.toml", page.substr(begin + 4, page.find("```", begin + 4) - begin - 4)));
  }
}

}  // namespace
}  // namespace drape::fabric
