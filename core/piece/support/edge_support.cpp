// The slope of yarns that leave a clamped edge: core/README.md, section 4.
//
//         x1          A yarn crosses the edge at p; x1 is its first node inside, s = |x1 - p|/b. In the
//         |           lattice the link x0 - x1 represents the free length s b. It is as stiff as
//         |           y = 1/s^2 of the hinge kappa_c,
//    -----p---- edge  and contributes q_c = s^2 of its length to the hinge at x1.
//         |
//         x0
#include "piece/support/edge_support.h"

#include <algorithm>
#include <cmath>

#include "piece/grid/cut.h"

namespace drape::piece {
namespace {

constexpr double kMin = 0.2;      // smallest s
constexpr double kInside = 1e-6;  // cells: distance inside the edge at which the cell of a yarn is looked up

// Appends the link by which the yarn along `axis` (0 weft, 1 warp) leaves the edge.
void crossing_slope(const Grid& grid, const std::vector<OutlineLoop>& loops, const EdgeCrossing& crossing,
                    std::size_t axis, std::vector<HeldSlope>& slopes) {
  const double inward = axis == 1 ? crossing.along[0] : -crossing.along[1];
  const double line = crossing.at[1 - axis];
  if (line != std::floor(line) || inward == 0) return;
  const int up = inward > 0;
  Vec2 inside = crossing.at;
  inside[axis] += up ? kInside : -kInside;
  const Vec2 point = grid_plane(grid, inside);
  if (crossing.end && outline_distance(loops, point) > kSnap * grid.cell) return;  // past a corner
  const GridCell& cell = grid.cells[std::size_t(grid_cell_of(grid, point))];
  const double across = line - (axis == 1 ? cell.i : cell.j);
  if (across != 0 && across != 1) return;  // a yarn that is not a side of the cell
  const int low = axis == 1 ? cell.j : cell.i;
  const double s = up ? low + 1 - crossing.at[axis] : crossing.at[axis] - low;
  if (s <= 0) return;
  const int first = across == 0 ? 0 : axis == 1 ? 1 : 2, step = axis == 1 ? 2 : 1;
  const int from = cell.node[up ? first : first + step], to = cell.node[up ? first + step : first];
  const bool known = std::any_of(slopes.begin(), slopes.end(),
                                 [&](const HeldSlope& h) { return h.from == from && h.to == to; });
  const double free = std::max(s, kMin);
  if (!known) slopes.push_back({from, to, axis == 1, 1 / (free * free), free * free, true});
}

}  // namespace

std::array<Vec2, 2> edge_ends(const Grid& grid, const scene::PieceSpec& piece, int edge) {
  const std::vector<Vec2>& points = piece.outline;
  return {grid_coordinates(grid, points[std::size_t(edge)]),
          grid_coordinates(grid, points[(std::size_t(edge) + 1) % points.size()])};
}

std::vector<EdgeCrossing> edge_crossings(const Grid& grid, const std::vector<OutlineLoop>& loops, int edge) {
  const OutlineLoop& rim = loops[0];
  const std::size_t n = rim.points.size();
  std::vector<EdgeCrossing> crossings;
  for (std::size_t k = 0; k < n; ++k) {
    if (rim.edge[k] != edge) continue;
    const Vec2 p = grid_coordinates(grid, rim.points[k]), q = grid_coordinates(grid, rim.points[(k + 1) % n]);
    std::vector<Vec2> points{p};
    cut_segment(p, q, points);
    for (std::size_t m = 0; m < points.size(); ++m) {
      const Vec2 at = points[m];
      if (at[0] != std::floor(at[0]) && at[1] != std::floor(at[1])) continue;
      const bool end = (m == 0 && rim.edge[(k + n - 1) % n] != edge) ||
                       (m + 1 == points.size() && rim.edge[(k + 1) % n] != edge);
      crossings.push_back({at, {q[0] - p[0], q[1] - p[1]}, end});
    }
  }
  return crossings;
}

void edge_slopes(const Grid& grid, const std::vector<OutlineLoop>& loops, int edge,
                 std::vector<HeldSlope>& slopes) {
  for (const EdgeCrossing& crossing : edge_crossings(grid, loops, edge))
    for (std::size_t axis : {1u, 0u}) crossing_slope(grid, loops, crossing, axis, slopes);
}

}  // namespace drape::piece
