// Frames as ParaView reads them: the polygons of the first frame are the piece.
#include <cmath>
#include <cstring>
#include <numbers>

#include "command/command_fixture.h"
#include "piece/grid/grid.h"
#include "piece/outline/outline.h"
#include "validation/load.h"

namespace drape::command {
namespace {

// Concave, with a dart and a hole, at a grain of 20 degrees.
const char* kScene = R"([scene]
name = "bodice"
duration = 0.01
[fabric.wool]
areal_density = 0.2
thickness = 0.0006
warp = { elongation_percent = [0, 1, 2, 5], force = [0, 2, 6, 30] }
weft = { elongation_percent = [0, 1, 2, 5], force = [0, 1.5, 4, 20] }
[[piece]]
name = "front"
fabric = "wool"
cell = 0.01
grain = 0.3490658503988659
outline = [[0, 0], [0.2, 0], [0.2, 0.16], [0.124, 0.16], [0.1213, 0.083], [0.121, 0.16], [0.07, 0.1],
           [0, 0.15]]
curves = [{ edge = 1, bezier = [[0.17, 0.08]] }]
holes = [[[0.04, 0.04], [0.06, 0.03], [0.08, 0.05], [0.05, 0.07]]]
place = { origin = [0, 0, 1], axis_x = [1, 0, 0], axis_y = [0, 0, 1] }
[[pin]]
name = "peg"
piece = "front"
at = [[0, 0.15]]
)";

std::size_t number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  EXPECT_NE(at, std::string::npos) << words;
  return at == std::string::npos ? 0 : std::strtoul(text.c_str() + at + words.size(), nullptr, 10);
}

// An array of the appended data.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& name) {
  const std::string head = "Name=\"" + name + "\"", begin = "encoding=\"raw\">\n_";
  const std::size_t offset = number_after(file.substr(file.find(head)), "offset=\"");
  const char* at = file.data() + file.find(begin) + begin.size() + offset;
  std::uint64_t length;
  std::memcpy(&length, at, sizeof length);
  std::vector<T> values(length / sizeof(T));
  std::memcpy(values.data(), at + sizeof length, length);
  return values;
}

TEST_F(Command, FramesFollowTheOutline) {
  std::ofstream(folder / "bodice.toml") << kScene;
  const Done done = drape("run bodice.toml -o out --frames --every 0.005");
  ASSERT_EQ(done.code, 0) << done.text;
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load((folder / "bodice.toml").string().c_str(), problems);
  const piece::Grid grid = piece::grid_make(scene, 0);

  const std::string first = text_of("out/frames/0000.vtp"), last = text_of("out/frames/0002.vtp");
  const auto position = array_of<double>(first, "position");
  const auto corner = array_of<std::int32_t>(first, "connectivity");
  const auto end = array_of<std::int32_t>(first, "offsets");
  EXPECT_EQ(number_after(first, "NumberOfPoints=\""), position.size() / 3);
  EXPECT_EQ(number_after(first, "NumberOfPolys=\""), end.size());
  std::size_t particles = 0;
  for (const double a : grid.area) particles += a > 0;
  EXPECT_GT(position.size() / 3, particles);

  // Upright in the plane y = 0, with its low corner at z = 1. Coordinates of 1 m carry 1e-16 m: 1e-14 of the
  // area.
  double area = 0;
  std::size_t begin = 0;
  for (const std::int32_t stop : end) {
    std::vector<Vec2> polygon;
    for (; begin < std::size_t(stop); ++begin) {
      const double* p = &position[3 * std::size_t(corner[begin])];
      EXPECT_EQ(p[1], 0);
      polygon.push_back({p[0], p[2] - 1});
    }
    EXPECT_GT(piece::polygon_area(polygon), 0);
    area += piece::polygon_area(polygon);
  }
  EXPECT_NEAR(area / piece::outline_area(piece::outline_flatten(scene.pieces[0])), 1, 1e-12);

  // Every corner of the outline is a point. In free fall all points except those near the peg move alike.
  for (const Vec2& p : scene.pieces[0].outline) {
    double nearest = INFINITY;
    for (std::size_t k = 0; k < position.size(); k += 3)
      nearest = std::min(nearest, std::hypot(position[k] - p[0], position[k + 2] - 1 - p[1]));
    EXPECT_LT(nearest, 1e-12);
  }
  const auto there = array_of<double>(last, "position"), velocity = array_of<double>(last, "velocity");
  ASSERT_EQ(there.size(), position.size());
  ASSERT_EQ(velocity.size(), position.size());
  for (std::size_t k = 3 * particles; k < position.size(); k += 3)
    if (position[k] > 0.15) {
      EXPECT_NEAR(velocity[k + 2], -9.81 * 0.01, 1e-3);
      EXPECT_NEAR(there[k + 2] - position[k + 2], -9.81 * 0.01 * 0.01 / 2, 1e-5);
    }
}

}  // namespace
}  // namespace drape::command
