// The `drape` command as a user types it: words that it accepts and refuses, and the files that it writes.
#include "command/command_fixture.h"
#include "decimal.h"

namespace drape::command {
namespace {

// One --set for several settings, one for each, and both; a plus sign; the same bits.
TEST_F(Command, TakesSettingsInARow) {
  const std::string run = "run scene.toml --until 0.004 --every 0.002 -o ";
  ASSERT_EQ(drape(run + "none").code, 0);
  ASSERT_EQ(drape(run + "row --set damping=3 gravity[3]=-5").code, 0);
  ASSERT_EQ(drape(run + "each --set damping=+3 --set=gravity[3]=-5").code, 0);
  ASSERT_EQ(
      drape("run --set damping=+3e0 gravity[3]=-5 scene.toml --until 0.004 --every 0.002 -o first").code, 0);
  EXPECT_NE(text_of("row/outputs.csv"), text_of("none/outputs.csv"));
  EXPECT_EQ(text_of("row/outputs.csv"), text_of("each/outputs.csv"));
  EXPECT_EQ(text_of("row/outputs.csv"), text_of("first/outputs.csv"));
  for (const char* value : {"+", "+-3", "++3", "3x", ""})
    expect_refused(run + "x --set damping=" + value, {"--set damping is '" + std::string(value) + "'"});
  expect_refused(run + "x --set damping=1 dampnig=2", {"'dampnig'", "'damping'"});
  expect_refused(run + "x --set wind=2", {"'wind'", "drape variables"});
}

TEST_F(Command, NamesTheCommandThatItDoesNotKnow) {
  expect_refused("rnu scene.toml", {"'rnu'", "the nearest is 'run'"});
  expect_refused("cheek scene.toml", {"'cheek'", "the nearest is 'check'"});
  expect_refused("scene.toml", {"'scene.toml'", "known: check, pack, run, reference, variables"});
}

TEST_F(Command, NeverWritesOverWhatItReads) {
  std::string scene = text_of("scene.toml");
  const std::string density = "areal_density = 0.2\n";
  scene.replace(scene.find(density), density.size(), "file = \"wool.toml\"\n");
  std::ofstream(folder / "scene.toml") << scene;
  std::ofstream(folder / "wool.toml") << density;
  fs::create_symlink("wool.toml", folder / "link.toml");
  for (const char* file : {"scene.toml", "./scene.toml", "wool.toml", "link.toml"})
    expect_refused(std::string("pack scene.toml -o ") + file, {file, "read from"});
  EXPECT_EQ(text_of("scene.toml"), scene);
  EXPECT_EQ(text_of("wool.toml"), density);
  for (const char* command : {"pack", "run", "reference"})
    expect_refused(std::string(command) + " scene.toml -o ''", {"--output is empty"});
  EXPECT_EQ(drape("pack scene.toml -o cloth.fmu").code, 0);
  EXPECT_EQ(drape("pack scene.toml -o cloth.fmu").code, 0);  // over an older FMU
}

TEST_F(Command, GivesTheReasonWhyItCannotWrite) {
  std::ofstream(folder / "file") << "x";
  expect_refused("run scene.toml -o file", {"file", "Not a directory"});
  expect_refused("pack scene.toml -o none/cloth.fmu", {"none/cloth.fmu", "No such file or directory"});
  fs::create_directories(folder / "full");
  fs::create_symlink("/dev/full", folder / "full/outputs.csv");
  for (const char* command : {"run", "reference"}) {
    const Done done = drape(std::string(command) + " scene.toml --until 0.001 -o full");
    EXPECT_EQ(done.code, 2);
    EXPECT_NE(done.text.find("error: cannot write full/outputs.csv: No space left on device\n"),
              std::string::npos);
    EXPECT_EQ(done.text.find(" s of cloth in ") != std::string::npos, std::string(command) == "run");
  }
}

// Rows at k DT and at the end, exactly; numbers as the shortest decimals.
TEST_F(Command, WritesTheTimesThatWereAskedFor) {
  ASSERT_EQ(drape("run scene.toml --until 0.01 --every 0.0007 -o out").code, 0);
  const std::vector<std::string> lines = lines_of("out/outputs.csv");
  ASSERT_EQ(lines.size(), 17u);  // the header, 0 to 14 DT, the end
  for (int k = 0; k <= 15; ++k) {
    const std::string& line = lines[std::size_t(k) + 1];
    EXPECT_EQ(line.substr(0, line.find(',')), k < 15 ? description::decimal_text(k * 0.0007) : "0.01");
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');)
      EXPECT_EQ(cell, description::decimal_text(std::strtod(cell.c_str(), nullptr)));
  }
}

// The reference solver has the columns of the run, in the same order, except for those that only the run
// has.
TEST_F(Command, ReferenceHasTheColumnsOfRun) {
  const std::string options = " scene.toml --until 0.002 --every 0.001 --nodes all -o ";
  ASSERT_EQ(drape("run" + options + "run").code, 0);
  ASSERT_EQ(drape("reference" + options + "reference").code, 0);
  std::istringstream run_header(lines_of("run/outputs.csv")[0]),
      reference_header(lines_of("reference/outputs.csv")[0]);
  std::string left_out, expected;
  for (std::string name, here; std::getline(run_header, name, ',');) {
    if (here.empty()) std::getline(reference_header, here, ',');
    if (here == name) here.clear();
    else left_out += name + " ";
  }
  EXPECT_FALSE(std::getline(reference_header, expected, ',')) << expected;
  std::istringstream lacking(left_out);
  for (std::string name; lacking >> name;) EXPECT_EQ(name, "step.stability");
  // Each value is under its column: the weight that the pin begins to bear, and the time.
  const auto cell = [&](const std::string& file, const std::string& name) {
    std::istringstream names(lines_of(file)[0]), cells(lines_of(file)[3]);
    for (std::string column, value; std::getline(names, column, ',') && std::getline(cells, value, ',');)
      if (column == name) return std::strtod(value.c_str(), nullptr);
    return 0.0;
  };
  for (const char* name : {"time", "pin.bar.force[3]", "strain.warp.max", "probe.hem.position[3]"}) {
    const double run = cell("run/outputs.csv", name);
    EXPECT_NE(run, 0) << name;
    EXPECT_NEAR(cell("reference/outputs.csv", name), run, 0.05 * std::abs(run)) << name;
  }
}

// Every problem of the file at once, with its line and column.
TEST_F(Command, InputsThatAreRefused) {
  fs::copy_file(DRAPE_SAMPLES "/flag.toml", folder / "flag.toml");
  const auto expect_problems = [&](const std::string& csv, const std::vector<std::string>& sentences) {
    std::ofstream(folder / "u.csv") << csv;
    const Done done = drape("run flag.toml --until 0.01 -o out --inputs u.csv");
    EXPECT_EQ(done.code, 1) << done.text;
    std::string expected;
    for (const std::string& sentence : sentences) expected += "error: u.csv" + sentence + "\n";
    EXPECT_EQ(done.text, expected) << csv;
    EXPECT_FALSE(fs::exists(folder / "out"));
  };
  expect_problems("wind[1],wind[2]\n1,2\n", {":1:1: the column 'time' is missing"});
  expect_problems("time,widn[1]\n0,1\n", {":1:2: 'widn[1]' is no variable; the nearest is 'wind[1]'"});
  expect_problems("time,tension.max,damping\n0,1,2\n",
                  {":1:2: 'tension.max' is an output; allowed: time and inputs",
                   ":1:3: 'damping' is a parameter, which --set sets; allowed: time and inputs"});
  expect_problems("time,wind[1],wind[1]\n0,1,2\n", {":1:3: 'wind[1]' is there already, in column 2"});
  expect_problems("time,wind[1]\n0,1\n0.1\n0.2,x\n0.1,3\nnan,2\n0.3,1e5\n0.4,\n",
                  {":3:2: 1 cells; expected: 2, as in the header", ":4:2: 'x'; allowed: a number",
                   ":5:1: time is 0.1 s; allowed: above the time before it, 0.2 s",
                   ":6:1: time is nan s; allowed: any finite number",
                   ":7:2: wind[1] is 1e+05 m/s; allowed: -1000 to 1000 m/s", ":8:2: ''; allowed: a number"});
  expect_problems("time,wind[1]\n", {" has no row of values; allowed: one or more below the header"});
  expect_refused("run flag.toml -o out --inputs none.csv", {"cannot read none.csv: there is no such file"});
  expect_refused("run scene.toml -o out --inputs u.csv", {"u.csv:1:2", "'wind[1]'", "no inputs"});
}

// Linear between rows; the first and last rows hold outside. Quotes, blanks, empty lines and line ends of
// any kind.
TEST_F(Command, InputsAreLinearBetweenRows) {
  fs::copy_file(DRAPE_SAMPLES "/flag.toml", folder / "flag.toml");
  std::ofstream(folder / "few.csv")
      << "\xEF\xBB\xBFtime, \"wind[3]\"\r\n\r\n0.001953125,+1\r\n0.00390625, 3 \r\n";
  std::ofstream(folder / "many.csv")
      << "wind[3],time\n1,0\n1,0.001953125\n2,0.0029296875\n3,0.00390625\n3,1\n";
  for (const char* inputs : {"few", "many"}) {
    const std::string name = inputs;
    const Done done =
        drape("run flag.toml --until 0.01 --every 0.0048828125 -o " + name + " --inputs " + name + ".csv");
    ASSERT_EQ(done.code, 0) << done.text;
  }
  ASSERT_EQ(drape("run flag.toml --until 0.01 --every 0.0048828125 -o none").code, 0);
  EXPECT_EQ(text_of("few/outputs.csv"), text_of("many/outputs.csv"));
  EXPECT_NE(text_of("few/outputs.csv"), text_of("none/outputs.csv"));
}

// 1e5 steps in an interval: the cost is known after a few of them.
TEST_F(Command, CheckDoesNotWaitForAnInterval) {
  std::string scene = text_of("scene.toml");
  scene.replace(scene.find("duration = 0.2"), 14, "duration = 0.2\ncommunication = 2\nstep = 2e-6");
  std::ofstream(folder / "scene.toml") << scene;
  const Done done = drape("check scene.toml");
  EXPECT_EQ(done.code, 0) << done.text;
  const std::size_t first = done.text.find("over the first ");
  ASSERT_NE(first, std::string::npos) << done.text;
  const double simulated = std::strtod(done.text.c_str() + first + 15, nullptr);
  EXPECT_GT(simulated, 0);
  EXPECT_LT(simulated, 2);
}

// A step above the limit of the assembled cloth is reported with its line, like every fault, and alone.
TEST_F(Command, FaultOfTheAssembledClothHasItsLine) {
  std::string scene = text_of("scene.toml");
  scene.replace(scene.find("duration = 0.2"), 14, "duration = 0.2\nstep = 1e-3");
  std::ofstream(folder / "scene.toml") << scene;
  expect_refused("check scene.toml",
                 {"error: scene.toml:6: scene.step = 0.001 s", "step limit", "set by the"});
  scene.replace(scene.find("duration = 0.2"), 14, "duration = -1 ");
  std::ofstream(folder / "scene.toml") << scene;
  expect_refused("check scene.toml", {"error: scene.toml:5: scene.duration = -1 s"});
}

}  // namespace
}  // namespace drape::command
