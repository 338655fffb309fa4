#include "piece/grid/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "piece/grid/cut.h"

namespace drape::piece {
namespace {

using Polygon = std::vector<Vec2>;

// Rounds coordinates (in cells) to multiples of 2^-40, which has no visible effect on areas. Sums and
// differences of such coordinates are exact, so corners shared by polygons remain equal in each.
Vec2 rounded(const Vec2& p) {
  constexpr double kUnit = 0x1p-40;
  return {std::nearbyint(p[0] / kUnit) * kUnit, std::nearbyint(p[1] / kUnit) * kUnit};
}

struct Builder {
  const Grid& grid;
  Surface surface;
  std::map<std::vector<std::pair<int, double>>, int> known;  // (node, weight) in order -> corner
};

int corner_of(Builder& b, const GridPoint& point) {
  std::vector<std::pair<int, double>> key;
  for (int k = 0; k < 4; ++k)
    if (point.weight[k] != 0) key.emplace_back(point.node[k], point.weight[k]);
  if (key.size() == 1) return key[0].first;
  std::sort(key.begin(), key.end());
  const auto [at, is_new] = b.known.emplace(key, b.grid.nodes() + int(b.surface.points.size()));
  if (is_new) b.surface.points.push_back(point);
  return at->second;
}

// Appends a polygon (in cells) of a part.
void polygon_append(Builder& b, const Polygon& polygon, const GridPart& part) {
  const bool merged = grid_is_merged(b.grid, part);
  std::vector<int>& corner = b.surface.corner;
  const std::size_t begin = corner.size();
  for (const Vec2& p : polygon) {
    const int cell = merged ? grid_cell_of(b.grid, grid_plane(b.grid, p)) : part.cell;
    const int next = corner_of(b, grid_point(b.grid, cell, p));
    if (corner.size() == begin || next != corner.back()) corner.push_back(next);
  }
  while (corner.size() > begin + 1 && corner.back() == corner[begin]) corner.pop_back();
  if (corner.size() < begin + 3) corner.resize(begin);
  else b.surface.end.push_back(int(corner.size()));
}

// Divides a part into polygons without holes. It is cut along two lines through the middle of a hole, until
// no hole is left.
void part_open(const std::vector<Polygon>& loops, std::vector<Polygon>& open) {
  if (loops.size() == 1) return open.push_back(loops[0]);
  Vec2 middle;
  for (std::size_t a = 0; a < 2; ++a) {
    const auto [low, high] = std::minmax_element(loops[1].begin(), loops[1].end(),
                                                 [a](const Vec2& p, const Vec2& q) { return p[a] < q[a]; });
    middle[a] = ((*low)[a] + (*high)[a]) / 2;
  }
  middle = rounded(middle);
  std::vector<Polygon> moved = loops;
  for (Polygon& loop : moved)
    for (Vec2& p : loop) p = {cut_snapped(p[0] - middle[0]), cut_snapped(p[1] - middle[1])};
  const Cut cut = cut_make(moved);
  for (const CutPart& part : cut.parts) {
    const int column = part.place % cut.columns, row = part.place / cut.columns;
    const double i = cut.i0 + column, j = cut.j0 + row;
    std::vector<Polygon> back = part.loops;
    for (Polygon& loop : back)
      for (Vec2& p : loop) p = rounded({p[0] + i + middle[0], p[1] + j + middle[1]});
    part_open(back, open);
  }
}

}  // namespace

Surface surface_make(const Grid& grid) {
  Builder b{grid, {}, {}};
  for (const GridCell& cell : grid.cells) {
    if (grid_is_cut(grid, cell.i, cell.j)) continue;
    for (int k : {0, 1, 3, 2}) b.surface.corner.push_back(cell.node[k]);
    b.surface.end.push_back(int(b.surface.corner.size()));
  }
  for (const GridPart& part : grid.parts) {
    std::vector<Polygon> loops = part.loops, open;
    for (Polygon& loop : loops)
      for (Vec2& p : loop) p = rounded(grid_coordinates(grid, p));
    part_open(loops, open);
    for (const Polygon& polygon : open) polygon_append(b, polygon, part);
  }
  return b.surface;
}

}  // namespace drape::piece
