// Merging small parts keeps the topology of a piece: core/README.md, section 1.
#include "piece/grid/merge.h"

#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

Cut cut_of(const scene::PieceSpec& piece) {
  std::vector<std::vector<Vec2>> loops;
  const double c = std::cos(piece.grain), s = std::sin(piece.grain);
  for (const OutlineLoop& loop : outline_flatten(piece)) {
    loops.emplace_back();
    for (const Vec2& p : loop.points)
      loops.back().push_back(
          {cut_snapped((p[0] * c + p[1] * s) / piece.cell), cut_snapped((p[1] * c - p[0] * s) / piece.cell)});
  }
  return cut_make(loops);
}

// The parts that remain, with the node sets of their corners as nodes. Parts of the same four nodes count
// once.
Topology topology_of_parts(const Cut& cut, const Merged& merged) {
  std::map<PartRef, GridCell> cells;
  int nodes = 0;
  for (int place = cut.columns + 1; place < int(cut.first.size()); ++place)
    for (const std::vector<PartRef>& set : corner_sets(cut, merged, place)) {
      for (PartRef part : set) {
        const int back = place - part_place(cut, part);
        cells[part].node[back == 0 ? 0 : back == 1 ? 1 : back == cut.columns ? 2 : 3] = nodes;
      }
      ++nodes;
    }
  Grid grid;
  for (const auto& [part, cell] : cells)
    if (std::none_of(grid.cells.begin(), grid.cells.end(),
                     [&](const GridCell& c) { return std::equal(c.node, c.node + 4, cell.node); }))
      grid.cells.push_back(cell);
  return topology_of(grid);
}

// The number of connected pieces stays; nodes - sides + cells moves no farther from 1 - holes. (Before
// merging, two parts of one cell can enclose a hole that lies within the cell.)
TEST(Merge, KeepsTheShape) {
  RandomPiece random(1);
  int small = 0, kept = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    scene::PieceSpec piece = trial % 2 ? random.snapped_piece() : random.piece();
    if (trial % 2 == 0) piece.cell = random(0.03, 0.2);
    const Cut cut = cut_of(piece);
    const Merged merged = merge_make(cut);
    const Topology before = topology_of_parts(cut, merge_none(cut)), after = topology_of_parts(cut, merged);
    const int exact = 1 - int(piece.holes.size());
    ASSERT_EQ(before.pieces, 1) << "trial " << trial;
    ASSERT_EQ(after.pieces, 1) << "trial " << trial;
    ASSERT_LE(std::abs(after.euler - exact), std::abs(before.euler - exact)) << "trial " << trial;
    for (std::size_t p = 0; p < cut.parts.size(); ++p) {
      small += cut.parts[p].share < 0.2;
      kept += cut.parts[p].share < 0.2 && merged.into[p] == int(p);
      if (merged.into[p] == int(p)) continue;
      ASSERT_LT(cut.parts[p].share,
                0.2);  // and its taker is large enough, and none that was taken over itself
      const PartRef to = merged.into[p];
      if (to >= int(cut.parts.size())) continue;
      ASSERT_GE(cut.parts[std::size_t(to)].share, 0.2);
      ASSERT_EQ(merged.into[std::size_t(to)], to);
    }
  }
  std::printf("of %d parts below 0.2, %d stay (necks, tips, pieces of less than a cell)\n", small, kept);
  EXPECT_LT(kept, small / 10);
}

// Three small parts in a row between two large ones are a neck: all stay. A single one at the end of a row
// is merged.
TEST(Merge, KeepsANeck) {
  const Cut cut = cut_of(piece_of({{0, 0},
                                   {1, 0},
                                   {1, 0.4},
                                   {4, 0.4},
                                   {4, 0},
                                   {5, 0},
                                   {5, 1},
                                   {4, 1},
                                   {4, 0.5},
                                   {1.1, 0.5},
                                   {1.1, 0.9},
                                   {1, 0.9},
                                   {1, 1},
                                   {0, 1}},
                                  1));
  const Merged merged = merge_make(cut);
  ASSERT_EQ(cut.parts.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(merged.into[p], int(p));
  const Cut tab =
      cut_of(piece_of({{0, 0}, {1, 0}, {1, 0.4}, {1.5, 0.4}, {1.5, 0.5}, {1, 0.5}, {1, 1}, {0, 1}}, 1));
  EXPECT_EQ(part_place(tab, merge_make(tab).into[0]), part_place(tab, 0) - 1);
}

}  // namespace
}  // namespace drape::piece
