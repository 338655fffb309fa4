// Any text gives a scene or at least one problem, and a scene without problems can be laid out.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "piece/support/support.h"
#include "scene_file.h"

namespace drape::scene {

using namespace tests;
namespace {

// A few random edits: bytes and lines changed, deleted, doubled or swapped; words and numbers from a list
// inserted.
// NOLINTNEXTLINE(readability-function-size): a list of mutations, a few lines each
std::string mutated(std::string text, std::mt19937_64& random) {
  static const std::vector<std::string> kWords = {"nan",
                                                  "inf",
                                                  "-1",
                                                  "0",
                                                  "1e400",
                                                  "1e-320",
                                                  "9223372036854775807",
                                                  "[]",
                                                  "[[]]",
                                                  "{}",
                                                  "\"\"",
                                                  "true",
                                                  "1979-05-27",
                                                  "[[",
                                                  "]]",
                                                  "=",
                                                  "\"",
                                                  "'''",
                                                  ".",
                                                  "[scene]",
                                                  "[[piece]]",
                                                  "[fabric.wool.file]",
                                                  "file = \"wool.toml\"",
                                                  "\\u0000",
                                                  "\n",
                                                  "#"};
  const auto below = [&](std::size_t n) { return n ? std::size_t(random() % n) : 0; };
  for (std::size_t edits = 1 + below(3); edits > 0; --edits) {
    const std::size_t at = below(text.size()), length = std::min(below(12), text.size() - at);
    switch (below(7)) {
      case 0:
        text[at] = char(random());
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(below(text.size()), length));
        break;
      case 3:
        text.replace(at, length, kWords[below(kWords.size())]);
        break;
      case 4: {  // a digit
        const std::size_t digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos) text[digit] = char('0' + below(10));
        break;
      }
      case 5: {  // a value
        const std::size_t equals = text.find("= ", at);
        if (equals == std::string::npos) break;
        const std::size_t end = std::min(text.find('\n', equals), text.size());
        text.replace(equals + 2, end - equals - 2, kWords[below(kWords.size())]);
        break;
      }
      default: {  // a line
        const std::size_t start = text.find('\n', at);
        if (start == std::string::npos) break;
        const std::size_t end = std::min(text.find('\n', start + 1), text.size());
        if (below(2)) text.erase(start, end - start);
        else text.insert(start, text.substr(start, end - start));
      }
    }
    if (text.empty()) text = "#";
  }
  return text;
}

// Everything laid out from a scene stays on its grid.
void expect_laid_out(const Scene& scene, const std::string& text) {
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    const piece::Grid grid = piece::grid_make(scene, int(k));
    std::vector<Vec2> points = scene.pieces[k].outline;
    for (const PinSpec& pin : scene.pins) {
      if (pin.piece != int(k)) continue;
      const std::vector<Vec2> held = piece::support_make(grid, scene, pin).points;
      EXPECT_FALSE(held.empty()) << text;
      points.insert(points.end(), held.begin(), held.end());
    }
    for (const ProbeSpec& probe : scene.probes)
      if (probe.piece == int(k)) points.push_back(probe.at);
    for (const Vec2& p : points) {
      // sum_k w_k r(node k) = p: to the distance at which points snap to grid lines, and the rounding of
      // coordinates, which weights beyond a merged cell's corners enlarge.
      const piece::GridPoint g = piece::grid_locate(grid, p);
      Vec2 off{-p[0], -p[1]};
      double coordinates = grid.cell, weights = 0;
      for (int n = 0; n < 4; ++n) {
        ASSERT_TRUE(grid.area[std::size_t(g.node[n])] > 0) << text;
        const Vec2 node = grid.place(g.node[n]);
        weights += std::abs(g.weight[n]);
        for (std::size_t a = 0; a < 2; ++a)
          off[a] += g.weight[n] * node[a], coordinates = std::max(coordinates, std::abs(node[a]));
      }
      ASSERT_LE(std::hypot(off[0], off[1]), weights * (2e-9 * grid.cell + 1e-14 * coordinates)) << text;
    }
  }
}

TEST(SceneMutation, EndsInASceneOrInProblems) {
  const SceneFolder folder;
  std::mt19937_64 random(2015);
  int good = 0, bad = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const bool in_fabric = trial % 3 == 0;
    const std::string& cloth =
        *std::array{&kFabric, &kKes, &kFast, &kStrips, &kPt2}[std::size_t(trial / 3 % 5)];
    const std::string fabric = in_fabric ? mutated(cloth, random) : kFabric;
    const std::string& whole = trial % 2 ? kScene : kCloth;
    const std::string scene = in_fabric ? whole : mutated(whole, random);
    folder.write("wool.toml", fabric);
    std::vector<Problem> problems;
    const Scene read = validation::scene_load(folder.write("scene.toml", scene), problems);
    for (const Problem& p : problems) {
      EXPECT_FALSE(p.place.empty() || p.message.empty()) << scene << fabric;
      EXPECT_EQ(problem_text(p).find('\n'), std::string::npos) << problem_text(p);
    }
    if (problems.empty()) ++good, expect_laid_out(read, scene);
    else ++bad;
  }
  // Both outcomes occur often enough to be significant.
  EXPECT_GT(good, 100);
  EXPECT_GT(bad, 1000);
  RecordProperty("good", good);
}

}  // namespace
}  // namespace drape::scene
