// The grid of a piece: nodes along the threads, the share of each cell inside the outline. See
// core/README.md, section 1.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace drape {

struct Grid {
  double cell = 0;            // b, m
  double x0 = 0, y0 = 0;      // node (0,0) in the piece's plane, m
  int columns = 0, rows = 0;  // nodes along weft (x) and warp (y)
  std::vector<double> share;  // [(rows-1) x (columns-1)] phi, row-major

  double share_at(int i, int j) const {  // phi(i,j); 0 outside the grid
    return i < 0 || j < 0 || i >= columns - 1 || j >= rows - 1 ? 0.0
                                                               : share[std::size_t(j) * (columns - 1) + i];
  }
  double node_share(int i, int j) const {  // s(i,j): node mass over rho b^2
    return (share_at(i - 1, j - 1) + share_at(i, j - 1) + share_at(i - 1, j) + share_at(i, j)) / 4;
  }
};

// The grid of a piece; pinned edges of it decide on which side a cut row lies.
Grid grid_make(const Scene& scene, int piece);

// Where a point of the piece sits: r(point) = sum_k weight[k] r(i[k], j[k]) over 4 corners of a cell.
struct GridPoint {
  int i[4], j[4];
  double weight[4];  // sum 1; exact zeros where the point lies on a grid line or node
};
GridPoint grid_locate(const Grid& grid, Vec2 point);

// The points at which a pin holds the cloth: its own points, or its edges' corners and crossings with
// threads, without duplicates.
std::vector<Vec2> pin_points(const Grid& grid, const PieceSpec& piece, const PinSpec& pin);

// A point of the piece's plane, placed in space.
inline Vec3 place_point(const PlaceSpec& p, Vec2 q) {
  Vec3 r;
  for (int k = 0; k < 3; ++k) r[k] = p.origin[k] + q[0] * p.axis_x[k] + q[1] * p.axis_y[k];
  return r;
}

}  // namespace drape
