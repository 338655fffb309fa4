// The grid of a rectangle. The shares of a row of cells along a side of length L, laid from the anchor:
//
//     anchor |---1---|---1---|---1---|--L/b-(n-1)--|      n = floor(L/b + 0.8 + 1e-9) cells
//
// with the last share in [0.2, 1.2), and a cell's share is the product of those of its column and its row.
#include "piece/grid.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

constexpr double kSnap = 1e-9;  // of a cell, or of the piece's size: coordinates closer than that coincide

struct Extent {  // of a piece along x or y
  double low, high;
};

Extent outline_extent(const std::vector<Vec2>& outline, int axis) {
  Extent e{outline[0][axis], outline[0][axis]};
  for (const Vec2& p : outline) e = {std::min(e.low, p[axis]), std::max(e.high, p[axis])};
  return e;
}

bool is_high(const Extent& e, double v) { return v > (e.low + e.high) / 2; }

// True if the row of cells along `axis` starts from the high end: the end held by an edge pin; where none or
// both are held, that of the outline's first vertex.
bool anchor_high(const Scene& scene, int piece, int axis) {
  const std::vector<Vec2>& outline = scene.pieces[piece].outline;
  const Extent extent = outline_extent(outline, axis);
  bool held[2] = {false, false};
  for (const PinSpec& pin : scene.pins) {
    if (pin.piece != piece) continue;
    for (int edge : pin.edges) {
      const bool from = is_high(extent, outline[edge][axis]);
      const bool to = is_high(extent, outline[(edge + 1) % outline.size()][axis]);
      if (from == to) held[from] = true;
    }
  }
  return held[0] != held[1] ? held[1] : is_high(extent, outline[0][axis]);
}

struct Row {
  double origin;              // coordinate of node 0
  std::vector<double> share;  // [n] of the cells
};

Row row_make(const Extent& extent, double cell, bool from_high) {
  const double cells = (extent.high - extent.low) / cell;
  const int n = std::max(1, static_cast<int>(std::floor(cells + 0.8 + 1e-9)));
  const double cut = cells - (n - 1);
  Row row{from_high ? extent.high - n * cell : extent.low, std::vector<double>(n, 1.0)};
  if (std::abs(cut - 1) > 1e-9) (from_high ? row.share.front() : row.share.back()) = cut;
  return row;
}

// `v` in cells from node 0, exactly whole where it lies on a grid line.
double cells_from(double origin, double cell, double v) {
  const double u = (v - origin) / cell, whole = std::round(u);
  return std::abs(u - whole) <= kSnap ? whole : u;
}

}  // namespace

Grid grid_make(const Scene& scene, int piece) {
  const PieceSpec& spec = scene.pieces[piece];
  const Row x = row_make(outline_extent(spec.outline, 0), spec.cell, anchor_high(scene, piece, 0));
  const Row y = row_make(outline_extent(spec.outline, 1), spec.cell, anchor_high(scene, piece, 1));
  Grid grid;
  grid.cell = spec.cell;
  grid.x0 = x.origin;
  grid.y0 = y.origin;
  grid.columns = static_cast<int>(x.share.size()) + 1;
  grid.rows = static_cast<int>(y.share.size()) + 1;
  grid.area.assign(std::size_t(grid.nodes()), 0.0);
  for (int j = 0; j + 1 < grid.rows; ++j)
    for (int i = 0; i + 1 < grid.columns; ++i) {
      const int n = j * grid.columns + i;
      grid.cells.push_back(
          {i, j, {n, n + 1, n + grid.columns, n + grid.columns + 1}, y.share[j] * x.share[i]});
      for (int corner : grid.cells.back().node)
        grid.area[std::size_t(corner)] += grid.cell * grid.cell * grid.cells.back().share / 4;
    }
  grid.regular = int(grid.cells.size());
  return grid;
}

GridPoint grid_locate(const Grid& grid, Vec2 point) {
  const double u = cells_from(grid.x0, grid.cell, point[0]), v = cells_from(grid.y0, grid.cell, point[1]);
  const int i = static_cast<int>(std::clamp(std::floor(u), 0.0, grid.columns - 2.0));
  const int j = static_cast<int>(std::clamp(std::floor(v), 0.0, grid.rows - 2.0));
  const double s = u - i, t = v - j;
  const int n = j * grid.columns + i;
  return {{n, n + 1, n + grid.columns, n + grid.columns + 1},
          {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
}

}  // namespace drape
