// `drape import`: patterns as scenes.
#include "command/garmentcode/garment.h"

#include <cmath>

#include "command/command_fixture.h"
#include "piece/outline/outline.h"
#include "piece/place.h"
#include "seam/layout.h"
#include "validation/load.h"

namespace drape::command {
namespace {

// A tunic, cm: 60 wide and 80 long, front and back in the same axes at z = +20 and -20. The front goes
// counter-clockwise, the back clockwise, so that both go so from outside. Necks are parabolas, armholes
// cubics, hems arcs of the radius 50; shoulders and sides are straight.
//
//      4 _ 3     edges of the front: 0 hem, 1 side, 2 armhole, 3 shoulder, 4 neck, 5 shoulder, 6 armhole, 7
//      side
//    5 /   \ 2
//  6  (     ) 1..
//     |_____|
const char* const kTunic = R"({
  "pattern": {
    "panels": {
      "back": {
        "translation": [0, 60, -20], "rotation": [0, 0, 0], "label": "body",
        "vertices": [[-30, 0], [-30, 55], [-20, 78], [-8, 80], [8, 80], [20, 78], [30, 55], [30, 0]],
        "edges": [
          {"endpoints": [0, 1]},
          {"endpoints": [1, 2], "curvature": {"type": "cubic", "params": [[0.2, -0.35], [0.5, -0.2]]}},
          {"endpoints": [2, 3]},
          {"endpoints": [3, 4], "curvature": {"type": "quadratic", "params": [[0.5, -0.3]]}},
          {"endpoints": [4, 5]},
          {"endpoints": [5, 6], "curvature": {"type": "cubic", "params": [[0.5, -0.2], [0.8, -0.35]]}},
          {"endpoints": [6, 7]},
          {"endpoints": [7, 0], "curvature": {"type": "circle", "params": [50, 0, 0]}}]
      },
      "front": {
        "translation": [0, 60, 20], "rotation": [0, 0, 0],
        "vertices": [[-30, 0], [30, 0], [30, 55], [20, 78], [8, 80], [-8, 80], [-20, 78], [-30, 55]],
        "edges": [
          {"endpoints": [0, 1], "label": "hem\nfront", "curvature": {"type": "circle", "params": [50, 0, 1]}},
          {"endpoints": [1, 2]},
          {"endpoints": [2, 3], "curvature": {"type": "cubic", "params": [[0.2, 0.35], [0.5, 0.2]]}},
          {"endpoints": [3, 4]},
          {"endpoints": [4, 5], "curvature": [0.5, 0.9]},
          {"endpoints": [5, 6]},
          {"endpoints": [6, 7], "curvature": {"type": "cubic", "params": [[0.5, 0.2], [0.8, 0.35]]}},
          {"endpoints": [7, 0]}]
      }
    },
    "stitches": [
      [{"panel": "front", "edge": 1}, {"panel": "back", "edge": 6}],
      [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 4}],
      [{"panel": "back", "edge": 2}, {"panel": "front", "edge": 5}],
      [{"panel": "front", "edge": 7}, {"panel": "back", "edge": 0}]],
    "panel_order": ["front", "back"]
  },
  "properties": {"curvature_coords": "relative", "units_in_meter": 100}
})";

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

double norm(Vec3 a, Vec3 b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

class Import : public Command {
 protected:
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder / file, std::ios::binary) << text;
  }
  Done import(const std::string& json, const std::string& more = "") const {
    write("tunic.json", json);
    return drape("import tunic.json -o tunic.toml " + more);
  }
  Scene scene_of(const std::string& file = "tunic.toml") const {
    std::vector<Problem> problems;
    const Scene scene = validation::scene_load(folder / file, problems);
    for (const Problem& p : problems) ADD_FAILURE() << scene::problem_text(p);
    return scene;
  }
  // Expects a refusal with these sentences, in this order.
  void expect_faults(const std::string& json, const std::vector<std::string>& sentences) const {
    const Done done = import(json);
    std::string expected;
    for (const std::string& s : sentences) expected += "error: tunic.json: " + s + "\n";
    EXPECT_EQ(done.code, 1);
    EXPECT_EQ(done.text, expected);
    EXPECT_FALSE(fs::exists(folder / "tunic.toml"));
  }
};

// Expects that both starts and both ends of every seam lie opposite each other: 0.4 m apart, along z.
void expect_ends_meet(const Scene& scene) {
  for (const scene::SeamSpec& seam : scene.seams) {
    const seam::SeamLayout layout = seam::seam_layout(scene, seam);
    for (const bool end : {false, true}) {
      Vec3 at[2];
      for (std::size_t k = 0; k < 2; ++k)
        at[k] = piece::place_point(scene.pieces[std::size_t(seam.side[k].piece)].place,
                                   end ? layout.point[k].back() : layout.point[k].front());
      EXPECT_NEAR(norm(at[0], at[1]), 0.4, 1e-12) << seam.name;
      EXPECT_NEAR(at[0][0], at[1][0], 1e-12) << seam.name;
    }
    EXPECT_NEAR(layout.length[0], layout.length[1], 1e-12) << seam.name;
  }
}

TEST_F(Import, SewsEndsThatMeet) {
  const Done done = import(kTunic);
  ASSERT_EQ(done.code, 0) << done.text;
  const Scene scene = scene_of();
  EXPECT_EQ(scene.mode, scene::Mode::kFit);
  ASSERT_EQ(scene.pieces.size(), 2u);
  EXPECT_EQ(scene.pieces[0].name, "front");  // the order of panel_order
  EXPECT_EQ(scene.pieces[0].cell, 0.01);
  ASSERT_EQ(scene.seams.size(), 4u);
  expect_ends_meet(scene);
}

// A back with the same direction as the front is sewn right to wrong: edges start where their seams start.
TEST_F(Import, SewsRightToWrong) {
  std::string json = kTunic;
  const std::size_t from = json.find("\"vertices\""), to = json.find("\"front\": {");
  json.replace(from, to - from, R"("vertices": [[-30, 0], [30, 0], [30, 55], [20, 78], [8, 80], [-8, 80],
    [-20, 78], [-30, 55]], "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]},
    {"endpoints": [3, 4]}, {"endpoints": [4, 5]}, {"endpoints": [5, 6]}, {"endpoints": [6, 7]},
    {"endpoints": [7, 0]}]}, )");
  for (const auto& [edge, back] : {std::pair{"6", "1"}, {"4", "3"}, {"0", "7"}})
    json = edited(json, std::string("{\"panel\": \"back\", \"edge\": ") + edge + "}]",
                  std::string("{\"panel\": \"back\", \"edge\": ") + back + "}, \"right_wrong\"]");
  json = edited(json, "[{\"panel\": \"back\", \"edge\": 2}, {\"panel\": \"front\", \"edge\": 5}]",
                "[{\"panel\": \"back\", \"edge\": 5}, {\"panel\": \"front\", \"edge\": 5}, \"right_wrong\"]");
  const Done done = import(json);
  ASSERT_EQ(done.code, 0) << done.text;
  const Scene scene = scene_of();
  EXPECT_FALSE(scene.seams[0].side[1].reverse);
  expect_ends_meet(scene);
}

// Lengths of edges: chords within b/1000 of a curve of curvature k are shorter than it by k b/3000 of its
// length (chord h: sagitta k h^2/8, shorter by (k h)^2/24). Closed forms, m: the arc 2 r asin(c/2r); the
// parabola with control point 0.5, h: with q = 4 h/2 (slope at the end), c/2 [sqrt(1 + q^2) + asinh(q)/q];
// the cubic by Simpson's rule of its derivative.
TEST_F(Import, KeepsTheLengthsOfCurves) {
  ASSERT_EQ(import(kTunic).code, 0);
  const Scene scene = scene_of();
  const auto length = [&](int piece, int edge) {
    return seam::seam_length(piece::outline_edge(scene.pieces[std::size_t(piece)], edge));
  };
  const double b = 0.01, arc = 2 * 0.5 * std::asin(0.6 / (2 * 0.5));
  for (const auto& [piece, edge] : {std::pair{0, 0}, {1, 7}}) {
    EXPECT_LE(length(piece, edge), arc + 1e-7);
    EXPECT_GE(length(piece, edge), arc * (1 - 2 * b / 3000) - 1e-7);
  }
  for (const auto& [piece, edge, h] : {std::tuple{0, 4, 0.9}, {1, 3, 0.3}}) {
    const double c = 0.16, q = 2 * h, parabola = c / 2 * (std::sqrt(1 + q * q) + std::asinh(q) / q);
    EXPECT_LE(length(piece, edge), parabola + 1e-7);
    EXPECT_GE(length(piece, edge), parabola * (1 - 4 * h / c * b / 3000) - 1e-7);  // curvature at most 4 h/c
  }
  const Vec2 p[4] = {{0, 0}, {0.2, 0.35}, {0.5, 0.2}, {1, 0}};
  double cubic = 0, bend = 0;
  const int n = 2000;
  for (int i = 0; i <= n; ++i) {
    const double t = double(i) / n, s = 1 - t;
    Vec2 d, e;
    for (std::size_t a = 0; a < 2; ++a) {
      d[a] =
          3 * (s * s * (p[1][a] - p[0][a]) + 2 * s * t * (p[2][a] - p[1][a]) + t * t * (p[3][a] - p[2][a]));
      e[a] = 6 * (s * (p[2][a] - 2 * p[1][a] + p[0][a]) + t * (p[3][a] - 2 * p[2][a] + p[1][a]));
    }
    const double speed = std::hypot(d[0], d[1]);
    cubic += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * speed / (3 * n);
    bend = std::max(bend, std::abs(d[0] * e[1] - d[1] * e[0]) / std::pow(speed, 3));
  }
  const double chord = std::hypot(0.10, 0.23);
  for (const auto& [piece, edge] : {std::pair{0, 2}, {0, 6}, {1, 1}, {1, 5}}) {
    EXPECT_LE(length(piece, edge), cubic * chord + 1e-7);
    EXPECT_GE(length(piece, edge), cubic * chord * (1 - bend / chord * b / 3000) - 1e-7);
  }
  EXPECT_NEAR(length(0, 1), 0.55, 1e-9);
  EXPECT_NEAR(length(0, 3), std::hypot(0.12, 0.02), 1e-8);
  // The hem hangs below the chord; the neck is cut into the cloth.
  EXPECT_LT(piece::outline_edge(scene.pieces[0], 0)[3][1], 0);
  EXPECT_LT(piece::outline_edge(scene.pieces[0], 4)[3][1], 0.8);
}

// P = s + p0 (e - s) + p1 perp: the same control points as points of the panel.
TEST_F(Import, TakesControlPointsEitherWay) {
  ASSERT_EQ(import(kTunic).code, 0);
  const Scene relative = scene_of();
  std::string json =
      edited(kTunic, "\"curvature_coords\": \"relative\"", "\"curvature_coords\": \"absolute\"");
  json = edited(json, "[0.5, 0.9]", "[0, 65.6]");       // (8, 80) + (-8, 0) + 0.9 (0, -16)
  json = edited(json, "[[0.5, -0.3]]", "[[0, 75.2]]");  // (-8, 80) + (8, 0) - 0.3 (0, 16)
  json = edited(json, "[[0.2, 0.35], [0.5, 0.2]]", "[[19.95, 56.1], [20.4, 64.5]]");
  json = edited(json, "[[0.5, 0.2], [0.8, 0.35]]", "[[-20.4, 64.5], [-19.95, 56.1]]");
  json = edited(json, "[[0.2, -0.35], [0.5, -0.2]]", "[[-19.95, 56.1], [-20.4, 64.5]]");
  json = edited(json, "[[0.5, -0.2], [0.8, -0.35]]", "[[20.4, 64.5], [19.95, 56.1]]");
  const Done done = import(json);
  ASSERT_EQ(done.code, 0) << done.text;
  const Scene absolute = scene_of();
  for (std::size_t p = 0; p < 2; ++p) {
    ASSERT_EQ(relative.pieces[p].curves.size(), 4u);
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t k = 0; k < relative.pieces[p].curves[c].bezier.size(); ++k)
        for (std::size_t a = 0; a < 2; ++a)
          EXPECT_NEAR(relative.pieces[p].curves[c].bezier[k][a], absolute.pieces[p].curves[c].bezier[k][a],
                      2e-8);
  }
}

TEST_F(Import, RunsAsItIs) {
  ASSERT_EQ(import(kTunic, "--cell 0.03").code, 0);
  EXPECT_EQ(drape("check tunic.toml").code, 0);
  const Done run = drape("run tunic.toml -o out --until 0.02");
  EXPECT_EQ(run.code, 0);  // it was to end before the scene's duration
  EXPECT_NE(run.text.find("the fit has not come to rest"), std::string::npos) << run.text;
  const std::string text = text_of("tunic.toml");
  EXPECT_NE(text.find("  [-0.3, 0],  # edge 0 (hem front)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  [0.3, 0],  # edge 1, sewn to edge 6 of back\n"), std::string::npos) << text;
}

TEST_F(Import, PutsAWoolBesideTheSceneButNeverOverAnother) {
  ASSERT_EQ(import(kTunic).code, 0);
  EXPECT_NE(text_of("tunic.toml").find("file = \"wool.toml\""), std::string::npos);
  const std::string wool = text_of("wool.toml");
  EXPECT_NE(wool.find("areal_density"), std::string::npos);
  write("wool.toml", wool + "\n# mine\n");
  const Done done = import(kTunic);
  EXPECT_EQ(done.code, 0);
  EXPECT_NE(done.text.find("as it was there"), std::string::npos) << done.text;
  EXPECT_EQ(text_of("wool.toml"), wool + "\n# mine\n");
}

TEST_F(Import, TakesAFabricFromElsewhere) {
  fs::create_directory(folder / "mill");
  ASSERT_EQ(import(kTunic).code, 0);
  fs::rename(folder / "wool.toml", folder / "mill" / "3rd twill.toml");
  ASSERT_EQ(drape("import tunic.json --fabric 'mill/3rd twill.toml' -o scenes/tunic.toml").code, 0);
  EXPECT_FALSE(fs::exists(folder / "scenes" / "wool.toml"));
  const Scene scene = scene_of("scenes/tunic.toml");
  EXPECT_NE(text_of("scenes/tunic.toml").find("file = \"../mill/3rd twill.toml\""), std::string::npos);
  EXPECT_EQ(scene.fabrics[0].name, "fabric_3rd_twill");
  EXPECT_GT(scene.fabrics[0].areal_density, 0);
}

// The height distinguishes centimetres and metres.
TEST_F(Import, MeasuresTheBody) {
  write("cm.obj", "v 0 0 0\nv 10 170 0\nv 0 170 10\nf 1 2 3\n");
  Done done = import(kTunic, "--body cm.obj");
  ASSERT_EQ(done.code, 0) << done.text;
  EXPECT_NE(text_of("tunic.toml").find("[[body]]\nname = \"body\"\nmesh = \"cm.obj\"\nscale = 0.01\n"),
            std::string::npos)
      << text_of("tunic.toml");
  EXPECT_NE(text_of("tunic.toml").find("gravity = [0, -9.81, 0]"), std::string::npos);
  write("m.obj", "v 0 0 0\nv 0.1 1.7 0\nv 0 1.7 0.1\nf 1 2 3\n");
  ASSERT_EQ(import(kTunic, "--body m.obj").code, 0);
  EXPECT_NE(text_of("tunic.toml").find("mesh = \"m.obj\"\n\n"), std::string::npos);
}

TEST_F(Import, RefusesBadBodies) {
  write("tunic.json", kTunic);
  const std::string line = "import tunic.json -o tunic.toml --body ";
  expect_refused(line + "none.obj", {"none.obj: there is no such file"});
  write("empty.obj", "# nothing\n");
  expect_refused(line + "empty.obj", {"empty.obj: holds 0 vertices and 0 faces"});
  write("words.obj", "v 0 0 0\nv one 2 3\nf 1 1 1\n");
  expect_refused(line + "words.obj", {"words.obj:2: is no vertex"});
  write("nan.obj", "v 0 0 0\nv nan 1 0\nv 0 1.7 1\nf 1 2 3\n");
  expect_refused(line + "nan.obj", {"nan.obj:2: is no vertex"});
  write("infinite.obj", "v 0 0 0\nv 1e400 1 0\nv 0 1.7 1\nf 1 2 3\n");
  expect_refused(line + "infinite.obj", {"infinite.obj:2: is no vertex"});
  write("giant.obj", "v 0 0 0\nv 0 17000 0\nv 1 0 0\nf 1 2 3\n");
  expect_refused(line + "giant.obj", {"giant.obj: is 17000 high along y; allowed: 0.3 to 3 m"});
}

TEST_F(Import, RefusesBadFilesAndOptions) {
  write("tunic.json", kTunic);
  expect_refused("import none.json -o a.toml", {"none.json: there is no such file"});
  expect_refused("import . -o a.toml", {".: is a folder, not a file"});
  expect_refused("import tunic.json -o tunic.json", {"--output is tunic.json, which is read from"});
  expect_refused("import tunic.json -o a.toml --cell 0", {"--cell = 0 m; allowed: above 0, at most 10 m"});
  expect_refused("import tunic.json -o a.toml --fabric none.toml", {"none.toml: there is no such file"});
  expect_refused("import tunic.json", {"--output is required"});
  write("cut.json", "{\"pattern\": ");
  expect_refused("import cut.json -o a.toml", {"cut.json: is not valid JSON"});
  // Faults that only the outlines show, on both panels: cells wider than the panels.
  const Done done = drape("import tunic.json -o a.toml --cell 0.7");
  EXPECT_EQ(done.code, 1);
  for (const char* piece : {"front", "back"})
    EXPECT_NE(
        done.text.find(std::string("error: tunic.json: piece.") + piece + ".cell = 0.7 m; allowed: at most"),
        std::string::npos)
        << done.text;
}

TEST_F(Import, ReportsEveryFaultAtOnce) {
  expect_faults("[]", {"is a list [...]; wanted: an object {...}"});
  expect_faults("{}", {"properties is missing; wanted: an object {...}",
                       "pattern is missing; wanted: an object {...}"});
  std::string json = edited(kTunic, "\"units_in_meter\": 100", "\"units_in_meter\": \"cm\"");
  json = edited(json, "\"relative\"", "\"polar\"");
  json = edited(json, "[\"front\", \"back\"]", "[\"front\", \"front\", \"sleeve\"]");
  json = edited(json, "\"panel\": \"front\", \"edge\": 1", "\"panel\": \"frnot\", \"edge\": 1");
  json = edited(json, "\"panel\": \"back\", \"edge\": 4", "\"panel\": \"back\", \"edge\": 8");
  json = edited(json, "\"panel\": \"front\", \"edge\": 5", "\"panel\": \"front\", \"edge\": 3");
  json = edited(json, "{\"endpoints\": [7, 0]}]", "{\"endpoints\": [7, 9]}]");
  json = edited(json, "[7, 0], \"curvature\": {\"type\": \"circle\"",
                "[7, 0], \"curvature\": {\"type\": \"helix\"");
  expect_faults(json, {"properties.units_in_meter is a text; wanted: a number",
                       "properties.curvature_coords = \"polar\"; allowed: \"relative\", \"absolute\"",
                       "pattern.panel_order[1] = \"front\" stands there twice",
                       "pattern.panel_order[2] = \"sleeve\" is no panel of the pattern",
                       "pattern.panels.front.edges[7].endpoints[1] = 9; allowed: 0 to 7",
                       // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one message, on two lines
                       "pattern.panels.back.edges[7].curvature.type = \"helix\"; allowed: \"quadratic\", "
                       "\"cubic\", \"circle\"",
                       "pattern.stitches[0][0].panel = \"frnot\" is no panel of the pattern",
                       "pattern.stitches[1][1].edge = 8; allowed: 0 to 7",
                       "pattern.stitches[2][1] sews edge 3 of \"front\", which pattern.stitches[1][0] sews "
                       "already; an edge belongs "
                       "to one seam"});
}

TEST_F(Import, ReportsWhatIsWrongWithAPanel) {
  expect_faults(
      edited(kTunic, "{\"endpoints\": [0, 1]}", "{\"endpoints\": [0, 2]}"),
      {"pattern.panels.back.edges[1] starts at vertex 1; wanted: vertex 2, where edge 0 ends: the edges do "
       "not close a loop"});
  expect_faults(
      edited(kTunic, "[50, 0, 1]", "[29, 0, 2]"),
      {"pattern.panels.front.edges[0].curvature.params[2] = 2; allowed: 0 or 1",
       "pattern.panels.front.edges[0].curvature.params[0] = 29; allowed: at least 30, half the chord of the "
       "edge"});
  expect_faults(edited(kTunic, "[[0.5, -0.3]]", "[[0.5, -0.3], [1]]"),
                {"pattern.panels.back.edges[3].curvature.params has 2 entries; wanted: 1 control points of a "
                 "quadratic curve"});
  expect_faults(edited(kTunic, "[0, 60, 20]", "[0, 60]"),
                {"pattern.panels.front.translation has 2 entries; wanted: 3"});
  std::string json = kTunic;
  const std::size_t from = json.find("\"edges\""), to = json.find("\"front\": {");
  json.replace(from, to - from, "\"edges\": [{\"endpoints\": [0, 1]}, {\"endpoints\": [1, 0]}]}, ");
  expect_faults(json, {"pattern.panels.back.edges has 2 entries; allowed: at least 3 edges",
                       "pattern.stitches[0][1].edge = 6; allowed: 0 to 1",
                       "pattern.stitches[1][1].edge = 4; allowed: 0 to 1",
                       "pattern.stitches[2][0].edge = 2; allowed: 0 to 1"});
}

// Texts with random bytes and words: each gives a scene that passes its checks, or reports what is wrong.
TEST_F(Import, SurvivesAnyText) {
  const std::vector<std::string> words = {"null", "[]",        "{}",   "-1",       "1e9",        "1e999",
                                          "0.5",  "\"\"",      "true", "[[0, 1]]", "\"circle\"", "\"cubic\"",
                                          "7",    "[0, 0, 0]", ",",    "}"};
  std::uint64_t state = 1;
  const auto below = [&](std::size_t n) {  // Knuth's MMIX generator
    state = state * 6364136223846793005u + 1442695040888963407u;
    return std::size_t(state >> 33) % n;
  };
  int valid = 0;
  for (int k = 0; k < 3000; ++k) {
    std::string text = kTunic;
    for (std::size_t edit = 1 + below(2); edit-- > 0;) {
      const std::size_t at = text.find_first_of("[{\"-0123456789", below(text.size()));
      if (at == std::string::npos) continue;
      const std::size_t end = text.find_first_of(",]}:", at + 1);
      text.replace(at, below(3) ? end - at : 1, words[below(words.size())]);
    }
    write("any.json", text);
    std::vector<Problem> problems;
    const Pattern pattern = pattern_read(folder / "any.json", problems);
    if (problems.empty()) {
      const Scene scene = garment_scene(pattern, {}, {});
      validation::scene_check(scene, problems);
      valid += problems.empty();
      EXPECT_FALSE(garment_text(scene, pattern, {}).empty());
    }
    for (const Problem& p : problems) EXPECT_FALSE(p.place.empty() || p.message.empty()) << text;
  }
  EXPECT_GT(valid, 0);
}

}  // namespace
}  // namespace drape::command
