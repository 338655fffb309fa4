// Shares, anchors and the bilinear map of the grid of a rectangle: core/README.md, section 1.
#include "piece/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace drape {
namespace {

// A rectangle from (x, y), counter-clockwise from its low corner.
PieceSpec rectangle(double x, double y, double width, double height, double cell) {
  PieceSpec piece;
  piece.cell = cell;
  piece.outline = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
  return piece;
}

Scene scene_of(const PieceSpec& piece, const std::vector<int>& pinned_edges = {}) {
  Scene scene;
  scene.pieces = {piece};
  if (!pinned_edges.empty()) {
    PinSpec pin;
    pin.piece = 0;
    pin.edges = pinned_edges;
    scene.pins = {pin};
  }
  return scene;
}

// Shares of the columns and of the rows, in pieces whose other direction has a whole cell.
std::vector<double> shares_along_x(const Grid& g) {
  std::vector<double> shares(g.columns - 1);
  for (int i = 0; i < g.columns - 1; ++i)
    for (int j = 0; j < g.rows - 1; ++j) shares[i] = std::max(shares[i], g.share_at(i, j));
  return shares;
}

std::vector<double> shares_along_y(const Grid& g) {
  std::vector<double> shares(g.rows - 1);
  for (int j = 0; j < g.rows - 1; ++j)
    for (int i = 0; i < g.columns - 1; ++i) shares[j] = std::max(shares[j], g.share_at(i, j));
  return shares;
}

double area_of(const Grid& g) {
  double sum = 0;
  for (int j = 0; j < g.rows; ++j)
    for (int i = 0; i < g.columns; ++i) sum += g.node_share(i, j);
  return sum * g.cell * g.cell;
}

TEST(Grid, WholeCells) {
  const Grid g = grid_make(scene_of(rectangle(-1, 2, 0.4, 0.6, 0.01)), 0);
  EXPECT_EQ(g.columns, 41);
  EXPECT_EQ(g.rows, 61);
  EXPECT_EQ(g.x0, -1);
  EXPECT_EQ(g.y0, 2);
  for (double share : g.share) EXPECT_EQ(share, 1);
}

TEST(Grid, CutCellLiesAwayFromTheFirstVertex) {
  PieceSpec piece = rectangle(0, 0, 2.5, 3.75, 1);
  Grid g = grid_make(scene_of(piece), 0);
  EXPECT_EQ(shares_along_x(g), (std::vector<double>{1, 1, 0.5}));
  EXPECT_EQ(shares_along_y(g), (std::vector<double>{1, 1, 1, 0.75}));
  EXPECT_EQ(g.share_at(2, 3), 0.5 * 0.75);
  EXPECT_EQ(g.node_share(2, 3), (1 + 0.5 + 0.75 + 0.5 * 0.75) / 4);
  EXPECT_EQ(g.x0, 0);
  EXPECT_EQ(g.y0, 0);

  std::rotate(piece.outline.begin(), piece.outline.begin() + 2,
              piece.outline.end());  // starts at the high corner
  g = grid_make(scene_of(piece), 0);
  EXPECT_EQ(g.share_at(0, 1), 0.5);
  EXPECT_EQ(g.share_at(1, 0), 0.75);
  EXPECT_EQ(g.share_at(1, 1), 1);
  EXPECT_EQ(g.x0, -0.5);  // node (0,0) lies outside by what is missing of its cell
  EXPECT_EQ(g.y0, -0.25);
}

TEST(Grid, CutCellLiesAwayFromAPinnedEdge) {
  const PieceSpec piece = rectangle(0, 0, 2.5, 3.75, 1);  // edges: 0 low y, 1 high x, 2 high y, 3 low x
  EXPECT_EQ(shares_along_y(grid_make(scene_of(piece, {2}), 0)), (std::vector<double>{0.75, 1, 1, 1}));
  EXPECT_EQ(shares_along_x(grid_make(scene_of(piece, {2}), 0)), (std::vector<double>{1, 1, 0.5}));
  EXPECT_EQ(shares_along_x(grid_make(scene_of(piece, {1}), 0)), (std::vector<double>{0.5, 1, 1}));
  EXPECT_EQ(shares_along_x(grid_make(scene_of(piece, {3}), 0)), (std::vector<double>{1, 1, 0.5}));
  // both ends held: as if none were
  EXPECT_EQ(shares_along_y(grid_make(scene_of(piece, {0, 2}), 0)), (std::vector<double>{1, 1, 1, 0.75}));
  // a clockwise outline that starts at the high x: edge 1 is the low y, edge 3 the high y
  PieceSpec clockwise = piece;
  clockwise.outline = {{2.5, 3.75}, {2.5, 0}, {0, 0}, {0, 3.75}};
  EXPECT_EQ(shares_along_x(grid_make(scene_of(clockwise, {1}), 0)), (std::vector<double>{0.5, 1, 1}));
  EXPECT_EQ(shares_along_y(grid_make(scene_of(clockwise, {1}), 0)), (std::vector<double>{1, 1, 1, 0.75}));
  // a pin of another piece, or one that holds points, does not count
  Scene two = scene_of(piece, {2});
  two.pieces.push_back(piece);
  EXPECT_EQ(shares_along_y(grid_make(two, 1)), (std::vector<double>{1, 1, 1, 0.75}));
  Scene points = scene_of(piece);
  points.pins = {PinSpec{"p", 0, {{0, 3.75}, {2.5, 3.75}}, {}}};
  EXPECT_EQ(shares_along_y(grid_make(points, 0)), (std::vector<double>{1, 1, 1, 0.75}));
}

TEST(Grid, RemainderBelowAFifthIsMerged) {
  const auto shares = [](double length) {
    return shares_along_x(grid_make(scene_of(rectangle(0, 0, length, 1, 1)), 0));
  };
  EXPECT_EQ(shares(2.125), (std::vector<double>{1, 1.125}));
  EXPECT_EQ(shares(2.25), (std::vector<double>{1, 1, 0.25}));
  EXPECT_EQ(shares(1.125), (std::vector<double>{1.125}));
  EXPECT_EQ(shares(1), (std::vector<double>{1}));
  EXPECT_EQ(shares(3 + 1e-10), (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(shares(3 - 1e-10), (std::vector<double>{1, 1, 1}));
  // from the high side: node 0 lies inside by the remainder
  const Grid g = grid_make(scene_of(rectangle(0, 0, 2.125, 1, 1), {1}), 0);
  EXPECT_EQ(shares_along_x(g), (std::vector<double>{1.125, 1}));
  EXPECT_EQ(g.x0, 0.125);
}

struct Random {
  std::mt19937_64 bits{2015};
  double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(bits); }
  PieceSpec piece() {
    const double width = (*this)(0.1, 2), height = (*this)(0.1, 2);
    PieceSpec p =
        rectangle((*this)(-3, 3), (*this)(-3, 3), width, height, std::min(width, height) / (*this)(1, 60));
    if (bits() % 2) std::reverse(p.outline.begin(), p.outline.end());
    std::rotate(p.outline.begin(), p.outline.begin() + bits() % 4, p.outline.end());
    return p;
  }
  std::vector<int> edges() {
    std::vector<int> list;
    for (int e = 0; e < 4; ++e)
      if (bits() % 3 == 0) list.push_back(e);
    return list;
  }
};

// sum over nodes of s b^2 = width x height. A coordinate of up to 5 m carries 4.4e-16 m of rounding, which a
// side of at least 0.1 m shows as 9e-15; the sum of 2400 x 2400 / 400 terms adds its own, below 1e-13.
TEST(Grid, SharesAddUpToTheArea) {
  Random random;
  for (int trial = 0; trial < 1000; ++trial) {
    const PieceSpec piece = random.piece();
    const Grid g = grid_make(scene_of(piece, random.edges()), 0);
    const double width = std::abs(piece.outline[2][0] - piece.outline[0][0]);
    const double height = std::abs(piece.outline[2][1] - piece.outline[0][1]);
    ASSERT_NEAR(area_of(g) / (width * height), 1, 1e-12) << "trial " << trial;
    for (double share : g.share) ASSERT_TRUE(share >= 0.2 * 0.2 - 1e-9 && share < 1.2 * 1.2) << share;
  }
}

// sum w = 1 and sum w X = X for any point of the piece: bilinear weights reproduce linear functions.
TEST(Grid, LocatedPointIsReproduced) {
  Random random;
  for (int trial = 0; trial < 1000; ++trial) {
    const PieceSpec piece = random.piece();
    const Grid g = grid_make(scene_of(piece, random.edges()), 0);
    std::vector<Vec2> points = piece.outline;
    const Vec2 a = piece.outline[0], c = piece.outline[2];
    for (int k = 0; k < 20; ++k) {
      const double s = random(0, 1), t = random(0, 1);
      points.push_back({a[0] + s * (c[0] - a[0]), a[1] + t * (c[1] - a[1])});
    }
    for (const Vec2& p : points) {
      const GridPoint at = grid_locate(g, p);
      double sum = 0, x = 0, y = 0;
      for (int k = 0; k < 4; ++k) {
        ASSERT_TRUE(at.i[k] >= 0 && at.i[k] < g.columns && at.j[k] >= 0 && at.j[k] < g.rows);
        ASSERT_TRUE(at.weight[k] == 0 || g.node_share(at.i[k], at.j[k]) > 0);  // a particle
        sum += at.weight[k];
        x += at.weight[k] * (g.x0 + at.i[k] * g.cell);
        y += at.weight[k] * (g.y0 + at.j[k] * g.cell);
      }
      ASSERT_NEAR(sum, 1, 1e-14);
      ASSERT_NEAR(x, p[0], 1e-12);
      ASSERT_NEAR(y, p[1], 1e-12);
    }
  }
}

TEST(Grid, PointsOnGridLinesHaveExactZeros) {
  const Grid g = grid_make(scene_of(rectangle(0.1, 0.2, 0.4, 0.6, 0.01)), 0);
  for (int i = 0; i < g.columns; ++i)
    for (int j = 0; j < g.rows; ++j) {
      const GridPoint at = grid_locate(g, {0.1 + i * 0.01 + 1e-12, 0.2 + j * 0.01 - 1e-12});
      for (int k = 0; k < 4; ++k)
        ASSERT_EQ(at.weight[k], at.i[k] == i && at.j[k] == j ? 1.0 : 0.0) << i << ' ' << j;
    }
  const GridPoint on_line = grid_locate(g, {0.1 + 7 * 0.01, 0.2 + 3.25 * 0.01});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(on_line.weight[k] != 0, on_line.i[k] == 7);
}

TEST(Grid, PointBeyondTheNodesOfAMergedCell) {
  const Grid g = grid_make(scene_of(rectangle(0, 0, 2.125, 1, 1)), 0);
  const GridPoint at = grid_locate(g, {2.125, 0.5});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(at.weight[k], (at.i[k] == 2 ? 1.125 : -0.125) / 2);
}

TEST(PinPoints, EdgeIsHeldAtItsCornersAndCrossings) {
  PinSpec pin;
  pin.edges = {2};
  PieceSpec piece = rectangle(0, 0, 2.5, 2, 1);
  Grid g = grid_make(scene_of(piece, pin.edges), 0);
  EXPECT_EQ(pin_points(g, piece, pin), (std::vector<Vec2>{{0, 2}, {1, 2}, {2, 2}, {2.5, 2}}));
  piece = rectangle(0, 0, 2.125, 2, 1);  // the last node lies inside, the corner beyond it
  g = grid_make(scene_of(piece, pin.edges), 0);
  EXPECT_EQ(pin_points(g, piece, pin), (std::vector<Vec2>{{0, 2}, {1, 2}, {2, 2}, {2.125, 2}}));
  // edges that meet share their corner; the edge across the cut row crosses the threads between nodes
  pin.edges = {2, 1};
  EXPECT_EQ(pin_points(grid_make(scene_of(piece), 0), piece, pin),
            (std::vector<Vec2>{{2.125, 0}, {2.125, 1}, {0, 2}, {1, 2}, {2, 2}, {2.125, 2}}));
}

TEST(PinPoints, HeldPointsOfAWholeCellEdgeAreNodes) {
  PinSpec pin;
  pin.edges = {0, 1, 2, 3};
  const PieceSpec piece = rectangle(0.1, -0.7, 0.4, 0.6, 0.01);
  const Grid g = grid_make(scene_of(piece, pin.edges), 0);
  const std::vector<Vec2> points = pin_points(g, piece, pin);
  EXPECT_EQ(points.size(), 2u * 41 + 2 * 61 - 4);
  for (const Vec2& p : points) {
    const GridPoint at = grid_locate(g, p);
    EXPECT_EQ(std::count(at.weight, at.weight + 4, 1.0), 1);
  }
}

TEST(PinPoints, PointsAreHeldOnce) {
  PinSpec pin;
  const PieceSpec piece = rectangle(0, 0, 2.5, 2, 1);
  pin.at = {{2.5, 2}, {0.3, 0.4}, {2.5 - 1e-10, 2 + 1e-10}, {1 + 1e-10, 1}, {0.3, 0.4}, {1, 1}};
  EXPECT_EQ(pin_points(grid_make(scene_of(piece), 0), piece, pin),
            (std::vector<Vec2>{{0.3, 0.4}, {1, 1}, {2.5, 2}}));
}

// An outline that is a rectangle only within the tolerance is laid on its box.
TEST(PinPoints, AlmostStraightEdge) {
  PinSpec pin;
  pin.edges = {2};
  PieceSpec piece = rectangle(0, 0, 100, 2, 0.5);
  piece.outline[2][1] += 0.9e-7;
  const Grid g = grid_make(scene_of(piece, pin.edges), 0);
  const std::vector<Vec2> points = pin_points(g, piece, pin);
  EXPECT_EQ(points.size(), 201u);
  for (const Vec2& p : points) EXPECT_EQ(p[1], points[0][1]);
}

}  // namespace
}  // namespace drape
