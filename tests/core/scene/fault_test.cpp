// Bad input: one edit of a good scene, and the exact messages it gives; all of them at once.
#include <gtest/gtest.h>

#include "scene_file.h"

namespace drape {
namespace {

using Messages = std::vector<std::string>;

struct Case {
  const char* name;
  std::string from, to;  // the edit; an empty `from` stands for the whole text
  Messages messages;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

std::string edited(std::string text, const Case& c) {
  if (c.from.empty()) return c.to;
  const std::size_t at = text.find(c.from);
  if (at == std::string::npos) throw std::logic_error("nothing to edit: " + c.from);
  return text.replace(at, c.from.size(), c.to);
}

std::string name_of(const testing::TestParamInfo<Case>& info) { return info.param.name; }

// ---- The scene file

class SceneFault : public testing::TestWithParam<Case> {};

TEST_P(SceneFault, Says) {
  const SceneFolder folder;
  folder.write("wool.toml", kFabric);
  const std::filesystem::path file = folder.write("scene.toml", edited(kScene, GetParam()));
  EXPECT_EQ(messages_of(folder, file), GetParam().messages);
}

const std::string kPieceHead = "[[piece]]\nname = \"sheet\"\n";
const std::string kOutline = "[[0, 0], [0.4, 0], [0.4, 0.6], [0, 0.6]]";
const std::string kRectangles =
    "this version takes rectangles along the threads: four corners, sides parallel to x and y";

const Case kKeys[] = {
    {"unknown_key",
     "damping = ",
     "dampnig = ",
     {"scene.toml:8: scene.dampnig is no known key; the nearest is \"damping\""}},
    {"unknown_table",
     "[options]",
     "[option]",
     {"scene.toml:10: option is no known key; the nearest is \"options\""}},
    {"unknown_key_in_fabric",
     "warp.force",
     "warp.fore",
     {"scene.toml:17: fabric.wool.warp.fore is no known key; the nearest is \"force\""}},
    {"key_of_the_contract",
     "damping = 0.25",
     "self_contact = true",
     {"scene.toml:8: scene.self_contact is not supported by this version"}},
    {"table_of_the_contract",
     "[options]",
     "[air]\ndensity = 1\n[options]",
     {"scene.toml:10: air is not supported by this version"}},
    {"pin_region",
     "edges = [2]",
     "region = []",
     {"scene.toml:28: pin.bar.region is not supported by this version"}},
    {"pin_clamp",
     "hold = \"point\"",
     "hold = \"clamp\"",
     {"scene.toml:29: pin.bar.hold = \"clamp\"; allowed: \"point\""}},
    {"missing_key",
     "cell = 0.01\n",
     "",
     {"scene.toml:18: piece.sheet.cell is missing; wanted: a number in m"}},
    {"missing_name",
     "name = \"hem\"\n",
     "",
     {"scene.toml:34: probe[0].name is missing; wanted: a name in quotes"}},
    {"missing_in_scene",
     "name = \"sheet_2\"\n",
     "",
     {"scene.toml:1: scene.name is missing; wanted: a name in quotes"}},
    {"missing_in_fabric",
     "warp.force = [0, 3, 9]",
     "bending = {}\n[fabric.silk]\nareal_density = 0.1\nwarp = {}",
     {"scene.toml:18: fabric.silk.thickness is missing; wanted: a number in m",
      "scene.toml:20: fabric.silk.warp.elongation_percent is missing; wanted: a list of numbers in %",
      "scene.toml:20: fabric.silk.warp.force is missing; wanted: a list of numbers in N"}},
    {"not_a_table",
     "warp.force = [0, 3, 9]",
     "strip = 0.05",
     {"scene.toml:17: fabric.wool.strip is a number; wanted: a table"}},
    {"no_list_of_tables",
     "[[probe]]",
     "[probe]",
     {"scene.toml:34: probe is a table; wanted: tables [[probe]]"}},
    {"no_table", "[options]", "[[options]]", {"scene.toml:10: options is a list; wanted: a table"}},
};

const Case kValues[] = {
    {"number_as_text",
     "duration = 2",
     "duration = \"2 s\"",
     {"scene.toml:3: scene.duration is a text; wanted: a number in s"}},
    {"flag_as_number",
     "energy = true",
     "energy = 1",
     {"scene.toml:9: scene.energy is a whole number; wanted: true or false"}},
    {"text_as_number",
     "name = \"sheet_2\"",
     "name = 2",
     {"scene.toml:2: scene.name is a whole number; wanted: a name in quotes"}},
    {"list_as_number",
     "gravity = [0, 0.5, -9.81]",
     "gravity = -9.81",
     {"scene.toml:4: scene.gravity is a number; wanted: a list of three numbers in m/s^2"}},
    {"short_list",
     "gravity = [0, 0.5, -9.81]",
     "gravity = [0, -9.81]",
     {"scene.toml:4: scene.gravity has 2 entries; wanted: a list of three numbers in m/s^2"}},
    {"entry_as_text",
     "gravity = [0, 0.5, -9.81]",
     "gravity = [0, \"a\", -1e9]",
     {"scene.toml:4: scene.gravity[1] is a text; wanted: a number in m/s^2",
      "scene.toml:4: scene.gravity[2] = -1e+09 m/s^2; allowed: from -10000 to 10000 m/s^2"}},
    {"date",
     "duration = 2",
     "duration = 2015-01-01",
     {"scene.toml:3: scene.duration is a date or time; wanted: a number in s"}},
    {"negative",
     "cell = 0.01",
     "cell = -0.01",
     {"scene.toml:21: piece.sheet.cell = -0.01 m; allowed: above 0, at most 10 m"}},
    {"zero",
     "duration = 2",
     "duration = 0",
     {"scene.toml:3: scene.duration = 0 s; allowed: above 0, at most 1e+07 s"}},
    {"too_large",
     "damping = 0.25",
     "damping = 1000001",
     {"scene.toml:8: scene.damping = 1.000001e+06 1/s; allowed: from 0 to 1e+06 1/s"}},
    {"not_a_number",
     "areal_density = 0.2",
     "areal_density = nan",
     {"scene.toml:16: fabric.wool.areal_density = nan kg/m^2; allowed: from 0.0001 to 100 kg/m^2"}},
    {"infinite",
     "step = 1e-5",
     "step = inf",
     {"scene.toml:6: scene.step = inf s; allowed: above 0, at most 1 s"}},
    {"step_as_text",
     "step = 1e-5",
     "step = \"fast\"",
     {"scene.toml:6: scene.step = \"fast\"; wanted: \"auto\" or a number in s"}},
    {"choice",
     "integrator = \"paper\"",
     "integrator = \"euler\"",
     {"scene.toml:5: scene.integrator = \"euler\"; allowed: \"leapfrog\", \"paper\""}},
    {"reference",
     "fabric = \"wool\"",
     "fabric = \"wol\"",
     {"scene.toml:20: piece.sheet.fabric = \"wol\" names no fabric; known: \"wool\""}},
    {"name_of_odd_letters",
     "name = \"hem\"",
     "name = \"the hem\"",
     {"scene.toml:35: probe[0].name = \"the hem\" is no name; wanted: a letter, then letters, digits or "
      "underscores, at most "
      "64 characters in all"}},
    {"fabric_of_odd_letters",
     "[[probe]]",
     "[fabric.\"2\\nx\"]\nareal_density = 1\nthickness = 0.001\n[[probe]]",
     {"scene.toml:34: fabric.2 x is no name; wanted: a letter, then letters, digits or underscores, at most "
      "64 characters "
      "in all"}},
    {"fabric_as_number",
     "[fabric.wool]\nfile",
     "[fabric]\nwool = 1\n[fabric.silk]\nfile",
     {"scene.toml:15: fabric.wool is a whole number; wanted: a table [fabric.wool]"}},
    {"name_twice",
     "name = \"tip\"",
     "name = \"bar\"",
     {"scene.toml:31: pin[1].name = \"bar\" is taken by another pin; names differ within a kind"}},
    {"empty_list",
     "edges = [2]",
     "edges = []",
     {"scene.toml:28: pin.bar.edges is an empty list; wanted: a list of whole numbers"}},
    {"fraction_for_whole",
     "edges = [2]",
     "edges = [2.0]",
     {"scene.toml:28: pin.bar.edges[0] is a number; wanted: a whole number"}},
    {"point_for_points",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "at = [0.1, 0.1]",
     {"scene.toml:33: pin.tip.at is a flat list; wanted: a list of points [[x, y], ...] in m"}},
    {"axis_alone",
     ", axis_y = [0, 0, 1]",
     "",
     {"scene.toml:24: piece.sheet.place has only one of axis_x and axis_y; wanted: both or neither"}},
    {"axis_too_long",
     "axis_x = [1, 0, 0]",
     "axis_x = [1.01, 0, 0]",
     {"scene.toml:24: piece.sheet.place.axis_x has length 1.01; wanted: 1, within 1e-06"}},
    {"axes_askew",
     "axis_y = [0, 0, 1]",
     "axis_y = [0.6, 0, 0.8]",
     {"scene.toml:24: piece.sheet.place has axis_x . axis_y = 0.6; wanted: 0, a right angle, within 1e-06"}},
};

const Case kGeometry[] = {
    {"five_corners",
     kOutline,
     "[[0, 0], [0.4, 0], [0.4, 0.6], [0.2, 0.7], [0, 0.6]]",
     {"scene.toml:22: piece.sheet.outline has 5 corners; " + kRectangles}},
    {"turned",
     kOutline,
     "[[0.2, 0], [0.4, 0.3], [0.2, 0.6], [0, 0.3]]",
     {"scene.toml:22: piece.sheet.outline is no rectangle along the threads; " + kRectangles}},
    {"slanted_by_more_than_rounding",
     kOutline,
     "[[0, 0], [0.4, 1e-9], [0.4, 0.6], [0, 0.6]]",
     {"scene.toml:22: piece.sheet.outline is no rectangle along the threads; " + kRectangles}},
    {"crossed",
     kOutline,
     "[[0, 0], [0.4, 0.6], [0.4, 0], [0, 0.6]]",
     {"scene.toml:22: piece.sheet.outline is no rectangle along the threads; " + kRectangles}},
    {"corner_twice",
     kOutline,
     "[[0, 0], [0.4, 0], [0.4, 0.6], [0.4, 0]]",
     {"scene.toml:22: piece.sheet.outline is no rectangle along the threads; " + kRectangles}},
    {"closed_by_hand",
     kOutline,
     "[[0, 0], [0.4, 0], [0.4, 0.6], [0, 0.6], [0, 0]]",
     {"scene.toml:22: piece.sheet.outline repeats its first point at the end; an outline closes by itself"}},
    {"no_area",
     kOutline,
     "[[0, 0], [0.4, 0], [0.4, 0], [0, 0]]",
     {"scene.toml:22: piece.sheet.outline encloses no area"}},
    {"cell_too_large",
     "cell = 0.01",
     "cell = 0.41",
     {"scene.toml:21: piece.sheet.cell = 0.41 m; allowed: at most the piece's shorter side, 0.4 m"}},
    {"too_many_nodes",
     "cell = 0.01",
     "cell = 1e-4",
     {"scene.toml:21: piece.sheet.cell = 0.0001 m makes about 2.401e+07 nodes; allowed: at most 4e+06 a "
      "piece"}},
    {"edge_out_of_range",
     "edges = [2]",
     "edges = [2, 4]",
     {"scene.toml:28: pin.bar.edges[1] = 4; allowed: 0 to 3 (edge i runs from point i of the outline to the "
      "next)"}},
    {"edge_before_the_first",
     "edges = [2]",
     "edges = [-1]",
     {"scene.toml:28: pin.bar.edges[0] = -1; allowed: 0 to 3 (edge i runs from point i of the outline to the "
      "next)"}},
    {"pin_off_the_piece",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "at = [[0.1, 0.1], [0.43, -0.04]]",
     {"scene.toml:33: pin.tip.at[1] = [0.43, -0.04] m lies 0.05 m off the piece \"sheet\""}},
    {"probe_off_the_piece",
     "at = [0.2, 0]",
     "at = [0.2, -1e-8]",
     {"scene.toml:37: probe.hem.at = [0.2, -1e-08] m lies 1e-08 m off the piece \"sheet\""}},
    {"pin_of_nothing", "edges = [2]\n", "", {"scene.toml:25: pin.bar holds nothing; wanted: at or edges"}},
    {"pin_of_both",
     "edges = [2]",
     "edges = [2]\nat = [[0, 0]]",
     {"scene.toml:25: pin.bar has more than one of at and edges; wanted: one of them"}},
    {"pins_clash_on_an_edge",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "at = [[0.1, 0.1], [0.123, 0.6]]",
     {"scene.toml:30: pin.tip and pin.bar both hold the point [0.123, 0.6] m of the piece \"sheet\"; a point "
      "belongs to one "
      "pin"}},
    {"pins_clash_in_a_corner",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "edges = [3]",
     {"scene.toml:30: pin.tip and pin.bar both hold the point [0, 0.6] m of the piece \"sheet\"; a point "
      "belongs to one pin"}},
};

INSTANTIATE_TEST_SUITE_P(Keys, SceneFault, testing::ValuesIn(kKeys), name_of);
INSTANTIATE_TEST_SUITE_P(Values, SceneFault, testing::ValuesIn(kValues), name_of);
INSTANTIATE_TEST_SUITE_P(Geometry, SceneFault, testing::ValuesIn(kGeometry), name_of);

// ---- The fabric file

class FabricFault : public testing::TestWithParam<Case> {};

TEST_P(FabricFault, Says) {
  const SceneFolder folder;
  folder.write("wool.toml", edited(kFabric, GetParam()));
  std::string scene = kScene;
  const std::string overrides = "areal_density = 0.2\nwarp.force = [0, 3, 9]\n",
                    loose = "clamp_correction = false";
  scene.erase(scene.find(overrides), overrides.size());
  scene.replace(scene.find(loose), loose.size(), "bias_model = \"odd\"");
  scene.erase(scene.find("bias_model = \"tension\"\n"), 23);
  EXPECT_EQ(messages_of(folder, folder.write("scene.toml", scene)), GetParam().messages);
}

const Case kFabrics[] = {
    {"unknown_key",
     "thickness",
     "thikness",
     {"scene.toml:13: fabric.wool.thickness is missing; wanted: a number in m",
      "wool.toml:4: fabric.wool.thikness is no known key; the nearest is \"thickness\""}},
    {"key_with_a_dot",
     "[warp]",
     "\"warp.force\" = 1\n[warp]",
     {"wool.toml:9: fabric.wool.\"warp.force\" is no known key; the nearest is \"warp\""}},
    {"negative_density",
     "areal_density = 0.15",
     "areal_density = -0.15",
     {"wool.toml:3: fabric.wool.areal_density = -0.15 kg/m^2; allowed: from 0.0001 to 100 kg/m^2"}},
    {"names_another_file",
     "source = \"nowhere\"",
     "file = \"more.toml\"",
     {"wool.toml:2: fabric.wool.file stands in a fabric file; a fabric file cannot name another one"}},
    {"empty", "", "", {"scene.toml:14: fabric.wool.file = \"wool.toml\": is empty (looked for wool.toml)"}},
    {"rigidity_of_one",
     "[1370, 900]",
     "[1370]",
     {"wool.toml:8: fabric.wool.bending.rigidity_uN_cm2 has 1 entry; wanted: a list of two numbers in uN "
      "cm^2"}},
    {"poisson_of_one",
     "poisson = 0.3",
     "poisson = 1.0",
     {"wool.toml:8: fabric.wool.bending.poisson = 1; allowed: from 0 to 0.999"}},
    {"force_falls",
     "[0, 2, 7]",
     "[0, 7, 2]",
     {"wool.toml:11: fabric.wool.warp.force[2] = 2 N after 7 N; the force of a diagram does not fall"}},
    {"force_starts_high",
     "[0, 2, 7]",
     "[1, 2, 7]",
     {"wool.toml:11: fabric.wool.warp.force[0] = 1 N; a diagram starts at 0 N"}},
    {"elongation_starts_high",
     "[0, 1, 2.5]",
     "[0.5, 1, 2.5]",
     {"wool.toml:10: fabric.wool.warp.elongation_percent[0] = 0.5 %; a diagram starts at 0 %"}},
    {"elongation_rests",
     "[0, 1, 2.5]",
     "[0, 1, 1]",
     {"wool.toml:10: fabric.wool.warp.elongation_percent[2] = 1 % after 1 %; wanted: a rise of at least "
      "1e-06 %"}},
    {"force_too_short",
     "[0, 2, 7]",
     "[0, 2]",
     {"wool.toml:11: fabric.wool.warp.force has 2 entries, elongation_percent has 3; wanted: as many"}},
    {"correction_too_long",
     "[1, 0.9, 0.95]",
     "[1, 0.9, 0.95, 1]",
     {"wool.toml:12: fabric.wool.warp.correction has 4 entries, elongation_percent has 3; wanted: as many"}},
    {"correction_lets_the_law_fall",
     "[1, 0.9, 0.95]",
     "[1, 0.9, 0.25]",
     {"wool.toml:12: fabric.wool.warp.correction[2] = 0.25 gives 1.75 N after 1.8 N; force x correction does "
      "not fall"}},
    {"correction_zero",
     "[1, 0.9, 0.95]",
     "[1, 0, 0.95]",
     {"wool.toml:12: fabric.wool.warp.correction[1] = 0; allowed: from 0.001 to 1000"}},
    {"one_point",
     "elongation_percent = [0, 4]\nforce = [0, 5]",
     "elongation_percent = [0]\nforce = [0]",
     {"wool.toml:14: fabric.wool.weft.elongation_percent has 1 entry; allowed: 2 to 64"}},
    {"strip_too_wide",
     "gauge = 0.1 ",
     "gauge = 0.0625 ",
     {"wool.toml:7: fabric.wool.strip has gauge/width = 1.25; the clamp correction of a bias diagram takes "
      "values above 1.25 "
      "(or set options.clamp_correction = false)"}},
    {"bias_beyond_locking",
     "[0, 3, 6]",
     "[0, 41.5, 50]",
     {"wool.toml:17: fabric.wool.bias.elongation_percent[1] = 41.5 %; bias_model \"odd\" takes at least one "
      "point above 0 % "
      "and below 41.42 %, where the threads of a strip lie along the pull"}},
};

INSTANTIATE_TEST_SUITE_P(Fabric, FabricFault, testing::ValuesIn(kFabrics), name_of);

// ---- Files

Messages scene_messages(const std::string& text) {
  const SceneFolder folder;
  return messages_of(folder, folder.write("scene.toml", text));
}

TEST(SceneFile, ThatIsNone) {
  const SceneFolder folder;
  EXPECT_EQ(messages_of(folder, folder.path / "none.toml"), Messages{"none.toml: there is no such file"});
  std::filesystem::create_directory(folder.path / "folder");
  EXPECT_EQ(messages_of(folder, folder.path / "folder"), Messages{"folder: is a folder, not a file"});
}

TEST(SceneFile, ThatHoldsNoScene) {
  EXPECT_EQ(scene_messages(""), Messages{"scene.toml: is empty"});
  EXPECT_EQ(scene_messages("# nothing\n"), Messages{"scene.toml: holds no keys"});
  EXPECT_EQ(scene_messages("[scene]\nname = \"a\"\n"),
            Messages{"scene.toml: piece is missing; wanted: at least one [[piece]]"});
  EXPECT_EQ(scene_messages("[options]\n"),
            (Messages{"scene.toml: scene.name is missing; wanted: a table [scene] with a name",
                      "scene.toml: piece is missing; wanted: at least one [[piece]]"}));
}

// What follows the place is the parser's own wording.
TEST(SceneFile, ThatIsNotToml) {
  const auto starts = [](const Messages& messages, const std::string& start) {
    return messages.size() == 1 && messages[0].compare(0, start.size(), start) == 0;
  };
  EXPECT_TRUE(starts(scene_messages("[scene\nname = \"a\"\n"), "scene.toml:1:7: is not valid TOML: "));
  EXPECT_TRUE(starts(scene_messages("[scene]\nname = = 1\n"), "scene.toml:2:8: is not valid TOML: "));
  EXPECT_TRUE(starts(scene_messages("[ = 1"), "scene.toml:1:3: is not valid TOML: "));
  EXPECT_TRUE(starts(scene_messages("a = 1\na = 2"), "scene.toml:2:"));
  EXPECT_TRUE(starts(scene_messages("a = \"\xff\""), "scene.toml:1:"));
  EXPECT_TRUE(starts(scene_messages("a = " + std::string(100000, '[')), "scene.toml:1:"));

  const SceneFolder folder;
  folder.write("wool.toml", "thickness = 1e-3\nareal_density 0.15\n");
  EXPECT_TRUE(
      starts(messages_of(folder, folder.write("scene.toml", kScene)), "wool.toml:2:15: is not valid TOML: "));
}

TEST(SceneFile, WhoseFabricFileIsNone) {
  const SceneFolder folder;
  const std::filesystem::path file = folder.write("scene.toml", kScene);
  EXPECT_EQ(
      messages_of(folder, file),
      Messages{
          "scene.toml:15: fabric.wool.file = \"wool.toml\": there is no such file (looked for wool.toml)"});
  std::filesystem::create_directory(folder.path / "wool.toml");
  EXPECT_EQ(
      messages_of(folder, file),
      Messages{
          "scene.toml:15: fabric.wool.file = \"wool.toml\": is a folder, not a file (looked for wool.toml)"});
}

TEST(SceneFile, ReportsAllFaultsAtOnceInTheOrderOfTheText) {
  const SceneFolder folder;
  folder.write("wool.toml", "areal_density = -1\nthicknes = 1e-3\n");
  const std::filesystem::path file = folder.write("scene.toml", R"([scene]
name = "1"
duration = -1
[fabric.wool]
file = "wool.toml"
[[piece]]
name = "a"
fabric = "silk"
cell = 0.2
outline = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]
[[pin]]
name = "p"
piece = "a"
at = [[1, 0]]
)");
  EXPECT_EQ(
      messages_of(folder, file),
      (Messages{"scene.toml:2: scene.name = \"1\" is no name; wanted: a letter, then letters, digits or "
                "underscores, at "
                "most 64 characters in all",
                "scene.toml:3: scene.duration = -1 s; allowed: above 0, at most 1e+07 s",
                "scene.toml:4: fabric.wool.thickness is missing; wanted: a number in m",
                "scene.toml:8: piece.a.fabric = \"silk\" names no fabric; known: \"wool\"",
                "scene.toml:9: piece.a.cell = 0.2 m; allowed: at most the piece's shorter side, 0.1 m",
                "scene.toml:14: pin.p.at[0] = [1, 0] m lies 0.9 m off the piece \"a\"",
                "wool.toml:1: fabric.wool.areal_density = -1 kg/m^2; allowed: from 0.0001 to 100 kg/m^2",
                "wool.toml:2: fabric.wool.thicknes is no known key; the nearest is \"thickness\""}));
}

}  // namespace
}  // namespace drape
