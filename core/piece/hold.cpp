#include "piece/hold.h"

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

// `v` in cells from node 0, exactly whole where it lies on a grid line.
double cells_from(double origin, double cell, double v) {
  const double u = (v - origin) / cell, whole = std::round(u);
  return std::abs(u - whole) <= kSnap ? whole : u;
}

// A held point, moved onto the rim and the grid lines that it touches, so that equal points compare equal.
Vec2 settled(const Grid& grid, const PieceSpec& piece, Vec2 p) {
  const Extent extent[2] = {outline_extent(piece.outline, 0), outline_extent(piece.outline, 1)};
  const double origin[2] = {grid.x0, grid.y0};
  const double size = std::max(extent[0].high - extent[0].low, extent[1].high - extent[1].low);
  for (int k = 0; k < 2; ++k) {
    for (double rim : {extent[k].low, extent[k].high})
      if (std::abs(p[k] - rim) <= kSnap + kSnap * size) p[k] = rim;
    const double u = cells_from(origin[k], grid.cell, p[k]);
    if (u == std::round(u)) p[k] = origin[k] + u * grid.cell;
  }
  return p;
}

std::vector<Vec2> held_points(const Grid& grid, const PieceSpec& piece, const PinSpec& pin) {
  std::vector<Vec2> points;
  for (const Vec2& p : pin.at) points.push_back(settled(grid, piece, p));
  for (int edge : pin.edges) {
    const Vec2 from = settled(grid, piece, piece.outline[edge]);
    const Vec2 to = settled(grid, piece, piece.outline[(edge + 1) % piece.outline.size()]);
    const int along = from[0] == to[0];  // the axis along which the edge runs
    const double origin = along ? grid.y0 : grid.x0;
    points.push_back(from);
    points.push_back(to);
    for (int k = 0; k < (along ? grid.rows : grid.columns); ++k) {
      Vec2 crossing = from;
      crossing[along] = origin + k * grid.cell;
      if (crossing[along] > std::min(from[along], to[along]) &&
          crossing[along] < std::max(from[along], to[along]))
        points.push_back(crossing);
    }
  }
  std::sort(points.begin(), points.end(),
            [](Vec2 p, Vec2 q) { return p[1] != q[1] ? p[1] < q[1] : p[0] < q[0]; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

Hold hold_make(const Grid& grid, const Scene& scene, const PinSpec& pin) {
  const PieceSpec& piece = scene.pieces[std::size_t(pin.piece)];
  Hold hold;
  hold.points = held_points(grid, piece, pin);
  for (const Vec2& point : hold.points) hold.at.push_back(grid_locate(grid, point));
  return hold;
}

}  // namespace drape
