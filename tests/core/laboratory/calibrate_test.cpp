// Calibrations and their place in the text of a fabric. Equations: core/README.md, section 5.
#include "laboratory/calibrate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laboratory/write_calibration.h"
#include "reference/test_cloth.h"
#include "scene_file.h"
#include "validation/load.h"

namespace drape::laboratory {

using namespace tests;
namespace {

constexpr const char* kText =
    "# Ours, \xc2\xb5\n"
    "areal_density = 0.2   # kg/m2\n"
    "thickness = 0.0004\n"
    "strip = { width = 0.05, gauge = 0.2 }\n"
    "weft.elongation_percent = [0, 2, 4]\n"
    "  weft.force = [0, 8, 20]  # N\n"
    "bias = { elongation_percent = [0, 2, 4, 6], force = [0, 0.4, 0.9, 1.5] } # end\n"
    "[warp]\n"
    "elongation_percent = [0, 1, 2]\n"
    "force = [\n  0, # nothing\n  6,\n  15]\n";

scene::FabricSpec read(const std::string& text, scene::Corrections corrections = scene::Corrections::kKept) {
  const SceneFolder folder;
  std::vector<Problem> problems;
  const scene::FabricSpec f = validation::fabric_load(folder.write("f.toml", text), problems, corrections);
  for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
  return f;
}

Calibration calibrated(const scene::FabricSpec& f, double cell = 0.0125) {
  std::vector<Problem> problems;
  const Calibration c = calibrate(f, {.cell = cell}, problems);
  for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
  return c;
}

double off(const scene::FabricSpec& f, model::YarnDirection along, double cell) {
  std::vector<Problem> problems;
  const StripPull pull = strip_pull(f, along, cell, strip_elongations(f, along, 10), problems);
  double largest = pull.force.empty() ? 1 : 0;
  for (std::size_t k = 0; k < pull.force.size(); ++k)
    largest = std::max(largest, std::abs(pull.force[k] / strip_diagram(f, along).force[k + 1] - 1));
  return largest;
}

TEST(Calibration, LetsStripsGiveBackTheirDiagrams) {
  const scene::FabricSpec f = read(kText);
  const Calibration c = calibrated(f);
  ASSERT_TRUE(c.converged) << c.why;
  for (model::YarnDirection along :
       {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias}) {
    EXPECT_GT(off(f, along, 0.0125), 5e-3);
    EXPECT_LE(off(c.fabric, along, 0.0125), 1e-4);
  }
}

// A second one has nothing to do.
TEST(Calibration, StartsFromStoredCorrections) {
  const Calibration c = calibrated(calibrated(read(kText)).fabric);
  ASSERT_TRUE(c.converged);
  EXPECT_EQ(c.residuals.size(), 1u);
}

// Its sweeps are few: three that place points, and what mixing leaves of the others (without it, the last
// points of half-wool take 15).
TEST(Calibration, TakesFewSweeps) {
  std::vector<Problem> problems;
  for (const char* name : {"cotton", "half_wool", "quilting_cotton"}) {
    const scene::FabricSpec f =
        validation::fabric_load(DRAPE_SOURCE_DIR "/examples/fabrics/" + std::string(name) + ".toml", problems,
                                scene::Corrections::kDropped);
    ASSERT_TRUE(f.bias.correction.empty() && f.bias.correction_elongation.empty());
    const Calibration c = calibrate(f, {.cell = f.strip_width / 8}, problems);
    ASSERT_TRUE(c.converged && problems.empty()) << c.why;
    EXPECT_LE(c.residuals.size(), 8u) << name;
  }
}

// Slack toes: no force is told where the diagram has none, and the rest is given back.
TEST(Calibration, LetsDiagramsBeSlackAtFirst) {
  std::string text(kText);
  for (const auto& [from, to] : {std::pair{"[\n  0, # nothing\n  6,", "[\n  0, # nothing\n  0,"},
                                 std::pair{"weft.force = [0, 8,", "weft.force = [0, 0,"}})
    text.replace(text.find(from), std::string(from).size(), to);
  const Calibration c = calibrated(read(text));
  ASSERT_TRUE(c.converged) << c.why;
  EXPECT_EQ(c.fabric.warp.force[1], 0);
  EXPECT_NEAR(c.residuals.back(), 0, 1e-4);
}

// A tuned point keeps its correction: with all forces of a fabric times a factor, all laws are, and so are
// the simulated strips, but for bending (1e-6 of the forces).
TEST(Calibration, StaysWithTunedPoints) {
  scene::FabricSpec f = calibrated(read(kText)).fabric;
  for (scene::DiagramSpec* d : {&f.warp, &f.weft, &f.bias})
    for (double& force : d->force) force *= 1.7;
  for (model::YarnDirection along :
       {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias})
    EXPECT_LE(off(f, along, 0.0125), 1.1e-4);
}

// Diagonals that pull harder than the warp's whole diagram cannot be taken out of it.
TEST(Calibration, ReportsWhyItDoesNotConverge) {
  scene::FabricSpec f = read(kText);
  f.warp.force = {0, 0.05, 0.1};
  const Calibration c = calibrated(f);
  EXPECT_FALSE(c.converged);
  EXPECT_FALSE(c.why.empty());
  EXPECT_FALSE(c.residuals.empty());
}

// The text but for the lines and entries added is the user's, byte by byte; read again, it has the
// corrections.
TEST(WriteCalibration, KeepsTheText) {
  for (const bool crlf : {false, true}) {
    std::string text = kText;
    if (crlf)
      for (std::size_t k = 0; (k = text.find('\n', k)) != std::string::npos; k += 2) text.insert(k, "\r");
    const Calibration c = calibrated(read(text));
    std::vector<Problem> problems;
    const std::string stored = write_calibration(text, c, "2026-11-25", problems);
    ASSERT_TRUE(problems.empty());
    std::size_t from = 0;  // every piece of the old text, in order
    for (const char* piece :
         {"# Ours, \xc2\xb5", "areal_density = 0.2   # kg/m2", "thickness = 0.0004",
          "  weft.force = [0, 8, 20]  # N", "  weft.correction = [",
          "bias = { elongation_percent = [0, 2, 4, 6], force = [0, 0.4, 0.9, 1.5], ", " } # end", "[warp]",
          "  0, # nothing", "\ncorrection = [", "[calibration]", "cell = 0.0125", "date = \"2026-11-25\""}) {
      const std::size_t at = stored.find(piece, from);
      ASSERT_NE(at, std::string::npos) << piece << " in\n" << stored;
      from = at + 1;
    }
    for (std::size_t k = stored.find('\n'); crlf && k != std::string::npos; k = stored.find('\n', k + 1))
      EXPECT_EQ(stored[k - 1], '\r');
    const scene::FabricSpec again = read(stored);
    for (model::YarnDirection along :
         {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias}) {
      const scene::DiagramSpec &a = strip_diagram(again, along), &b = strip_diagram(c.fabric, along);
      ASSERT_EQ(a.correction.size(), b.correction.size());
      for (std::size_t k = 0; k < a.correction.size(); ++k)
        EXPECT_NEAR(a.correction[k] / b.correction[k], 1, 1e-5);
    }
    // Stored anew, only figures change.
    const std::string twice = write_calibration(stored, c, "2027-01-01", problems);
    EXPECT_EQ(twice.size(), stored.size());
    EXPECT_NE(twice.find("2027-01-01"), std::string::npos);
  }
}

// A diagram whose jaws went away loses the corrections of its elongations, in a table and on a line.
TEST(WriteCalibration, RemovesWhatNoLongerHolds) {
  for (const bool inline_table : {false, true}) {
    std::string text(kText);
    const std::string line =
        "bias = { elongation_percent = [0, 2, 4, 6], force = [0, 0.4, 0.9, 1.5] } # end\n";
    if (!inline_table) {
      text.erase(text.find(line), line.size());
      text += "\n[bias]\nelongation_percent = [0, 2, 4, 6]\nforce = [0, 0.4, 0.9, 1.5]\n";
    }
    std::vector<Problem> problems;
    const std::string with = write_calibration(text, calibrated(read(text)), "2026-11-25", problems);
    ASSERT_NE(with.find("correction_elongation = ["), std::string::npos);
    std::string loose = with;
    const std::string force = "force = [0, 0.4, 0.9, 1.5]";
    loose.insert(loose.find(force) + force.size(), inline_table ? ", jaws = false" : "\njaws = false");
    const std::string again = write_calibration(loose, calibrated(read(loose, scene::Corrections::kDropped)),
                                                "2026-11-26", problems);
    ASSERT_TRUE(problems.empty()) << scene::problem_text(problems[0]);
    EXPECT_EQ(again.find("correction_elongation"), std::string::npos) << again;
    EXPECT_TRUE(read(again).bias.correction_elongation.empty());
    EXPECT_EQ(read(again).bias.correction.size(), 4u);
  }
}

// Diagrams of a sheet have no table of their own: their corrections stand in [calibration].
TEST(WriteCalibration, KeepsASheet) {
  const std::string text =
      "thickness = 0.0004\n[fast]\nW = 168\nC = [15, 14.5]\nE5 = [0.67, 0.4]\nE20 = [1.87, 1.87]\n"
      "E100 = [4.6, 5.87]\nEB5 = 4.7\n";
  const Calibration c = calibrated(read(text));
  ASSERT_TRUE(c.converged);
  std::vector<Problem> problems;
  const std::string stored = write_calibration(text, c, "2026-11-25", problems);
  ASSERT_TRUE(problems.empty());
  EXPECT_EQ(stored.substr(0, text.size()), text);
  const scene::FabricSpec again = read(stored);
  for (model::YarnDirection along :
       {model::YarnDirection::kWarp, model::YarnDirection::kWeft, model::YarnDirection::kBias}) {
    const scene::DiagramSpec &a = strip_diagram(again, along), &b = strip_diagram(c.fabric, along);
    ASSERT_EQ(a.correction.size(), b.correction.size());
    for (std::size_t k = 0; k < a.correction.size(); ++k)
      EXPECT_NEAR(a.correction[k] / b.correction[k], 1, 1e-5);
  }
  EXPECT_NE(again.warp.correction[1], 1);
  const std::string twice = write_calibration(stored, c, "2027-01-01", problems);
  EXPECT_EQ(twice.size(), stored.size());
}

}  // namespace
}  // namespace drape::laboratory
