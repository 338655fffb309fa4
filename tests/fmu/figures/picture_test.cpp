// The picture of a scene's pieces is well-formed and shows all of the grid.
#include "figures/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <pugixml.hpp>

#include "piece/grid/grid.h"
#include "validation/load.h"

namespace drape::figures {
namespace {

// Elements by their class.
std::map<std::string, std::vector<pugi::xml_node>> elements_of(const pugi::xml_document& document) {
  std::map<std::string, std::vector<pugi::xml_node>> found;
  for (const auto& node : document.select_nodes("//*[@class]"))
    found[node.node().attribute("class").value()].push_back(node.node());
  return found;
}

pugi::xml_document picture_of(const Scene& scene) {
  pugi::xml_document document;
  const std::string svg = picture_svg(scene);
  const pugi::xml_parse_result result = document.load_buffer(svg.data(), svg.size());
  EXPECT_TRUE(result) << result.description();
  EXPECT_EQ(std::string(document.document_element().name()), "svg");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  return document;
}

// The numbers of a path, in order: x and y of each of its points. Its commands begin with these.
std::vector<double> numbers_of(const char* path, const std::string& commands) {
  std::vector<double> numbers;
  std::string letters;
  for (const char* at = path; *at;) {
    char* end;
    const double number = std::strtod(at, &end);
    if (end != at) numbers.push_back(number);
    else if (*at != ' ') letters += *at;
    at = end != at ? end : at + 1;
  }
  EXPECT_TRUE(letters.starts_with(commands)) << path;
  return numbers;
}

// Area of a path of straight pieces, in square units of the drawing.
double area_of(const char* path) {
  double twice = 0, first[2] = {}, last[2] = {};
  for (const char* at = path; *at;) {
    const char kind = *at++;
    double next[2] = {first[0], first[1]};
    if (kind != 'Z') {
      char* end;
      next[0] = std::strtod(at, &end);
      next[1] = std::strtod(end, &end);
      at = end;
    }
    if (kind == 'M') first[0] = next[0], first[1] = next[1];
    else twice += last[0] * next[1] - last[1] * next[0];
    last[0] = next[0], last[1] = next[1];
  }
  return std::abs(twice / 2);
}

std::vector<std::string> texts_of(const pugi::xml_document& document) {
  std::vector<std::string> texts;
  for (const auto& node : document.select_nodes("//text")) texts.push_back(node.node().text().get());
  return texts;
}

bool has(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

// Concave, with a curved edge, a dart and a hole, at a grain of 20 degrees; held in every way.
Scene bodice() {
  Scene scene;
  scene::PieceSpec piece;
  piece.name = "front";
  piece.cell = 0.01;
  piece.grain = 20 * std::numbers::pi / 180;
  piece.outline = {{0, 0},          {0.2, 0},      {0.2, 0.16}, {0.124, 0.16},
                   {0.1213, 0.083}, {0.121, 0.16}, {0.07, 0.1}, {0, 0.15}};
  piece.curves.push_back({1, {{0.17, 0.08}}});
  piece.holes = {{{0.04, 0.04}, {0.06, 0.03}, {0.08, 0.05}, {0.05, 0.07}}};
  scene.pieces = {piece};
  scene.pins = {{"bar", 0, {}, {0}, {}, true, scene::Drive::kNone},
                {"peg", 0, {{0, 0.15}, {0.07, 0.1}}, {}, {}, false, scene::Drive::kVelocity},
                {"palm", 0, {}, {}, {{0.15, 0.1}, {0.18, 0.1}, {0.18, 0.13}}, false, scene::Drive::kNone}};
  scene.probes = {{"hem", 0, {0.1, 0.02}}};
  return scene;
}

TEST(Picture, ShowsWhatTheGridMakesOfAPiece) {
  const Scene scene = bodice();
  const piece::Grid grid = piece::grid_make(scene, 0);
  const pugi::xml_document document = picture_of(scene);
  auto elements = elements_of(document);
  EXPECT_EQ(elements["part"].size(), grid.parts.size());
  ASSERT_GT(grid.twin.size(), 0u);
  EXPECT_EQ(elements["twin"].size(), grid.twin.size() + 1);  // one more in the legend
  std::size_t particles = 0, whole = 0, merged = 0;
  for (const double a : grid.area) particles += a > 0;
  for (const piece::GridCell& c : grid.cells) {
    whole += !piece::grid_is_cut(grid, c.i, c.j);
    merged += !piece::grid_is_cut(grid, c.i, c.j) && c.share > 1;
  }
  EXPECT_EQ(elements["taker"].size(), merged);
  const std::vector<std::string> texts = texts_of(document);
  for (const std::string& text : {std::string("front"), std::string("warp"), std::string("5 cm"),
                                  "cell 10 mm, " + std::to_string(particles) + " particles"})
    EXPECT_TRUE(has(texts, text)) << text;

  // The parts and the whole cells are the cloth. Rounding to 0.01 moves sides of some 20 units by at most
  // 0.005 each: 0.1 of the 400 square units of a part.
  const std::vector<double> scale = numbers_of(elements["scale"][0].attribute("d").value(), "MLLL");
  ASSERT_GE(scale.size(), 8u);  // its path goes left, left, left, right, ...
  const double cell = std::pow(0.01 / 0.05 * (scale[6] - scale[0]), 2);
  double parts = 0;
  for (const pugi::xml_node part : elements["part"]) parts += area_of(part.attribute("d").value());
  const double cloth = area_of(elements["outline"][0].attribute("d").value());
  EXPECT_NEAR((parts + double(whole) * cell) / cloth, 1, 1e-3);
}

TEST(Picture, DistinguishesPinsClampsAndDrivenOnes) {
  const Scene scene = bodice();
  const pugi::xml_document document = picture_of(scene);
  const auto pin = [&](const std::string& title, const std::string& kind) {
    const std::string query = "//g[@class='pin'][title='" + title + "']//*[@class='" + kind + "']";
    return document.select_nodes(query.c_str());
  };
  EXPECT_EQ(pin("pin bar, clamp", "edge").size(), 1u);
  EXPECT_EQ(pin("pin bar, clamp", "ticks").size(), 1u);
  EXPECT_EQ(pin("pin bar, clamp", "drive").size(), 0u);
  EXPECT_EQ(pin("pin peg, driven by velocity", "point").size(), 2u);
  const pugi::xml_node point = pin("pin peg, driven by velocity", "point")[0].node();
  EXPECT_EQ(std::string(point.attribute("fill").value()), "#ffffff");
  EXPECT_EQ(pin("pin peg, driven by velocity", "drive").size(), 2u);  // and its rim
  EXPECT_EQ(pin("pin palm", "region").size(), 1u);
  EXPECT_EQ(pin("pin palm", "held").size(), 1u);
  EXPECT_EQ(document.select_nodes("//g[@class='probe'][title='probe hem']").size(), 1u);
  const std::vector<std::string> texts = texts_of(document);
  for (const char* text : {"bar", "peg", "palm", "hem", "pin: points, edges, region", "driven pin"})
    EXPECT_TRUE(has(texts, text)) << text;
}

// The warp points to the upper left at a positive grain. Pieces that do not fit side by side are in rows.
TEST(Picture, PlacesPiecesInRows) {
  Scene scene = bodice();
  scene.pins.clear();
  for (int k = 0; k < 4; ++k) scene.pieces.push_back(scene.pieces[0]);
  const pugi::xml_document document = picture_of(scene);
  auto elements = elements_of(document);
  ASSERT_EQ(elements["warp"].size(), 5u);
  const std::vector<double> warp = numbers_of(elements["warp"][0].attribute("d").value(), "ML");
  ASSERT_GE(warp.size(), 4u);  // from (x0, y0) to (x1, y1)
  EXPECT_NEAR((warp[0] - warp[2]) / (warp[1] - warp[3]), std::tan(20 * std::numbers::pi / 180), 1e-2);
  EXPECT_GT(warp[1], warp[3]);
  std::map<double, int> rows;
  for (const pugi::xml_node outline : elements["outline"]) {
    const std::vector<double> path = numbers_of(outline.attribute("d").value(), "M");
    ASSERT_GE(path.size(), 2u);
    ++rows[path[1]];
  }
  EXPECT_EQ(rows.size(), 3u);  // two, two and one
  EXPECT_EQ(rows.begin()->second, 2);
}

// Whole cells only: the strip outside them is mass, and no share is shown.
TEST(Picture, ShowsTheStripOfThePaper) {
  Scene scene = bodice();
  scene.outline = scene::OutlineModel::kPaper;
  const piece::Grid grid = piece::grid_make(scene, 0);
  const pugi::xml_document document = picture_of(scene);
  auto elements = elements_of(document);
  ASSERT_EQ(elements["part"].size(), grid.parts.size());
  for (const pugi::xml_node part : elements["part"])
    EXPECT_EQ(std::string(part.child("title").text().get()), "mass only");
  EXPECT_TRUE(has(texts_of(document), "mass only"));
}

// The swatch is pinned along an edge and has one probe.
TEST(Picture, OfASceneFile) {
  std::vector<Problem> problems;
  const pugi::xml_document document =
      picture_of(validation::scene_load(DRAPE_SAMPLES "/swatch.toml", problems));
  ASSERT_TRUE(problems.empty());
  EXPECT_TRUE(has(texts_of(document), "sheet"));
  EXPECT_TRUE(has(texts_of(document), "cell 10 mm, 54 particles"));
  EXPECT_EQ(document.select_nodes("//g[@class='pin']/title[.='pin bar']").size(), 1u);
  EXPECT_EQ(document.select_nodes("//g[@class='probe']/title[.='probe hem']").size(), 1u);
}

}  // namespace
}  // namespace drape::figures
