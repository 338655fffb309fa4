// The cell and the weights of a point: core/README.md, section 1.
#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

// sum w = 1 and sum w X = X: bilinear weights reproduce linear functions, inside a piece, on its rim and
// (extrapolated) in merged parts. Coordinates of up to 60 m in cells of 0.01 m: 1e-12 cells.
TEST(Locate, PointsAreReproduced) {
  RandomPiece random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const scene::PieceSpec piece = random.piece();
    const std::vector<OutlineLoop> loops = outline_flatten(piece);
    Scene scene = scene_of(piece);
    if (trial % 5 == 0) scene.outline = scene::OutlineModel::kPaper;
    const Grid g = grid_make(scene, 0);
    if (g.cells.empty()) continue;
    std::vector<Vec2> points = loops[0].points;
    for (int k = 0; k < 40; ++k)
      if (const Vec2 p{random(-3, 3), random(-3, 3)}; outline_contains(loops, p)) points.push_back(p);
    for (const Vec2& p : points) {
      const GridPoint at = grid_locate(g, p);
      double sum = 0, x = 0, y = 0;
      for (int k = 0; k < 4; ++k) {
        ASSERT_GT(g.area[std::size_t(at.node[k])], 0);  // a particle
        sum += at.weight[k];
        x += at.weight[k] * g.place(at.node[k])[0];
        y += at.weight[k] * g.place(at.node[k])[1];
        if (!g.paper) {
          ASSERT_LE(std::abs(at.weight[k]), 4);  // less than a cell beyond its own cell
        }
      }
      ASSERT_NEAR(sum, 1, 1e-14);
      ASSERT_NEAR(x, p[0], 1e-12);
      ASSERT_NEAR(y, p[1], 1e-12);
    }
  }
}

TEST(Locate, PointsOnGridLinesHaveExactZeros) {
  const Grid g = grid_make(scene_of(rectangle(0.1, 0.2, 0.4, 0.6, 0.01)), 0);
  for (int i = 0; i < g.columns; ++i)
    for (int j = 0; j < g.rows; ++j) {
      const GridPoint at = grid_locate(g, {0.1 + i * 0.01 + 1e-12, 0.2 + j * 0.01 - 1e-12});
      for (int k = 0; k < 4; ++k)
        ASSERT_EQ(at.weight[k], at.node[k] == j * g.columns + i ? 1.0 : 0.0) << i << ' ' << j;
    }
  const GridPoint on_line = grid_locate(g, {0.1 + 7 * 0.01, 0.2 + 3.25 * 0.01});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(on_line.weight[k] != 0, g.index(on_line.node[k])[0] == 7);
}

TEST(Locate, PointBeyondTheNodesOfAMergedCell) {
  const Grid g = grid_make(scene_of(rectangle(0, 0, 2.125, 1, 1)), 0);
  const GridPoint at = grid_locate(g, {2.125, 0.5});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(at.weight[k], (g.index(at.node[k])[0] == 2 ? 1.125 : -0.125) / 2);
}

// Either side of a slit has its own nodes, up to the slit's edges.
TEST(Locate, EitherSideOfASlit) {
  const double w = 1e-6;
  const Grid g = grid_make(
      scene_of(piece_of({{0, 0}, {2.5 - w, 0}, {2.5, 2.5}, {2.5 + w, 0}, {5, 0}, {5, 5}, {0, 5}}, 1)), 0);
  for (const double y : {0.0, 0.3, 1.0, 1.7, 2.2}) {
    const double half = w * (1 - y / 2.5);
    const GridPoint left = grid_locate(g, {2.5 - half, y}), right = grid_locate(g, {2.5 + half, y});
    int common = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        common += left.node[a] == right.node[b] && left.weight[a] != 0 && right.weight[b] != 0;
    // Below y = 1 none is common; the cells above share their upper nodes; the cell at the slit's end is a
    // single one.
    EXPECT_EQ(common, y <= 1 ? 0 : y < 2 ? 2 : 4) << y;
  }
}

// Off the piece by a rounding error, or by a cell: the nearest part.
TEST(Locate, PointsOffThePiece) {
  const Grid g = grid_make(scene_of(piece_of({{0, 0}, {4, 0}, {0, 4}}, 1)), 0);
  EXPECT_EQ(grid_cell_of(g, {2.5, 1.5 + 1e-9}), grid_cell_of(g, {2.5, 1.5 - 1e-9}));
  EXPECT_EQ(grid_cell_of(g, {-7, 0.5}), grid_cell_at(g, 0, 0));
  EXPECT_EQ(grid_cell_of(g, {3.9, 3}), grid_cell_of(g, {2.45, 1.55}));
}

}  // namespace
}  // namespace drape::piece
