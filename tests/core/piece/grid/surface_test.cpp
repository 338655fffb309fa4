// The polygons of a piece: at rest their union is the piece.
#include "piece/grid/surface.h"

#include <cmath>

#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

// The position of a corner at rest.
Vec2 corner_at(const Grid& grid, const Surface& surface, int corner) {
  if (corner < grid.nodes()) return grid.place(corner);
  const GridPoint& point = surface.points[std::size_t(corner - grid.nodes())];
  Vec2 at{0, 0};
  for (int k = 0; k < 4; ++k)
    for (std::size_t a = 0; a < 2; ++a) at[a] += point.weight[k] * grid.place(point.node[k])[a];
  return at;
}

// Corners by their position, to 1e-9 m: no two are at one position.
std::map<std::pair<long, long>, int> corners_by_place(const Grid& grid, const Surface& surface) {
  std::map<std::pair<long, long>, int> corner_in;
  for (const int corner : surface.corner) {
    const Vec2 at = corner_at(grid, surface, corner);
    const auto place = std::pair{std::lround(1e9 * at[0]), std::lround(1e9 * at[1])};
    EXPECT_EQ(corner_in.emplace(place, corner).first->second, corner) << at[0] << ' ' << at[1];
  }
  return corner_in;
}

std::vector<std::vector<Vec2>> polygons_of(const Grid& grid, const Surface& surface) {
  std::vector<std::vector<Vec2>> polygons;
  int begin = 0;
  for (const int end : surface.end) {
    polygons.emplace_back();
    for (; begin < end; ++begin)
      polygons.back().push_back(corner_at(grid, surface, surface.corner[std::size_t(begin)]));
  }
  EXPECT_EQ(begin, int(surface.corner.size()));
  return polygons;
}

// The sum of the areas, each of them positive.
double area_of(const std::vector<std::vector<Vec2>>& polygons) {
  double sum = 0;
  for (const std::vector<Vec2>& polygon : polygons) {
    EXPECT_GE(polygon.size(), 3u);
    EXPECT_GT(polygon_area(polygon), 0);
    sum += polygon_area(polygon);
  }
  return sum;
}

// Concave, with a curved edge, a dart that ends within a cell and a round hole, at a grain of 20 degrees.
scene::PieceSpec bodice() {
  scene::PieceSpec piece = piece_of(
      {{0, 0}, {0.2, 0}, {0.2, 0.16}, {0.124, 0.16}, {0.1213, 0.083}, {0.121, 0.16}, {0.07, 0.1}, {0, 0.15}},
      0.01);
  piece.grain = 20 * std::numbers::pi / 180;
  piece.curves.push_back({1, {{0.17, 0.08}}});
  std::vector<Vec2> hole;
  for (int k = 0; k < 40; ++k)
    hole.push_back({0.06 + 0.02 * std::cos(k * std::numbers::pi / 20),
                    0.05 + 0.02 * std::sin(k * std::numbers::pi / 20)});
  piece.holes = {hole};
  return piece;
}

// Coordinates of 0.2 m carry 3e-17 m: over a rim of 1 m that is 1e-15 of the area of 0.03 m2.
TEST(Surface, IsThePieceAtRest) {
  const scene::PieceSpec piece = bodice();
  const Grid grid = grid_make(scene_of(piece), 0);
  const Surface surface = surface_make(grid);
  const double area = outline_area(outline_flatten(piece));
  EXPECT_NEAR(area_of(polygons_of(grid, surface)) / area, 1, 1e-12);
  EXPECT_GT(grid.twin.size(), 0u);  // along the dart
  std::size_t whole = 0;
  for (const GridCell& c : grid.cells) whole += !grid_is_cut(grid, c.i, c.j);
  EXPECT_EQ(surface.end.size(), whole + grid.parts.size());  // no part has a hole of its own
}

// For any piece: 1e-12 of a cell at coordinates of up to 60 m (grid_test), at every point of the rim.
TEST(Surface, HasTheAreaOfAnyPiece) {
  RandomPiece random(20);
  for (int k = 0; k < 200; ++k) {
    const scene::PieceSpec piece = k % 2 ? random.piece() : random.snapped_piece();
    Scene scene = scene_of(piece);
    if (k % 5 == 0) scene.outline = scene::OutlineModel::kPaper;
    const Grid grid = grid_make(scene, 0);
    if (grid.cells.empty()) continue;
    double sum = 0;
    for (const std::vector<Vec2>& polygon : polygons_of(grid, surface_make(grid)))
      sum += polygon_area(polygon);
    EXPECT_NEAR(sum / outline_area(outline_flatten(piece)), 1, 1e-9) << k;
  }
}

// Holes within a cell, several in one: their part is divided into polygons without holes.
TEST(Surface, OpensHolesWithinACell) {
  scene::PieceSpec piece = rectangle(0, 0, 0.05, 0.04, 0.01);
  const auto hole = [](double x, double y, double size) {
    return std::vector<Vec2>{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  };
  piece.holes = {hole(0.012, 0.012, 0.002), hole(0.0165, 0.0125, 0.001), hole(0.0125, 0.0165, 0.002),
                 hole(0.033, 0.023, 0.004)};
  const Grid grid = grid_make(scene_of(piece), 0);
  ASSERT_EQ(grid.parts.size(), 2u);
  const std::vector<std::vector<Vec2>> polygons = polygons_of(grid, surface_make(grid));
  EXPECT_NEAR(area_of(polygons), 0.002 - 25e-6, 1e-15);
  EXPECT_GE(polygons.size(), 18u + 8u);
  for (const std::vector<Vec2>& h : piece.holes) {
    const Vec2 middle{(h[0][0] + h[2][0]) / 2, (h[0][1] + h[2][1]) / 2};
    for (const std::vector<Vec2>& polygon : polygons) EXPECT_GT(polygon_distance(polygon, middle), 0);
  }
}

// The lines that open holes are no lines of the grid, and their polygons are rotated there and back: where
// two polygons meet there is still one corner. Two holes at random positions in each of many cells.
TEST(Surface, JoinsThePolygonsOfOpenedHoles) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(0.0005, 0.0035), size(0.0003, 0.0006);
  scene::PieceSpec piece = rectangle(0, 0, 0.2, 0.1, 0.01);
  for (int k = 0; k < 400; ++k) {
    const double r = size(random), q = size(random);
    const int row = k / 40;
    const double x = 0.01 * (k / 2 % 20) + 0.005 * (k % 2) + at(random) + 0.0005;
    const double y = 0.01 * row + 2 * at(random) + 0.001;
    piece.holes.push_back({{x + r, y}, {x, y + q}, {x - q, y}, {x, y - r}});
  }
  const Grid grid = grid_make(scene_of(piece), 0);
  const Surface surface = surface_make(grid);
  EXPECT_GE(surface.end.size(), grid.parts.size() + 800);
  corners_by_place(grid, surface);
}

// Neighbours share their corners, beside merged parts too: one corner at each position, and every side
// belongs to two polygons or to the rim.
TEST(Surface, HasNoCracks) {
  for (const scene::OutlineModel outline : {scene::OutlineModel::kCutCell, scene::OutlineModel::kPaper}) {
    scene::PieceSpec piece = piece_of({}, 0.01);
    for (int k = 0; k < 90; ++k)
      piece.outline.push_back(
          {0.1 * std::cos(k * std::numbers::pi / 45), 0.08 * std::sin(k * std::numbers::pi / 45)});
    piece.grain = 0.3;
    Scene scene = scene_of(piece);
    scene.outline = outline;
    const Grid grid = grid_make(scene, 0);
    ASSERT_TRUE(grid.twin.empty());
    const Surface surface = surface_make(grid);
    const auto corner_in = corners_by_place(grid, surface);
    std::map<std::pair<int, int>, int> uses;
    std::size_t begin = 0;
    for (const int end : surface.end) {
      const std::size_t stop = std::size_t(end);
      for (std::size_t k = begin; k < stop; ++k) {
        const int p = surface.corner[k], q = surface.corner[k + 1 < stop ? k + 1 : begin];
        ++uses[{std::min(p, q), std::max(p, q)}];
      }
      begin = stop;
    }
    int rim = 0;
    for (const auto& [side, count] : uses) {
      EXPECT_LE(count, 2);
      rim += count == 1;
    }
    int expected = 90;  // its points, and where it crosses lines of the grid
    for (const auto& [place, corner] : corner_in) {
      const Vec2 at = grid_coordinates(grid, corner_at(grid, surface, corner));
      const bool on_line = at[0] == std::floor(at[0]) || at[1] == std::floor(at[1]);
      expected += on_line && corner >= grid.nodes();
    }
    EXPECT_EQ(rim, expected);
  }
}

}  // namespace
}  // namespace drape::piece
