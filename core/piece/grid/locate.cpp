// Locates points of a piece. Places are searched in rings around that of the point, until no further ring can
// contain a closer part. For a point inside the piece that is immediate; for one on the boundary it takes one
// more ring.
#include <algorithm>
#include <cmath>

#include "piece/grid/cut.h"
#include "piece/grid/grid.h"

namespace drape::piece {
namespace {

constexpr double kOn = 1e-9;  // cells: a point closer to a part than this is on the part

struct Nearest {
  int cell = -1;
  double distance = INFINITY;  // cells
  bool merged = false;         // the cell is at another place
};

void nearest_update(Nearest& best, const Grid& grid, int cell, double distance, int i, int j) {
  const GridCell& c = grid.cells[std::size_t(cell)];
  const Nearest next{cell, distance <= kOn ? 0 : distance, c.i != i || c.j != j};
  if (next.distance < best.distance || (next.distance == best.distance && best.merged && !next.merged))
    best = next;
}

// The first part of a place, if the place has any.
auto place_parts(const Grid& grid, int i, int j) {
  return std::lower_bound(grid.parts.begin(), grid.parts.end(), i,
                          [&](const GridPart& p, int column) { return p.j != j ? p.j < j : p.i < column; });
}

void place_search(Nearest& best, const Grid& grid, int i, int j, Vec2 at, Vec2 point) {
  bool cut = false;
  if (!grid.paper) {
    auto part = place_parts(grid, i, j);
    for (; part != grid.parts.end() && part->i == i && part->j == j; ++part, cut = true)
      nearest_update(best, grid, part->cell, polygons_distance(part->loops, point) / grid.cell, i, j);
  }
  if (cut) return;
  if (const int cell = grid_cell_at(grid, i, j); cell >= 0) {
    const double dx = std::max({i - at[0], at[0] - (i + 1), 0.0}),
                 dy = std::max({j - at[1], at[1] - (j + 1), 0.0});
    nearest_update(best, grid, cell, std::hypot(dx, dy), i, j);
  }
}

}  // namespace

Vec2 grid_coordinates(const Grid& grid, Vec2 p) {
  const double x = p[0] * grid.cosine + p[1] * grid.sine, y = p[1] * grid.cosine - p[0] * grid.sine;
  return {cut_snapped((x - grid.x0) / grid.cell), cut_snapped((y - grid.y0) / grid.cell)};
}

Vec2 grid_plane(const Grid& grid, Vec2 coordinates) {
  const double x = grid.x0 + coordinates[0] * grid.cell, y = grid.y0 + coordinates[1] * grid.cell;
  return {x * grid.cosine - y * grid.sine, x * grid.sine + y * grid.cosine};
}

bool grid_is_cut(const Grid& grid, int i, int j) {
  const auto part = place_parts(grid, i, j);
  return part != grid.parts.end() && part->i == i && part->j == j;
}

int grid_cell_at(const Grid& grid, int i, int j) {
  const auto regular_end = grid.cells.begin() + grid.regular;
  const auto before = [](const GridCell& c, std::pair<int, int> at) {
    return c.j != at.second ? c.j < at.second : c.i < at.first;
  };
  for (auto [from, to] : {std::pair{grid.cells.begin(), regular_end}, {regular_end, grid.cells.end()}}) {
    const auto cell = std::lower_bound(from, to, std::pair{i, j}, before);
    if (cell != to && cell->i == i && cell->j == j) return int(cell - grid.cells.begin());
  }
  return -1;
}

int grid_cell_of(const Grid& grid, Vec2 point) {
  const Vec2 at = grid_coordinates(grid, point);
  const int i = int(std::clamp(std::floor(at[0]), -1.0, grid.columns - 1.0));
  const int j = int(std::clamp(std::floor(at[1]), -1.0, grid.rows - 1.0));
  const bool on_line = at[0] == std::floor(at[0]) || at[1] == std::floor(at[1]);
  Nearest best;
  for (int r = 0; r <= std::max(grid.columns, grid.rows); ++r) {
    for (int row = j - r; row <= j + r; ++row)
      for (int column = i - r; column <= i + r; column += row == j - r || row == j + r || r == 0 ? 1 : 2 * r)
        place_search(best, grid, column, row, at, point);
    if (best.distance <= r && !(r == 0 && best.merged && on_line)) break;
  }
  return best.cell;
}

GridPoint grid_locate(const Grid& grid, Vec2 point) {
  return grid_point(grid, grid_cell_of(grid, point), grid_coordinates(grid, point));
}

GridPoint grid_point(const Grid& grid, int cell, Vec2 coordinates) {
  const GridCell& c = grid.cells[std::size_t(cell)];
  const double s = coordinates[0] - c.i, t = coordinates[1] - c.j;
  return {{c.node[0], c.node[1], c.node[2], c.node[3]}, {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
}

}  // namespace drape::piece
