// The topology of a grid: slits, notches, darts, combs, necks and spirals.
#include "piece/grid/grid.h"

#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

Grid grid_of(const scene::PieceSpec& piece) { return grid_make(scene_of(piece), 0); }

std::vector<int> twins_per_place(const Grid& g) {  // how many places have one twin, two, ...
  std::map<std::array<int, 2>, int> count;
  for (const auto& at : g.twin) ++count[at];
  std::vector<int> places;
  for (const auto& [at, n] : count) {
    places.resize(std::max(places.size(), std::size_t(n)));
    ++places[std::size_t(n) - 1];
  }
  return places;
}

// Where all features are wider than two cells, the cells have the topology of the piece: nodes - sides +
// cells = 1 - holes.
TEST(GridTopology, CellsHangTogetherAsThePieceDoes) {
  RandomPiece random(11);
  for (int trial = 0; trial < 300; ++trial) {
    scene::PieceSpec piece = piece_of(random.star({0, 0}, 0.5, 1, random.count(6, 30)), random(0.01, 0.02));
    piece.grain = random(-4, 4);
    for (int k = random.count(0, 3); k > 0; --k) {
      const double f = 2.0 * k;
      piece.holes.push_back(
          random.star({0.15 * std::cos(f), 0.15 * std::sin(f)}, 0.05, 0.08, random.count(5, 9)));
    }
    if (!is_sound(piece)) continue;
    const Topology topology = topology_of(grid_of(piece));
    ASSERT_EQ(topology.pieces, 1) << "trial " << trial;
    ASSERT_EQ(topology.euler, 1 - int(piece.holes.size())) << "trial " << trial;
  }
}

// A slit of negligible width, from below into the piece, separates the cells on either side of it: there are
// twins at every node place beside it, but none at its end.
TEST(GridTopology, SlitPartsTheClothUpToItsEnd) {
  for (const double x : {2.5, 2.0, 2.0 - 1e-4}) {
    const double w = 1e-4;
    scene::PieceSpec piece = piece_of({{0, 0}, {x - w, 0}, {x, 2.5}, {x + w, 0}, {5, 0}, {5, 5}, {0, 5}}, 1);
    ASSERT_TRUE(is_sound(piece));
    const Grid g = grid_of(piece);
    EXPECT_NEAR(grid_area(g), 25 - 2.5 * w, 1e-13);
    const Topology topology = topology_of(g);
    EXPECT_EQ(topology.pieces, 1);
    EXPECT_EQ(topology.euler, 1);
    // The part of row 2 goes round the slit's end and joins both sides at y = 2. In the two rows below, the
    // slit separates two columns of nodes, or one that it runs along.
    EXPECT_EQ(twins_per_place(g), (std::vector<int>{x == 2.5 ? 4 : 2}));
    // No node is common to the left and the right of the slit.
    std::set<int> left, right;
    for (const GridPart& p : g.parts) {
      const GridCell& c = g.cells[std::size_t(p.cell)];
      std::set<int>& side = polygon_centre(p.loops[0])[0] < x ? left : right;
      if (p.j == 0) side.insert(c.node, c.node + 4);
    }
    EXPECT_GE(left.size(), 4u);
    EXPECT_GE(right.size(), 4u);
    for (int n : left) EXPECT_EQ(right.count(n), 0u);
  }
}

TEST(GridTopology, NotchDartAndComb) {
  // a notch of 0.4 cells between two legs, which share column 1
  scene::PieceSpec notch =
      piece_of({{0, 0}, {1.3, 0}, {1.3, 3.5}, {1.7, 3.5}, {1.7, 0}, {3, 0}, {3, 5}, {0, 5}}, 1);
  Grid g = grid_of(notch);
  EXPECT_NEAR(grid_area(g), 15 - 0.4 * 3.5, 1e-13);
  EXPECT_EQ(topology_of(g).pieces, 1);
  EXPECT_EQ(topology_of(g).euler, 1);
  EXPECT_EQ(twins_per_place(g), (std::vector<int>{6}));  // nodes (1,0..2) and (2,0..2)

  // a dart narrows from 1.5 cells to a point
  scene::PieceSpec dart = piece_of({{0, 0}, {2, 0}, {2.75, 4.5}, {3.5, 0}, {6, 0}, {6, 6}, {0, 6}}, 1);
  g = grid_of(dart);
  EXPECT_NEAR(grid_area(g), 36 - 1.5 * 4.5 / 2, 1e-13);
  EXPECT_EQ(topology_of(g).pieces, 1);
  EXPECT_EQ(topology_of(g).euler, 1);

  // a comb: teeth and gaps 0.3 cells wide, several in a cell
  std::vector<Vec2> outline{{0, 0}};
  for (int k = 0; k < 10; ++k) {
    const double x = 0.6 * k;
    outline.insert(outline.end(), {{x + 0.3, 0}, {x + 0.3, 4}, {x + 0.6, 4}, {x + 0.6, 0}});
  }
  outline.insert(outline.end(), {{6.3, 0}, {6.3, 6}, {0, 6}});
  g = grid_of(piece_of(outline, 1));
  EXPECT_NEAR(grid_area(g), 6.3 * 6 - 10 * 0.3 * 4, 1e-13);
  EXPECT_EQ(topology_of(g).pieces, 1);
  EXPECT_EQ(topology_of(g).euler, 1);
}

TEST(GridTopology, NarrowPiecesStayWhole) {
  // a neck 0.05 cells wide between two squares, along a grid line and across it
  for (const double y : {0.5, 1.0, 1.03}) {
    const scene::PieceSpec neck = piece_of({{0, 0},
                                            {2, 0},
                                            {2, y},
                                            {6, y},
                                            {6, 0},
                                            {8, 0},
                                            {8, 2},
                                            {6, 2},
                                            {6, y + 0.05},
                                            {2, y + 0.05},
                                            {2, 2},
                                            {0, 2}},
                                           1);
    ASSERT_TRUE(is_sound(neck));
    const Grid g = grid_of(neck);
    EXPECT_NEAR(grid_area(g), 8.2, 1e-13);
    EXPECT_EQ(topology_of(g).pieces, 1);
    EXPECT_EQ(topology_of(g).euler, 1);
  }
  // the tip of a triangle, thinner than a cell over most of its length
  Grid g = grid_of(piece_of({{0, 0}, {20, 0.3}, {0, 1.7}}, 1));
  EXPECT_NEAR(grid_area(g), 17, 1e-13);
  EXPECT_EQ(topology_of(g).pieces, 1);
  EXPECT_EQ(g.columns, 21);
  // a band of 0.4 cells turned in a spiral of gaps of 0.4 cells
  std::vector<Vec2> out, in;
  for (int k = 0; k <= 400; ++k) {
    const double f = 0.1 * k, r = 1 + 0.8 * f / (2 * std::numbers::pi);
    out.push_back({(r + 0.4) * std::cos(f), (r + 0.4) * std::sin(f)});
    in.push_back({r * std::cos(f), r * std::sin(f)});
  }
  out.insert(out.end(), in.rbegin(), in.rend());
  const scene::PieceSpec spiral = piece_of(out, 1);
  ASSERT_TRUE(is_sound(spiral));
  g = grid_of(spiral);
  EXPECT_NEAR(grid_area(g) / outline_area(outline_flatten(spiral)), 1, 1e-13);
  EXPECT_EQ(topology_of(g).pieces, 1);
  EXPECT_EQ(topology_of(g).euler, 1);
}

}  // namespace
}  // namespace drape::piece
