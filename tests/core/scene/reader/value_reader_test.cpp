// Faults of single keys: unknown and missing keys, types, ranges, names, files.
#include "fault_case.h"

namespace drape::scene {

using namespace tests;
namespace {

class SceneFault : public testing::TestWithParam<Case> {};

TEST_P(SceneFault, GivesItsMessages) { EXPECT_EQ(scene_fault(GetParam()), GetParam().messages); }

const Case kKeys[] = {
    {"unknown_key",
     "damping = ",
     "dampnig = ",
     {"scene.toml:8: scene.dampnig is no known key; the nearest is \"damping\""}},
    {"unknown_key_near_none",
     "damping = ",
     "colour = ",
     {"scene.toml:8: scene.colour is no known key; known: name, description, author, version, copyright, "
      "license, duration, gravity, integrator, step, communication, damping, energy, wind, mode, order, "
      "self_contact, imperfection"}},
    {"neighbours_exchanged",
     "edges = [2]",
     "egdes = [2]",
     {"scene.toml:25: pin.bar holds nothing; wanted: at, edges or region",
      "scene.toml:28: pin.bar.egdes is no known key; the nearest is \"edges\""}},
    {"unknown_table",
     "[options]",
     "[option]",
     {"scene.toml:10: option is no known key; the nearest is \"options\""}},
    {"unknown_key_in_fabric",
     "warp.force",
     "warp.fore",
     {"scene.toml:17: fabric.wool.warp.fore is no known key; the nearest is \"force\""}},
    {"table_of_the_contract",
     "[options]",
     "[body]\nname = \"a\"\n[options]",
     {"scene.toml:10: body is a table; wanted: tables [[body]]"}},
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
      "scene.toml:20: fabric.silk.warp.elongation_percent is missing; wanted: a list of numbers in percent",
      "scene.toml:20: fabric.silk.warp.force is missing; wanted: a list of numbers in N"}},
    {"not_a_table",
     "warp.force = [0, 3, 9]",
     "strip = 0.05",
     {"scene.toml:17: fabric.wool.strip is a number; wanted: a table or \"GOST 3813\", \"GOST 3813 wool\", "
      "\"GOST 3813 small\", \"ISO 13934-1\", \"ISO 13934-1 100 mm\", \"ASTM D5035 1R\", \"ASTM D5035 2R\", "
      "\"ASTM D5035 1C\", \"ASTM D5035 2C\""}},
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

INSTANTIATE_TEST_SUITE_P(Keys, SceneFault, testing::ValuesIn(kKeys), name_of);
INSTANTIATE_TEST_SUITE_P(Values, SceneFault, testing::ValuesIn(kValues), name_of);

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

// After the location the message is the parser's own.
TEST(SceneFile, ThatIsNotToml) {
  const auto starts = [](const Messages& messages, const std::string& start) {
    return messages.size() == 1 && messages[0].starts_with(start);
  };
  EXPECT_TRUE(starts(scene_messages("[scene\nname = \"a\"\n"), "scene.toml:1:7: is not valid TOML: "));
  EXPECT_TRUE(starts(scene_messages("[scene]\nname = = 1\n"), "scene.toml:2:8: is not valid TOML: "));
  EXPECT_TRUE(starts(scene_messages("[ = 1"), "scene.toml:1:3: is not valid TOML: "));
  std::string deep = "a";
  for (int k = 0; k < 100000; ++k) deep += ".a";
  const char* const told = " has a key of 257 or more parts; allowed: up to 256";
  EXPECT_TRUE(starts(scene_messages("[scene]\n" + deep + " = 1\n"), std::string("scene.toml:2:") + told));
  EXPECT_TRUE(
      starts(scene_messages("# " + deep + "\n[" + deep + "]\n"), std::string("scene.toml:2:") + told));
  EXPECT_TRUE(starts(scene_messages("x = [" + std::string(100000, '[')), "scene.toml:1:"));
  EXPECT_FALSE(starts(scene_messages("x = \"" + deep + "\"\n"), std::string("scene.toml:1:") + told));
  EXPECT_TRUE(starts(scene_messages("a = 1\na = 2"), "scene.toml:2:"));
  EXPECT_TRUE(starts(scene_messages("a = \"\xff\""), "scene.toml:1:"));
  EXPECT_TRUE(starts(scene_messages("a = " + std::string(100000, '[')), "scene.toml:1:"));

  const SceneFolder folder;
  folder.write("wool.toml", "thickness = 1e-3\nareal_density 0.15\n");
  EXPECT_TRUE(
      starts(messages_of(folder, folder.write("scene.toml", kScene)), "wool.toml:2:15: is not valid TOML: "));
}

// toml++ prints a whole number by its sign and size, and this one has no size.
TEST(SceneFile, HasNoLeastInteger) {
  const std::string told = " has the whole number -9223372036854775808; allowed: from -9223372036854775807";
  for (const char* value : {"-9223372036854775808", "[1, {y = -9223372036854775808}]"})
    EXPECT_EQ(scene_messages("[scene]\nx = " + std::string(value) + "\n"), Messages{"scene.toml:2:" + told});
  EXPECT_NE(scene_messages("[scene]\nx = -9223372036854775807\n")[0], "scene.toml:2:" + told);
}

// Unpatched, toml++ 3.3 runs into an undefined branch at the letter, which the sanitizers stop.
TEST(SceneFile, TakesAnyLetterAfterALineThatEndsInABackslash) {
  for (const std::string letter : {"\u00e9", "\u0416", "\uff21"}) {
    const Messages messages = scene_messages("[scene]\nname = \"\"\"\\\n  " + letter + "\"\"\"\n");
    ASSERT_FALSE(messages.empty());
    EXPECT_TRUE(messages.back().starts_with("scene.toml:2: scene.name = \"" + letter + "\" is no name"))
        << messages.back();
  }
}

// Texts are cut after 80 bytes, here within the two bytes of the letter.
TEST(SceneFile, ThatHoldsALongTextIsQuotedUpToAWholeLetter) {
  const std::string first(79, 'a');
  const Messages messages = scene_messages("[scene]\nname = \"" + first + "\u00e9\u00e9\"\n");
  ASSERT_FALSE(messages.empty());
  EXPECT_TRUE(messages.back().starts_with("scene.toml:2: scene.name = \"" + first + "...\" "))
      << messages.back();
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
      (Messages{("scene.toml:2: scene.name = \"1\" is no name; wanted: a letter, then letters, digits or "
                 "underscores, at most 64 characters in all"),
                "scene.toml:3: scene.duration = -1 s; allowed: above 0, at most 1e+07 s",
                "scene.toml:4: fabric.wool.thickness is missing; wanted: a number in m",
                "scene.toml:8: piece.a.fabric = \"silk\" names no fabric; known: \"wool\"",
                "scene.toml:9: piece.a.cell = 0.2 m; allowed: at most the piece's shorter side, 0.1 m",
                "scene.toml:14: pin.p.at[0] = [1, 0] m lies 0.9 m off the piece \"a\"",
                "wool.toml:1: fabric.wool.areal_density = -1 kg/m^2; allowed: from 0.0001 to 100 kg/m^2",
                "wool.toml:2: fabric.wool.thicknes is no known key; the nearest is \"thickness\""}));
}

}  // namespace
}  // namespace drape::scene
