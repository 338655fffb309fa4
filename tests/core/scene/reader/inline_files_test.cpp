// The text with its files inlined needs no other file, and reading it gives the same scene, bit for bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <random>

#include "scene_file.h"

namespace drape::scene {

using namespace tests;
namespace {

// All numbers of a scene in one list, in a fixed order.
std::vector<double> numbers_of(const Scene& s) {
  std::vector<double> n{s.duration, s.step,           s.communication,
                        s.damping,  double(s.energy), double(s.clamp_correction)};
  n.insert(n.end(), {double(s.integrator), double(s.scaling), double(s.bias_model), double(s.outline),
                     double(s.order)});
  n.insert(n.end(), {double(s.mode), double(s.has_air), s.air_density, s.air_normal, s.air_tangential,
                     s.imperfection_amplitude, double(s.imperfection_seed)});
  const auto put = [&](const auto& list) { n.insert(n.end(), list.begin(), list.end()); };
  put(s.gravity), put(s.wind);
  for (const FabricSpec& f : s.fabrics) {
    n.insert(n.end(), {f.areal_density, f.thickness, f.strip_width, f.strip_gauge, f.bending_warp,
                       f.bending_weft, f.poisson, f.compression, f.compression_blend, f.damping});
    put(f.friction);
    for (const DiagramSpec* d : {&f.warp, &f.weft, &f.bias})
      n.push_back(double(d->jaws)), put(d->elongation), put(d->force), put(d->correction);
  }
  for (const PieceSpec& p : s.pieces) {
    n.insert(n.end(), {double(p.fabric), p.cell, p.grain, double(p.grid_origin.has_value())});
    put(p.grid_origin.value_or(Vec2{0, 0}));
    for (const Vec2& v : p.outline) put(v);
    for (const CurveSpec& c : p.curves) {
      n.insert(n.end(), {double(c.edge), c.radius, double(c.large), double(c.right)});
      for (const Vec2& v : c.bezier) put(v);
    }
    for (const std::vector<Vec2>& hole : p.holes) {
      n.push_back(double(hole.size()));
      for (const Vec2& v : hole) put(v);
    }
    put(p.velocity), put(p.place.origin), put(p.place.axis_x), put(p.place.axis_y);
    put(p.place.axis_point), put(p.place.axis), put(p.place.radius);
  }
  for (const PinSpec& p : s.pins) {
    n.insert(n.end(), {double(p.piece), double(p.clamp), double(p.drive)});
    for (const Vec2& v : p.at) put(v);
    for (const Vec2& v : p.region) put(v);
    for (int e : p.edges) n.push_back(e);
  }
  for (const ProbeSpec& p : s.probes) n.push_back(p.piece), put(p.at);
  return n;
}

std::string names_of(const Scene& s) {
  std::string text = s.name;
  for (const FabricSpec& f : s.fabrics) text += "/" + f.name;
  for (const PieceSpec& p : s.pieces) text += "/" + p.name;
  for (const PinSpec& p : s.pins) text += "/" + p.name;
  for (const ProbeSpec& p : s.probes) text += "/" + p.name;
  return text;
}

void expect_round_trip(const std::string& scene, const std::string& fabric) {
  const SceneFolder folder, elsewhere;
  folder.write("wool.toml", fabric);
  const std::filesystem::path file = folder.write("scene.toml", scene);
  std::vector<Problem> problems;
  const Scene first = validation::scene_load(file, problems);
  const std::string text = scene_inline_files(file, problems);
  const Scene second = validation::scene_load(elsewhere.write("scene.toml", text), problems);
  for (const Problem& p : problems) ADD_FAILURE() << problem_text(p) << '\n' << text;

  const std::vector<double> a = numbers_of(first), b = numbers_of(second);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0) << text;
  EXPECT_EQ(names_of(first), names_of(second));
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(InlineFiles, StandsAlone) {
  expect_round_trip(kScene, kFabric);
  expect_round_trip(kCloth, kFabric);
}

// Data sheets become plain keys: nothing remains to be converted, on whatever machine the text is read.
TEST(InlineFiles, SheetsBecomePlainKeys) {
  const std::string own = "areal_density = 0.2\nwarp.force = [0, 3, 9]\n", scene = with(kScene, own, "");
  for (const std::string& fabric : {kKes, kFast, kStrips, kPt2}) {
    expect_round_trip(scene, fabric);
    expect_round_trip(
        with(scene, "file = \"wool.toml\"\n", "file = \"wool.toml\"\nbending.length_mm = 17.3\n"), fabric);
    const SceneFolder folder;
    folder.write("wool.toml", fabric);
    std::vector<Problem> problems;
    const std::string text = scene_inline_files(folder.write("scene.toml", scene), problems);
    for (const char* key : {"kes", "fast", "gost_10550", "_mm", "_in", "force_", "ASTM"})
      EXPECT_EQ(text.find(key), std::string::npos) << key << '\n' << text;
  }
  expect_round_trip(with(kScene, own, "kes = { W = 21.7, G = 0.77, B = [0.11, 0.13] }\n"), kFabric);
}

TEST(InlineFiles, AwkwardNumbersKeepTheirBits) {
  std::string scene = with(kScene, "[0, 0.5, -9.81]", "[1e-320, -0.0, 0.30000000000000004]");
  scene = with(scene, "damping = 0.25", "damping = 0.3333333333333333");
  scene = with(scene, "[0, 3, 9]", "[0, 4.9406564584124654e-324, 2.2250738585072014e-308]");
  scene = with(scene, "axis_x = [1, 0, 0]", "axis_x = [0.9999999, 0.0000003, 0]");
  std::string fabric = with(kFabric, "[1, 0.9, 0.95]", "[0.1, 0.7000000000000001, 1.1e-3]");
  fabric = with(fabric, "[0, 3, 6]", "[0, 0.048610000000000004, 0x10]");
  expect_round_trip(scene, fabric);
}

TEST(InlineFiles, RandomBitsSurvive) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::string force = "[0";
    double last = 0;
    for (int k = 0; k < 2; ++k) {
      last += std::ldexp(std::uniform_real_distribution<>(1, 2)(random), int(random() % 60) - 50);
      char text[32];
      std::snprintf(text, sizeof text, ", %.17g", last);
      force += text;
    }
    expect_round_trip(with(kScene, "[0, 3, 9", force), kFabric);
  }
}

TEST(InlineFiles, TextOfAnyKindSurvives) {
  expect_round_trip(kScene, with(kFabric, "\"made up\"", R"("""a "quoted" \\ back\u0007 'slash'
second line \"\"\" \t end é"""
)"));
}

// A correction belongs to the points for which it was found. Forces given in a scene keep the corrections of
// the file, as tuned ones do; elongations do not.
TEST(SceneRead, DiagramsOfItsOwnDoNotTakeTheFilesCorrections) {
  const std::string begin = "[scene]\nname = \"a\"\n[fabric.f]\nfile = \"f.toml\"\nwarp = { ";
  const std::string end =
      " }\n[[piece]]\nname = \"p\"\nfabric = \"f\"\ncell = 0.1\noutline = [[0, 0], [1, 0], [1, 1], [0, 1]]\n";
  const SceneFolder folder;
  folder.write(
      "f.toml",
      "areal_density = 0.2\nthickness = 0.001\n[warp]\nelongation_percent = [0, 1, 2]\n"
      "force = [0, 6, 15]\ncorrection = [0.9, 0.9, 0.95]\ncorrection_elongation = [1.1, 1.1, 1.2]\n");
  const auto warp = [&](const std::string& keys) {
    std::vector<Problem> problems;
    const Scene scene = validation::scene_load(folder.write("scene.toml", begin + keys + end), problems);
    for (const Problem& p : problems) ADD_FAILURE() << problem_text(p);
    return scene.fabrics.at(0).warp;
  };
  EXPECT_EQ(warp("force = [0, 7, 15]").correction.size(), 3u);
  EXPECT_EQ(warp("force = [0, 7, 15]").correction_elongation.size(), 3u);
  const DiagramSpec own = warp("elongation_percent = [0, 2], force = [0, 9]");
  EXPECT_TRUE(own.correction.empty() && own.correction_elongation.empty());
  EXPECT_EQ(own.force.size(), 2u);
}

}  // namespace
}  // namespace drape::scene
