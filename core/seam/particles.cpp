#include "seam/particles.h"

#include <algorithm>
#include <cmath>

#include "seam/layout.h"

namespace drape::seam {
namespace {

constexpr double kReach = 1.5;   // cells, largest length of a tie [P]
constexpr std::size_t kMin = 3;  // smallest number of ties of a particle, if need be beyond kReach
constexpr double kSame = 1e-9;   // cells: particles closer than this are the same

double distance(Vec2 p, Vec2 q) { return std::hypot(q[0] - p[0], q[1] - p[1]); }

// Nodes with fewer than four cells around them.
std::vector<int> edge_of(const piece::Grid& grid) {
  std::vector<int> cells(grid.area.size(), 0), edge;
  for (const piece::GridCell& c : grid.cells)
    for (int n : c.node) ++cells[std::size_t(n)];
  for (std::size_t n = 0; n < cells.size(); ++n)
    if (cells[n] > 0 && cells[n] < 4) edge.push_back(int(n));
  return edge;
}

// The edge nodes to which a point is tied, the closest first.
std::vector<int> ties_of(const piece::Grid& grid, const std::vector<int>& edge, Vec2 point) {
  std::vector<std::pair<double, int>> near;
  for (int n : edge)
    if (const double d = distance(grid.place(n), point); d > kSame * grid.cell) near.push_back({d, n});
  std::sort(near.begin(), near.end());
  std::vector<int> tied;
  for (const auto& [d, n] : near)
    if (d <= kReach * grid.cell * (1 + kSame) || tied.size() < kMin) tied.push_back(n);
  return tied;
}

void tie_add(std::vector<GridTie>& ties, const piece::Grid& grid, int particle, int edge, int pair) {
  for (const GridTie& t : ties)
    if ((t.node[0] == particle && t.node[1] == edge) || (t.node[0] == edge && t.node[1] == particle)) return;
  ties.push_back({{particle, edge}, pair, distance(grid.place(particle), grid.place(edge))});
}

// Adds the ties of the particle at a point, and the particle itself where there is none yet.
void particle_add(piece::Grid& grid, const std::vector<int>& edge, Vec2 point, int pair,
                  std::vector<GridTie>& ties) {
  int particle = seam_particle(grid, point);
  if (particle < 0) {
    const Vec2 at = piece::grid_coordinates(grid, point);
    grid.twin.push_back({int(std::clamp(std::round(at[0]), 0.0, grid.columns - 1.0)),
                         int(std::clamp(std::round(at[1]), 0.0, grid.rows - 1.0))});
    grid.on_outline.push_back(point);
    grid.area.push_back(0);
    particle = grid.nodes() - 1;
  }
  for (int n : ties_of(grid, edge, point)) tie_add(ties, grid, particle, n, pair);
}

// Moves a share of the area of each tied edge node to the particles on the outline.
void areas_share(piece::Grid& grid, const std::vector<GridTie>& ties) {
  const int first = grid.nodes() - int(grid.on_outline.size());
  std::vector<int> count(grid.area.size(), 0);
  for (const GridTie& t : ties) count[std::size_t(t.node[1])] += t.node[0] >= first;
  for (const GridTie& t : ties)
    if (t.node[0] >= first)
      grid.area[std::size_t(t.node[0])] +=
          (1 - kEdgeKeeps) * grid.area[std::size_t(t.node[1])] / count[std::size_t(t.node[1])];
  for (std::size_t n = 0; n < count.size(); ++n)
    if (count[n] > 0) grid.area[n] *= kEdgeKeeps;
}

}  // namespace

int seam_particle(const piece::Grid& grid, Vec2 point) {
  const double same = kSame * grid.cell;
  const Vec2 at = piece::grid_coordinates(grid, point);
  const double i = std::round(at[0]), j = std::round(at[1]);
  if (i >= 0 && j >= 0 && i < grid.columns && j < grid.rows) {
    const int n = int(j) * grid.columns + int(i);
    if (grid.area[std::size_t(n)] > 0 && distance(grid.place(n), point) <= same) return n;
  }
  for (std::size_t k = 0; k < grid.on_outline.size(); ++k)
    if (distance(grid.on_outline[k], point) <= same)
      return grid.nodes() - int(grid.on_outline.size()) + int(k);
  return -1;
}

std::vector<piece::Grid> grids_make(const Scene& scene, std::vector<std::vector<GridTie>>* ties) {
  std::vector<piece::Grid> grids;
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) grids.push_back(piece::grid_make(scene, int(p)));
  std::vector<std::vector<GridTie>> all(grids.size());
  if (scene.outline == scene::OutlineModel::kPaper) {
    std::vector<std::vector<int>> edge;
    for (const piece::Grid& grid : grids) edge.push_back(edge_of(grid));
    int pair = 0;
    for (const scene::SeamSpec& seam : scene.seams) {
      const SeamLayout layout = seam_layout(scene, seam);
      for (std::size_t n = 0; n < layout.point[0].size(); ++n, ++pair)
        for (std::size_t k = 0; k < 2; ++k) {
          const auto p = std::size_t(seam.side[k].piece);
          particle_add(grids[p], edge[p], layout.point[k][n], pair, all[p]);
        }
    }
    for (std::size_t p = 0; p < grids.size(); ++p) areas_share(grids[p], all[p]);
  }
  if (ties) *ties = std::move(all);
  return grids;
}

}  // namespace drape::seam
