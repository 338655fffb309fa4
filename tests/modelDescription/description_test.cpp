// The variable table and the texts printed from it.
#include "description.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <vector>

#include "guid.h"
#include "units.h"

namespace drape::description {
namespace {

const std::string kScene = DRAPE_SAMPLES "/swatch.toml", kFlag = DRAPE_SAMPLES "/flag.toml";

using Cloth = std::unique_ptr<drape_cloth, void (*)(drape_cloth*)>;
Cloth open_swatch() { return {drape_open(kScene.c_str(), nullptr, nullptr), drape_close}; }

std::vector<std::string> lines_of(std::istream&& text) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// Compares line by line, so that a difference is reported as one line.
void expect_sample(const std::string& scene) {
  const Cloth cloth(drape_open(scene.c_str(), nullptr, nullptr), drape_close);
  ASSERT_TRUE(cloth);
  const std::string sample_file = scene.substr(0, scene.rfind('.')) + ".xml";
  SCOPED_TRACE("if the change is meant: drape variables " + scene + " --xml > " + sample_file);
  const auto printed =
      lines_of(std::istringstream(description_xml_fmi2(description_of(cloth.get(), Nodes::kNone))));
  const auto sample = lines_of(std::ifstream(sample_file));
  ASSERT_EQ(printed.size(), sample.size());
  for (std::size_t n = 0; n < sample.size(); ++n) ASSERT_EQ(printed[n], sample[n]) << "in line " << n + 1;
}

TEST(Description, XmlIsTheCommittedSample) { expect_sample(kScene); }
TEST(Description, XmlOfADrivenClothIsTheCommittedSample) { expect_sample(kFlag); }

// The inputs that `drive` selects, with orientations for clamps. They start at the present pose: the middle
// of the pole, the point.
TEST(Description, InputsStartWhereTheClothIs) {
  const Cloth cloth(drape_open(kFlag.c_str(), nullptr, nullptr), drape_close);
  ASSERT_TRUE(cloth);
  const std::vector<Variable> table = variables_of(cloth.get(), Nodes::kNone);
  std::vector<std::string> inputs;
  std::vector<double> start;
  for (const Variable& v : table) {
    EXPECT_EQ(v.causality == Causality::kInput, v.rate != nullptr) << v.name();
    if (!v.rate) continue;
    EXPECT_EQ(*v.rate, 0);
    inputs.push_back(v.name());
    start.push_back(*v.value);
  }
  const std::vector<std::pair<std::string, std::vector<double>>> expected{
      {"wind", {1, 0, 0.5}},
      {"pin.pole.position", {0, 0, 1.02}},
      {"pin.pole.orientation", {1, 0, 0, 0}},
      {"pin.pole.velocity", {0, 0, 0}},
      {"pin.pole.angular_velocity", {0, 0, 0}},
      {"pin.hand.position", {0.06, 0, 1}}};
  std::size_t k = 0;
  for (const auto& [name, values] : expected)
    for (std::size_t i = 0; i < values.size(); ++i, ++k) {
      ASSERT_LT(k, inputs.size());
      EXPECT_EQ(inputs[k], name + "[" + std::to_string(i + 1) + "]");
      EXPECT_NEAR(start[k], values[i], 1e-15) << inputs[k];
    }
  EXPECT_EQ(k, inputs.size());
}

// A saved copy of a scene is the same cloth, so it has the same guid.
TEST(Description, GuidDependsOnTheSceneAndNothingElse) {
  const Cloth cloth = open_swatch(), again = open_swatch();
  ASSERT_TRUE(cloth && again);
  const std::string text = drape_scene_text(cloth.get());
  const std::string guid = guid_of(text, Nodes::kNone);
  EXPECT_EQ(guid, guid_of(drape_scene_text(again.get()), Nodes::kNone));
  EXPECT_NE(guid, guid_of(text + " ", Nodes::kNone));
  EXPECT_NE(guid, guid_of(text, Nodes::kAll));
  const std::string copy = testing::TempDir() + "drape_guid_copy.toml";
  std::ofstream(copy) << text;
  const Cloth copied(drape_open(copy.c_str(), nullptr, nullptr), drape_close);
  ASSERT_TRUE(copied);
  EXPECT_EQ(guid, guid_of(drape_scene_text(copied.get()), Nodes::kNone));
}

TEST(Description, RowsAreCompleteAndUnique) {
  const Cloth cloth = open_swatch();
  ASSERT_TRUE(cloth);
  std::set<std::string> names;
  for (const Variable& v : variables_of(cloth.get(), Nodes::kAll)) {
    EXPECT_TRUE(names.insert(v.name()).second) << v.name();
    EXPECT_FALSE(v.description.empty()) << v.name();
    ASSERT_NE(v.value, nullptr) << v.name();
    EXPECT_TRUE(std::isfinite(*v.value)) << v.name();
    const bool unit_known = std::any_of(std::begin(kUnits), std::end(kUnits),
                                        [&](const Unit& u) { return std::string(u.name) == v.unit; });
    EXPECT_TRUE(unit_known) << v.name() << " in " << v.unit;
    EXPECT_EQ(range_problem(v, *v.value), "");
  }
}

// The swatch has 6 by 9 particles; 4 by 7 of them have all their neighbours.
TEST(Description, NodeVariablesAreThoseAskedFor) {
  const Cloth cloth = open_swatch();
  ASSERT_TRUE(cloth);
  const std::size_t none = variables_of(cloth.get(), Nodes::kNone).size();
  const std::vector<Variable> outline = variables_of(cloth.get(), Nodes::kOutline);
  EXPECT_EQ(variables_of(cloth.get(), Nodes::kAll).size(), none + 6 * 9 * 6);
  EXPECT_EQ(outline.size(), none + 6 * (6 * 9 - 4 * 7));
  EXPECT_NE(variable_find(outline, "node.position[1,1]"), nullptr);
  EXPECT_NE(variable_find(outline, "node.velocity[54,3]"), nullptr);
  EXPECT_EQ(variable_find(outline, "node.position[8,1]"), nullptr);  // second node of the second row
}

// At rest on its place, particle (i, j) of the swatch is at (i b, j b, 1) with b = 0.01 m.
TEST(Description, NodeVariablesPointAtTheirParticle) {
  const Cloth cloth = open_swatch();
  ASSERT_TRUE(cloth);
  const std::vector<Variable> table = variables_of(cloth.get(), Nodes::kAll);
  drape_get_outputs(cloth.get(), DRAPE_OUT_ALL);
  for (int n = 0; n < 6 * 9; ++n) {
    const int i = n % 6, j = n / 6;
    const auto at = [&](int k) {
      return *variable_find(table, "node.position[" + std::to_string(n + 1) + "," + std::to_string(k) + "]")
                  ->value;
    };
    EXPECT_NEAR(at(1), 0.01 * i, 1e-15);
    EXPECT_NEAR(at(2), 0.01 * j, 1e-15);
    EXPECT_EQ(at(3), 1);
  }
}

TEST(Description, FamiliesAndRangesAsText) {
  const Cloth cloth = open_swatch();
  ASSERT_TRUE(cloth);
  const std::string text = description_markdown(description_of(cloth.get(), Nodes::kAll));
  for (const char* part :
       {"`fabric.wool.areal_density`", "`fabric.wool.warp.force[1..3]`",
        "at 1 % elongation ... at 5 % elongation", "`gravity[1..3]`", "`node.position[1..54,1..3]`",
        "| 1e-04 to 100 |", "| 0 to 0.999 |", "| -10000 to 10000 |"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in:\n" << text;
  EXPECT_EQ(variable_nearest(variables_of(cloth.get(), Nodes::kNone), "tension.mx"), "tension.max");
  EXPECT_EQ(variable_nearest(variables_of(cloth.get(), Nodes::kNone), "colour"), "");
}

}  // namespace
}  // namespace drape::description
