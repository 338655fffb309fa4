// The pieces of a cloth for the C interface.
#include "api/cloth.h"
#include "math/plain_environment.h"
#include "piece/grid/surface.h"
#include "seam/particles.h"

namespace drape::api {
namespace {

// The area, and the numbers of twins, of cut cells and of merged parts.
void counts_fill(const piece::Grid& grid, drape_cloth::Piece& piece) {
  for (const double a : grid.area) piece.area += a;
  piece.twins = int(grid.twin.size() - grid.on_outline.size());
  if (grid.paper) return;
  for (const piece::GridCell& cell : grid.cells) piece.cut += piece::grid_is_cut(grid, cell.i, cell.j);
  for (const piece::GridPart& part : grid.parts) piece.merged += piece::grid_is_merged(grid, part);
}

// The polygons along the outline. number [nodes of the grid]: the particle of each node.
void polygons_fill(const piece::Grid& grid, const std::vector<int>& number, drape_cloth::Piece& piece) {
  piece::Surface surface = piece::surface_make(grid);
  for (const piece::GridPoint& point : surface.points) {
    for (const int node : point.node) piece.point_node.push_back(number[std::size_t(node)]);
    piece.point_weight.insert(piece.point_weight.end(), point.weight, point.weight + 4);
  }
  for (const int c : surface.corner)
    piece.polygon_corner.push_back(c < grid.nodes() ? number[std::size_t(c)]
                                                    : piece.point_first + c - grid.nodes());
  piece.polygon_end = std::move(surface.end);
}

}  // namespace

void pieces_describe(drape_cloth& c) {
  const std::vector<piece::Grid> grids = seam::grids_make(c.scene);
  int particle = 0, point = int(c.system.particle.size());
  for (const model::Lattice& l : c.system.lattices) {
    const piece::Grid& grid = grids[std::size_t(l.piece)];
    drape_cloth::Piece piece;
    piece.first = particle;
    piece.point_first = point;
    std::vector<int> number(std::size_t(grid.nodes()), -1);
    for (int n = 0; n < grid.nodes(); ++n) {
      if (grid.area[std::size_t(n)] == 0) continue;
      number[std::size_t(n)] = particle++;
      const Vec2 place = grid.place(n);
      piece.rest.insert(piece.rest.end(), place.begin(), place.end());
    }
    for (const piece::GridCell& cell : grid.cells)
      for (int k : {0, 1, 3, 2}) piece.corner.push_back(number[std::size_t(cell.node[k])]);
    polygons_fill(grid, number, piece);
    counts_fill(grid, piece);
    point += int(piece.point_node.size() / 4);
    c.pieces.push_back(std::move(piece));
  }
}

}  // namespace drape::api

int drape_piece_count(const drape_cloth* c) { return int(c->system.lattices.size()); }

drape_piece drape_piece_at(drape_cloth* c, int index) {
  const drape::math::PlainEnvironment plain;
  if (c->pieces.empty()) drape::api::pieces_describe(*c);
  const drape::model::Lattice& l = c->system.lattices[std::size_t(index)];
  const drape_cloth::Piece& p = c->pieces[std::size_t(index)];
  return {c->scene.pieces[std::size_t(l.piece)].name.c_str(),
          l.cell,
          p.first,
          int(p.rest.size() / 2),
          p.rest.data(),
          int(p.corner.size() / 4),
          p.corner.data(),
          p.point_first,
          int(p.point_node.size() / 4),
          p.point_node.data(),
          p.point_weight.data(),
          int(p.polygon_end.size()),
          p.polygon_end.data(),
          p.polygon_corner.data(),
          p.cut,
          p.merged,
          p.twins,
          p.area,
          l.fabric};
}
