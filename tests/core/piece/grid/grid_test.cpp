// Shares, anchors and nodes of a grid: core/README.md, section 1.
#include "piece/grid/grid.h"

#include <chrono>
#include <numbers>

#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

Grid grid_of(const scene::PieceSpec& piece, const std::vector<int>& pinned_edges = {}) {
  return grid_make(scene_of(piece, pinned_edges), 0);
}

double share_at(const Grid& g, int i, int j) {
  const int cell = grid_cell_at(g, i, j);
  return cell < 0 ? 0 : g.cells[std::size_t(cell)].share;
}

// Shares of the columns or of the rows, in pieces with a whole cell in the other direction.
std::vector<double> shares_along(const Grid& g, int axis) {
  std::vector<double> shares(std::size_t(axis ? g.rows : g.columns) - 1);
  for (const GridCell& c : g.cells)
    shares[std::size_t(axis ? c.j : c.i)] = std::max(shares[std::size_t(axis ? c.j : c.i)], c.share);
  return shares;
}

using Shares = std::vector<double>;

TEST(Grid, WholeCells) {
  const Grid g = grid_of(rectangle(-1, 2, 0.4, 0.6, 0.01));
  EXPECT_EQ(g.columns, 41);
  EXPECT_EQ(g.rows, 61);
  EXPECT_EQ(g.x0, -1);
  EXPECT_EQ(g.y0, 2);
  EXPECT_EQ(g.cells.size(), 2400u);
  EXPECT_EQ(g.regular, 2400);
  EXPECT_TRUE(g.parts.empty() && g.twin.empty());
  for (const GridCell& c : g.cells) EXPECT_EQ(c.share, 1);
}

TEST(Grid, CutCellLiesAwayFromTheFirstVertex) {
  scene::PieceSpec piece = rectangle(0, 0, 2.5, 3.75, 1);
  Grid g = grid_of(piece);
  EXPECT_EQ(shares_along(g, 0), (Shares{1, 1, 0.5}));
  EXPECT_EQ(shares_along(g, 1), (Shares{1, 1, 1, 0.75}));
  EXPECT_EQ(share_at(g, 2, 3), 0.5 * 0.75);
  EXPECT_EQ(g.area[std::size_t(3 * g.columns + 2)], (1 + 0.5 + 0.75 + 0.5 * 0.75) / 4);
  EXPECT_EQ(g.x0, 0);
  EXPECT_EQ(g.y0, 0);

  std::rotate(piece.outline.begin(), piece.outline.begin() + 2,
              piece.outline.end());  // starts at the high corner
  g = grid_of(piece);
  EXPECT_EQ(share_at(g, 0, 1), 0.5);
  EXPECT_EQ(share_at(g, 1, 0), 0.75);
  EXPECT_EQ(share_at(g, 1, 1), 1);
  EXPECT_EQ(g.x0, -0.5);  // node (0,0) lies outside by the missing part of its cell
  EXPECT_EQ(g.y0, -0.25);
}

TEST(Grid, GridLinesPassThroughTheFirstPinnedEdgeAlongEachAxis) {
  const scene::PieceSpec piece =
      rectangle(0, 0, 2.5, 3.75, 1);  // edges: 0 low y, 1 high x, 2 high y, 3 low x
  EXPECT_EQ(shares_along(grid_of(piece, {2}), 1), (Shares{0.75, 1, 1, 1}));
  EXPECT_EQ(shares_along(grid_of(piece, {2}), 0), (Shares{1, 1, 0.5}));
  EXPECT_EQ(shares_along(grid_of(piece, {1}), 0), (Shares{0.5, 1, 1}));
  EXPECT_EQ(shares_along(grid_of(piece, {3}), 0), (Shares{1, 1, 0.5}));
  EXPECT_EQ(shares_along(grid_of(piece, {0, 2}), 1), (Shares{1, 1, 1, 0.75}));
  EXPECT_EQ(shares_along(grid_of(piece, {2, 0}), 1), (Shares{0.75, 1, 1, 1}));
  // A pin of another piece, or one that holds points, does not count; nor does a curved edge.
  Scene two = scene_of(piece, {2});
  two.pieces.push_back(piece);
  EXPECT_EQ(shares_along(grid_make(two, 1), 1), (Shares{1, 1, 1, 0.75}));
  Scene points = scene_of(piece);
  points.pins = {scene::PinSpec{"p", 0, {{0, 3.75}, {2.5, 3.75}}, {}}};
  EXPECT_EQ(shares_along(grid_make(points, 0), 1), (Shares{1, 1, 1, 0.75}));
  scene::PieceSpec curved = piece;
  curved.curves = {{2, {{1.25, 3.5}}}};
  EXPECT_EQ(grid_of(curved, {2}).y0, 0);
  // Rotated together with its grain, a piece has the same cells.
  scene::PieceSpec turned = piece;
  turned.grain = 0.7;
  for (Vec2& p : turned.outline)
    p = {p[0] * std::cos(0.7) - p[1] * std::sin(0.7), p[0] * std::sin(0.7) + p[1] * std::cos(0.7)};
  const Grid a = grid_of(piece, {2}), b = grid_of(turned, {2});
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for (std::size_t c = 0; c < a.cells.size(); ++c) EXPECT_NEAR(a.cells[c].share, b.cells[c].share, 1e-14);
  // A distant origin shifts it by whole cells.
  scene::PieceSpec far = piece;
  far.grid_origin = Vec2{-1e4 + 0.25, 0.5};
  EXPECT_EQ(grid_of(far).x0, -0.75);
  EXPECT_EQ(grid_of(far).y0, -0.5);
}

TEST(Grid, RemainderBelowAFifthIsMerged) {
  const auto shares = [](double length) { return shares_along(grid_of(rectangle(0, 0, length, 1, 1)), 0); };
  EXPECT_EQ(shares(2.125), (Shares{1, 1.125}));
  EXPECT_EQ(shares(2.25), (Shares{1, 1, 0.25}));
  EXPECT_EQ(shares(1.125), (Shares{1.125}));
  EXPECT_EQ(shares(1), (Shares{1}));
  EXPECT_EQ(shares(3 + 1e-10), (Shares{1, 1, 1}));
  EXPECT_EQ(shares(3 - 1e-10), (Shares{1, 1, 1}));
  // From the high side: node 0 lies inside by the remainder.
  const Grid g = grid_of(rectangle(0, 0, 2.125, 1, 1), {1});
  EXPECT_EQ(shares_along(g, 0), (Shares{1.125, 1}));
  EXPECT_EQ(g.x0, 0.125);
  // A small corner merges with its small neighbours.
  const Grid corner = grid_of(rectangle(0, 0, 2.125, 3.125, 1));
  EXPECT_EQ(corner.cells.size(), 6u);
  EXPECT_EQ(share_at(corner, 1, 2), 1.125 * 1.125);
}

// The areas of the nodes sum to the area of the polygon. Coordinates up to 50 m over cells of 0.01 m carry a
// rounding of 1e-12 cells each. That moves an outline of up to 400 cells, half of them each way, around an
// area of 1e3 cells or more; pieces of a few cells have little rounding.
TEST(Grid, AreasOfNodesAddUpToThePolygon) {
  RandomPiece random(2015);
  double worst = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const scene::PieceSpec piece = random.piece();
    const Grid g = grid_of(piece);
    const double error = std::abs(grid_area(g) / outline_area(outline_flatten(piece)) - 1);
    ASSERT_LE(error, 1e-12) << "trial " << trial;
    worst = std::max(worst, error);
    ASSERT_EQ(topology_of(g).pieces, 1) << "trial " << trial;
    for (const GridCell& c : g.cells) ASSERT_GT(c.share, 0);
    for (const GridPart& p : g.parts) ASSERT_TRUE(p.cell >= 0 && p.cell < int(g.cells.size()));
    Scene paper = scene_of(piece);
    paper.outline = scene::OutlineModel::kPaper;
    const Grid whole = grid_make(paper, 0);
    if (whole.cells.empty()) continue;
    ASSERT_NEAR(grid_area(whole) / outline_area(outline_flatten(piece)), 1, 1e-12)
        << "paper, trial " << trial;
    for (const GridCell& c : whole.cells) ASSERT_EQ(c.share, 1);
  }
  std::printf("1,000 random pieces: sum of areas off by at most %.1e\n", worst);
}

// The same with corners on grid lines and nodes, edges along them, and holes that touch them.
TEST(Grid, CornersOnGridLinesLoseNoArea) {
  RandomPiece random(7);
  for (int trial = 0; trial < 20000; ++trial) {
    const scene::PieceSpec piece = random.snapped_piece();
    const Grid g = grid_of(piece);
    ASSERT_NEAR(grid_area(g) / outline_area(outline_flatten(piece)), 1, 1e-13) << "trial " << trial;
    ASSERT_EQ(topology_of(g).pieces, 1) << "trial " << trial;
  }
}

TEST(Grid, PiecesOfOneCell) {
  const auto check = [](const scene::PieceSpec& piece, std::size_t cells, double area) {
    const Grid g = grid_of(piece);
    EXPECT_EQ(g.cells.size(), cells);
    EXPECT_NEAR(grid_area(g), area, 1e-14);
    EXPECT_EQ(topology_of(g).pieces, 1);
  };
  check(rectangle(0, 0, 1, 1, 1), 1, 1);
  scene::PieceSpec inside = rectangle(0.25, 0.25, 0.5, 0.5, 0.5);
  inside.cell = 1;
  inside.grid_origin = Vec2{0, 0};
  check(inside, 1, 0.25);
  inside.holes = {{{0.3, 0.3}, {0.5, 0.3}, {0.5, 0.5}}};
  check(inside, 1, 0.23);
  scene::PieceSpec touching =
      piece_of({{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}}, 1);  // corners on the sides of its cell
  touching.grid_origin = Vec2{0, 0};
  check(touching, 1, 0.5);
  scene::PieceSpec diamond =
      piece_of({{1, 0}, {2, 1}, {1, 2}, {0, 1}}, 1);  // through the corners of four cells
  check(diamond, 4, 2);
  scene::PieceSpec frame = rectangle(0, 0, 3, 3, 1);  // one cell left out
  frame.holes = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  check(frame, 8, 8);
  EXPECT_EQ(topology_of(grid_of(frame)).euler, 0);
  scene::PieceSpec small = rectangle(0, 0, 3, 3, 1);  // a hole within one cell
  small.holes = {{{1.25, 1.25}, {1.75, 1.25}, {1.75, 1.75}, {1.25, 1.75}}};
  check(small, 9, 8.75);
  EXPECT_EQ(share_at(grid_of(small), 1, 1), 0.75);
}

// A part stays below 0.2 only where its merging would tear the piece, or no neighbour can absorb it.
TEST(Grid, NoSmallPartIsLeftAtASmoothRim) {
  RandomPiece random(5);
  for (int trial = 0; trial < 200; ++trial) {
    scene::PieceSpec piece = piece_of({{-1, 0}, {0, -1}, {1, 0}, {0, 1}}, random(0.02, 0.1));
    for (int e = 0; e < 4; ++e) piece.curves.push_back({e, {}, random(1, 3), false, true});
    piece.grain = random(-4, 4);
    const Grid g = grid_of(piece);
    for (const GridCell& c : g.cells) ASSERT_GE(c.share, 0.2) << "trial " << trial;
    EXPECT_TRUE(g.twin.empty());
  }
}

// A linear displacement strains all links alike. With unit tension along them the stress is the sum of width
// x rest length over the area. The sums of w b over warp links, of w b over weft links, of w sqrt(2) b over
// either diagonal and of b^2 phi are all A.
TEST(Grid, WidthsCarryTheAreaOnce) {
  RandomPiece random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const scene::PieceSpec piece = random.piece();
    const Grid g = grid_of(piece);
    const double area = outline_area(outline_flatten(piece));
    std::map<std::pair<int, int>, double> width;
    for (const GridCell& c : g.cells) {
      for (const auto& [k, l] : {std::pair{0, 1}, {2, 3}, {0, 2}, {1, 3}})
        width[{c.node[k], c.node[l]}] += g.cell * c.share / 2;
      width[{c.node[0], c.node[3]}] += g.cell * c.share / std::numbers::sqrt2;
      width[{c.node[1], c.node[2]}] += g.cell * c.share / std::numbers::sqrt2;
    }
    double sums[4] = {};
    for (const auto& [ends, w] : width) {
      const auto a = g.index(ends.first), b = g.index(ends.second);
      const int di = b[0] - a[0], dj = b[1] - a[1];
      ASSERT_TRUE((di == 1 && dj == 0) || (di == 0 && dj == 1) || (std::abs(di) == 1 && dj == 1));
      sums[dj == 0 ? 0 : di == 0 ? 1 : di > 0 ? 2 : 3] += w * g.cell * (di && dj ? std::numbers::sqrt2 : 1);
    }
    for (double sum : sums) ASSERT_NEAR(sum / area, 1, 1e-12) << "trial " << trial;
  }
}

// The mass of a cut cell is placed at the cell's centre: the piece's centroid is off by O(b^2).
TEST(Grid, CentroidIsOffBySecondOrder) {
  const auto error = [](double cell) {
    RandomPiece random(17);
    double square = 0;
    const int trials = 200;
    for (int trial = 0; trial < trials; ++trial) {
      const scene::PieceSpec piece = piece_of(random.star({0, 0}, 0.5, 1, 20), cell);
      const Grid g = grid_of(piece);
      Vec2 centre{0, 0};
      for (int n = 0; n < g.nodes(); ++n)
        for (std::size_t a = 0; a < 2; ++a) centre[a] += g.area[std::size_t(n)] * g.place(n)[a];
      const Vec2 exact = polygon_centre(piece.outline);
      for (std::size_t a = 0; a < 2; ++a) square += std::pow(centre[a] / grid_area(g) - exact[a], 2);
    }
    return std::sqrt(square / trials);
  };
  double last = error(0.1);
  std::printf("root mean square error of the centroid (pieces of 0.5 to 1 m radius)\n  b = 0.1    %.2e m\n",
              last);
  for (const double cell : {0.05, 0.025, 0.0125}) {
    const double e = error(cell);
    std::printf("  b = %-6g %.2e m, order %.2f\n", cell, e, std::log2(last / e));
    EXPECT_GT(std::log2(last / e), 1.8);
    last = e;
  }
}

TEST(Grid, PaperKeepsWholeCells) {
  Scene scene = scene_of(rectangle(0, 0, 2.5, 3.75, 1));
  scene.outline = scene::OutlineModel::kPaper;
  const Grid g = grid_make(scene, 0);
  EXPECT_EQ(g.columns, 3);
  EXPECT_EQ(g.rows, 4);
  EXPECT_EQ(g.cells.size(), 6u);
  // Node (2,3): a quarter of a cell, half of the parts (2,2) and (1,3) that it borders, all of the corner.
  EXPECT_EQ(g.area[11], 0.25 + 0.5 / 2 + 0.75 / 2 + 0.375);
  EXPECT_EQ(g.area[0], 0.25);
  EXPECT_NEAR(grid_area(g), 2.5 * 3.75, 1e-14);
  const GridPoint at = grid_locate(g, {2.5, 3});  // the map of cell (1,2), continued
  EXPECT_EQ(at.weight[3], 1.5);
  EXPECT_EQ(at.weight[2], -0.5);
}

TEST(Grid, AMillionNodes) {
  scene::PieceSpec piece = rectangle(0, 0, 1, 1, 0.001);
  piece.curves = {{1, {{1.3, 0.5}}}};
  piece.grain = 0.1;
  const auto start = std::chrono::steady_clock::now();
  const Grid g = grid_of(piece);
  std::printf("%d nodes, %zu cells, %zu cut parts: %.3f s\n", g.nodes(), g.cells.size(), g.parts.size(),
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  EXPECT_GT(g.cells.size(), 1000000u);
  EXPECT_NEAR(grid_area(g) / outline_area(outline_flatten(piece)), 1, 1e-12);
}

}  // namespace
}  // namespace drape::piece
