// What `drape check` prints and draws.
#include <pugixml.hpp>

#include "command/command_fixture.h"

namespace drape::command {
namespace {

TEST_F(Command, CheckReportsSizeAreaAndMass) {
  Done done = drape("check scene.toml");
  EXPECT_EQ(done.code, 0);
  EXPECT_NE(done.text.find("piece sheet: 54 particles, 40 cells of 10 mm, 0.004 m2, 0.0008 kg\nstep limit"),
            std::string::npos)
      << done.text;

  // 3.5 x 2.1 cells: the upper row is merged, the last column cut. The other piece has a slit of two cells.
  std::ofstream(folder / "scene.toml", std::ios::app) << R"(
[[piece]]
name = "flap"
fabric = "wool"
cell = 0.02
outline = [[0, 0], [0.07, 0], [0.07, 0.042], [0, 0.042]]
[[piece]]
name = "slit"
fabric = "wool"
cell = 0.01
outline = [[0, 0], [0.03, 0], [0.03, 0.03], [0.0151, 0.03], [0.015, 0.008], [0.0149, 0.03], [0, 0.03]]
)";
  done = drape("check scene.toml");
  EXPECT_EQ(done.code, 0);
  for (const char* line :
       {"piece flap: 15 particles, 8 cells of 20 mm (2 cut, 4 merged), 0.00294 m2, 0.000588 kg\n",
        "piece slit: 20 particles (4 twins), 11 cells of 10 mm (5 cut), 0.0008978 m2, 0.00017956 kg\n",
        "3 pieces: 89 particles, 0.0078378 m2, 0.00156756 kg\n"})
    EXPECT_NE(done.text.find(line), std::string::npos) << line << done.text;
}

// In processor seconds. A fit ends where it is at rest, which nothing foretells.
TEST_F(Command, CheckEstimatesTheCostOfMotionsOnly) {
  EXPECT_NE(drape("check scene.toml").text.find(" CPU s per simulated second, "), std::string::npos);
  std::string scene = text_of("scene.toml");
  scene.replace(scene.find("[scene]\n"), 8, "[scene]\nmode = \"fit\"\n");
  std::ofstream(folder / "fit.toml") << scene;
  const Done fit = drape("check fit.toml");
  EXPECT_EQ(fit.code, 0) << fit.text;
  EXPECT_EQ(fit.text.find("cost"), std::string::npos) << fit.text;
}

// Two types of one name in one program crash it where nothing is inlined, as in the debug build: there the
// linker gives both the destructor of one. A list of two bodies runs it.
TEST_F(Command, CheckReadsTwoBodies) {
  std::ofstream(folder / "wedge.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  std::ofstream scene(folder / "scene.toml", std::ios::app);
  for (const char* body : {"left", "right"})
    scene << "[[body]]\nname = \"" << body
          << "\"\nmesh = \"wedge.obj\"\nscale = 0.1\nposition = [0, 0, 0.5]\n";
  scene.close();
  const Done done = drape("check scene.toml");
  EXPECT_EQ(done.code, 0) << done.text;
  EXPECT_NE(done.text.find("piece sheet: 54 particles"), std::string::npos) << done.text;
}

TEST_F(Command, CheckDrawsOnlyWhenAsked) {
  ASSERT_EQ(drape("check scene.toml").code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  const Done done = drape("check scene.toml --picture cloth.svg");
  ASSERT_EQ(done.code, 0) << done.text;
  EXPECT_NE(done.text.find("cost: "), std::string::npos);
  const std::string svg = text_of("cloth.svg");
  pugi::xml_document document;
  EXPECT_TRUE(document.load_buffer(svg.data(), svg.size()));
  EXPECT_EQ(std::string(document.document_element().name()), "svg");

  expect_refused("check scene.toml --picture none/cloth.svg",
                 {"error: cannot write none/cloth.svg: No such file or directory"});
  expect_refused("check scene.toml --picture ''", {"--picture is empty"});
  const std::string scene = text_of("scene.toml");
  expect_refused("check scene.toml --picture ./scene.toml", {"--picture is ./scene.toml", "read from"});
  EXPECT_EQ(text_of("scene.toml"), scene);
  fs::create_symlink("/dev/full", folder / "full.svg");
  const Done full = drape("check scene.toml --picture full.svg");
  EXPECT_EQ(full.code, 2);
  EXPECT_EQ(full.text, "error: cannot write full.svg: No space left on device\n");
}

}  // namespace
}  // namespace drape::command
