#include "piece/support/support.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "piece/support/edge_support.h"
#include "piece/support/region_support.h"

namespace drape::piece {
namespace {

// The centroid of edges, weighted by length.
Vec2 edges_centre(const std::vector<OutlineLoop>& loops, const std::vector<int>& edges) {
  const OutlineLoop& rim = loops[0];
  Vec2 sum{0, 0};
  double length = 0;
  for (std::size_t k = 0, n = rim.points.size(); k < n; ++k) {
    if (std::find(edges.begin(), edges.end(), rim.edge[k]) == edges.end()) continue;
    const Vec2 p = rim.points[k], q = rim.points[(k + 1) % n];
    const double part = std::hypot(q[0] - p[0], q[1] - p[1]);
    for (std::size_t a = 0; a < 2; ++a) sum[a] += part * (p[a] + q[a]) / 2;
    length += part;
  }
  return {sum[0] / length, sum[1] / length};
}

Vec2 mean(const std::vector<Vec2>& points) {
  Vec2 sum{0, 0};
  for (const Vec2& p : points)
    for (std::size_t a = 0; a < 2; ++a) sum[a] += p[a] / double(points.size());
  return sum;
}

// Adds points, given in cells, each once.
void points_add(Support& support, const Grid& grid, std::vector<Vec2> at) {
  std::sort(at.begin(), at.end(), [](Vec2 p, Vec2 q) { return p[1] != q[1] ? p[1] < q[1] : p[0] < q[0]; });
  at.erase(std::unique(at.begin(), at.end()), at.end());
  for (const Vec2& p : at) {
    support.points.push_back(grid_plane(grid, p));
    support.at.push_back(grid_locate(grid, support.points.back()));
  }
}

// Appends all links of a node.
void node_slopes(const Grid& grid, int node, std::vector<HeldSlope>& slopes) {
  std::map<int, bool> links;  // the other node -> along the warp
  const auto cell_links = [&](const GridCell& c) {
    for (int k = 0; k < 4; ++k)
      if (c.node[k] == node) links.emplace(c.node[k ^ 1], false), links.emplace(c.node[k ^ 2], true);
  };
  const auto rows_end = grid.cells.begin() + grid.regular;
  const auto [column, row] = grid.index(node);
  for (int j : {row - 1, row}) {
    auto c = std::lower_bound(grid.cells.begin(), rows_end, std::pair{j, column - 1},
                              [](const GridCell& a, auto at) { return std::pair{a.j, a.i} < at; });
    for (; c != rows_end && c->j == j && c->i <= column; ++c) cell_links(*c);
  }
  std::for_each(rows_end, grid.cells.end(), cell_links);
  for (const auto& [to, warp] : links) slopes.push_back({node, to, warp, 1, 1, true});
}

// Appends the links of the cell that contains a point, each with its weight.
void cell_slopes(const Grid& grid, Vec2 point, std::vector<HeldSlope>& slopes) {
  const GridCell& c = grid.cells[std::size_t(grid_cell_of(grid, point))];
  const Vec2 at = grid_coordinates(grid, point);
  const double x = std::clamp(at[0] - c.i, 0.0, 1.0), y = std::clamp(at[1] - c.j, 0.0, 1.0);
  const HeldSlope links[] = {{c.node[0], c.node[2], true, 1 - x, 1, false},
                             {c.node[1], c.node[3], true, x, 1, false},
                             {c.node[0], c.node[1], false, 1 - y, 1, false},
                             {c.node[2], c.node[3], false, y, 1, false}};
  for (const HeldSlope& link : links)
    if (link.clamp > 0) slopes.push_back(link);
}

void point_slopes(const Grid& grid, const Support& support, std::vector<HeldSlope>& slopes) {
  for (std::size_t k = 0; k < support.points.size(); ++k) {
    const double* weight = support.at[k].weight;
    const double* whole = std::find(weight, weight + 4, 1.0);
    if (whole != weight + 4) node_slopes(grid, support.at[k].node[whole - weight], slopes);
    else cell_slopes(grid, support.points[k], slopes);
  }
}

// Selects the crossings of an edge that are supported: those of the yarns that run closer to the normal of
// the edge. Each such yarn has two nodes next to the edge, of which one motion remains free. If the crossings
// of the other yarns were supported too, no motion would remain, and the first row of cloth inside would be
// fixed as if it were in the jaw.
bool crossing_is_supported(const EdgeCrossing& crossing) {
  constexpr double kEqual = 1e-9;  // tolerance at 45 degrees
  const std::size_t line = std::abs(crossing.along[0]) >= (1 - kEqual) * std::abs(crossing.along[1]) ? 0 : 1;
  return crossing.at[line] == std::floor(crossing.at[line]);
}

void edges_add(Support& support, const Grid& grid, const scene::PieceSpec& piece, const scene::PinSpec& pin) {
  const std::vector<OutlineLoop> loops = outline_flatten(piece);
  std::vector<Vec2> at;
  for (int edge : pin.edges) {
    for (const Vec2& end : edge_ends(grid, piece, edge)) at.push_back(end);
    for (const EdgeCrossing& crossing : edge_crossings(grid, loops, edge))
      if (crossing_is_supported(crossing)) at.push_back(crossing.at);
    if (pin.clamp) edge_slopes(grid, loops, edge, support.slopes);
  }
  points_add(support, grid, std::move(at));
  support.centre = edges_centre(loops, pin.edges);
}

}  // namespace

Support support_make(const Grid& grid, const Scene& scene, const scene::PinSpec& pin) {
  Support support;
  if (!pin.region.empty()) {
    RegionSupport region = region_support(grid, pin.region, pin.clamp);
    for (int n : region.nodes) {
      support.points.push_back(grid.place(n));
      support.at.push_back({{n, n, n, n}, {1, 0, 0, 0}});
    }
    support.slopes = std::move(region.slopes);
    support.centre = polygon_centre(pin.region);
  } else if (!pin.edges.empty()) {
    edges_add(support, grid, scene.pieces[std::size_t(pin.piece)], pin);
  } else {
    std::vector<Vec2> at;
    for (const Vec2& p : pin.at) at.push_back(grid_coordinates(grid, p));
    points_add(support, grid, std::move(at));
    if (pin.clamp) point_slopes(grid, support, support.slopes);
    support.centre = mean(pin.at);
  }
  return support;
}

}  // namespace drape::piece
