#include "piece/grid/grid.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <unordered_map>

#include "piece/grid/merge.h"

namespace drape::piece {
namespace {

Vec2 turned(const Grid& grid, Vec2 p) {
  return {p[0] * grid.cosine + p[1] * grid.sine, p[1] * grid.cosine - p[0] * grid.sine};
}

bool is_curved(const scene::PieceSpec& piece, int edge) {
  return std::any_of(piece.curves.begin(), piece.curves.end(),
                     [&](const scene::CurveSpec& c) { return c.edge == edge; });
}

// The origin of the grid in the rotated plane: a point where grid lines cross.
Vec2 grid_origin(const Scene& scene, int index, const Grid& grid) {
  const scene::PieceSpec& piece = scene.pieces[std::size_t(index)];
  const std::size_t n = piece.outline.size();
  if (piece.grid_origin) return turned(grid, *piece.grid_origin);
  Vec2 origin = turned(grid, piece.outline[0]);
  bool aligned[2] = {false, false};
  for (const scene::PinSpec& pin : scene.pins)
    for (int edge : pin.edges) {
      if (pin.piece != index || is_curved(piece, edge)) continue;
      const Vec2 p = turned(grid, piece.outline[std::size_t(edge)]);
      const Vec2 q = turned(grid, piece.outline[(std::size_t(edge) + 1) % n]);
      const double contact = kSnap * std::max(piece.cell, std::hypot(q[0] - p[0], q[1] - p[1]));
      for (std::size_t a = 0; a < 2; ++a)
        if (!aligned[a] && std::abs(p[a] - q[a]) <= contact) origin[a] = p[a], aligned[a] = true;
    }
  return origin;
}

struct Build {
  const Cut& cut;
  const Merged& merged;
  Grid& grid;
  int i_low, j_low;                       // indices of the place of cell (0,0) in the cut
  std::unordered_map<long, int> twin_of;  // 4 part + corner -> node
  std::vector<int> cell_of;               // [parts]

  int i(int place) const { return place % cut.columns - i_low; }
  int j(int place) const { return place / cut.columns - j_low; }
  int node(PartRef part, int corner) const {
    const auto twin = twin_of.find(4L * part + corner);
    if (twin != twin_of.end()) return twin->second;
    const int place = part_place(cut, part);
    return (j(place) + corner / 2) * grid.columns + i(place) + corner % 2;
  }
};

// Calls `use` for each part or whole place that is a cell.
template <class Use>
void cells_of(const Build& b, int place, Use use) {
  const int first = b.cut.first[std::size_t(place)], parts = int(b.cut.parts.size());
  if (first == kPlaceWhole) use(PartRef(parts + place));
  if (first < 0 || b.grid.paper) return;
  for (int p = first; p < parts && b.cut.parts[std::size_t(p)].place == place; ++p)
    if (b.merged.into[std::size_t(p)] == p) use(p);
}

// Sets the numbers of rows and columns so that they contain all cells.
void rows_fit(Build& b, Vec2 origin) {
  int high_i = INT_MIN, high_j = INT_MIN;
  int low_i = INT_MAX, low_j = INT_MAX;
  for (int place = 0; place < int(b.cut.first.size()); ++place)
    cells_of(b, place, [&](PartRef) {
      low_i = std::min(low_i, place % b.cut.columns), high_i = std::max(high_i, place % b.cut.columns);
      low_j = std::min(low_j, place / b.cut.columns), high_j = std::max(high_j, place / b.cut.columns);
    });
  if (low_i > high_i) return;
  b.i_low = low_i;
  b.j_low = low_j;
  b.grid.columns = high_i - low_i + 2;
  b.grid.rows = high_j - low_j + 2;
  b.grid.x0 = origin[0] + (b.cut.i0 + low_i) * b.grid.cell;
  b.grid.y0 = origin[1] + (b.cut.j0 + low_j) * b.grid.cell;
}

// Makes twins. Where the parts around a node are not connected there, the set of parts with the largest area
// keeps the regular node, and each other set gets a twin.
void twins_fill(Build& b) {
  const int up = b.cut.columns;
  std::vector<int> places;  // places whose low corner is a corner of a cut place
  for (const CutPart& p : b.cut.parts)
    for (int step : {0, 1, up, up + 1}) places.push_back(p.place + step);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (int place : places) {
    const std::vector<std::vector<PartRef>> sets = corner_sets(b.cut, b.merged, place);
    if (sets.size() < 2) continue;
    std::vector<double> area(sets.size(), 0.0);
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (PartRef part : sets[s]) area[s] += part_share(b.cut, b.merged, part);
    const std::size_t largest = std::size_t(std::max_element(area.begin(), area.end()) - area.begin());
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if (s == largest) continue;
      for (PartRef part : sets[s]) {
        const int back = place - part_place(b.cut, part);
        b.twin_of[4L * part + (back == 0 ? 0 : back == 1 ? 1 : back == up ? 2 : 3)] = b.grid.nodes();
      }
      b.grid.twin.push_back({b.i(place), b.j(place)});
    }
  }
}

void cells_fill(Build& b) {
  std::vector<GridCell> others;
  std::vector<PartRef> other_parts;
  b.cell_of.assign(b.cut.parts.size(), -1);
  const int regular_nodes = b.grid.columns * b.grid.rows;
  for (int place = 0; place < int(b.cut.first.size()); ++place) {
    std::vector<GridCell>* list[] = {&b.grid.cells, &others};
    const std::size_t before[] = {b.grid.cells.size(), others.size()};
    cells_of(b, place, [&](PartRef part) {
      GridCell cell{b.i(place), b.j(place), {}, part_share(b.cut, b.merged, part)};
      for (int k = 0; k < 4; ++k) cell.node[k] = b.node(part, k);
      const bool other = std::any_of(cell.node, cell.node + 4, [&](int n) { return n >= regular_nodes; });
      std::vector<GridCell>& to = *list[other];
      std::size_t at = before[other];
      while (at < to.size() && !std::equal(cell.node, cell.node + 4, to[at].node)) ++at;
      if (at == to.size()) to.push_back(cell);
      else to[at].share += cell.share;
      if (part < int(b.cut.parts.size())) b.cell_of[std::size_t(part)] = other ? -2 - int(at) : int(at);
    });
  }
  b.grid.regular = int(b.grid.cells.size());
  for (int& cell : b.cell_of)
    if (cell < -1) cell = b.grid.regular - 2 - cell;
  b.grid.cells.insert(b.grid.cells.end(), others.begin(), others.end());
}

// Stores the parts in the plane of the outline, each with its cell.
void parts_fill(Build& b) {
  for (std::size_t p = 0; p < b.cut.parts.size(); ++p) {
    const CutPart& part = b.cut.parts[p];
    const PartRef into = b.merged.into[p];
    GridPart to{b.i(part.place), b.j(part.place), -1, part.loops};
    for (std::vector<Vec2>& loop : to.loops)
      for (Vec2& q : loop) q = grid_plane(b.grid, {q[0] + to.i, q[1] + to.j});
    if (b.grid.paper) {
      to.cell = grid_cell_of(b.grid, polygon_centre(to.loops[0]));
    } else if (into < int(b.cut.parts.size())) {
      to.cell = b.cell_of[std::size_t(into)];
    } else {
      const int place = part_place(b.cut, into);
      to.cell = grid_cell_at(b.grid, b.i(place), b.j(place));
    }
    b.grid.parts.push_back(std::move(to));
  }
}

// The particle closest to a point, by a search in rings around its place.
int particle_nearest(const Grid& grid, const std::vector<char>& particle, Vec2 at) {
  const int i = int(std::clamp(std::floor(at[0]), 0.0, grid.columns - 1.0));
  const int j = int(std::clamp(std::floor(at[1]), 0.0, grid.rows - 1.0));
  int best = -1;
  double smallest = INFINITY;
  for (int r = 0; r <= std::max(grid.columns, grid.rows) && smallest > r - 1.0; ++r)
    for (int row = std::max(0, j - r); row <= std::min(grid.rows - 1, j + r); ++row)
      for (int column = std::max(0, i - r); column <= std::min(grid.columns - 1, i + r); ++column) {
        const int n = row * grid.columns + column;
        const double d = std::hypot(column - at[0], row - at[1]);
        if (particle[std::size_t(n)] && d < smallest) best = n, smallest = d;
      }
  return best;
}

// outline = "paper": distributes the area of the strip outside the whole cells to the particles.
void strip_share(Build& b) {
  Grid& grid = b.grid;
  std::vector<char> particle;
  for (double a : grid.area) particle.push_back(a > 0);
  for (std::size_t p = 0; p < grid.parts.size(); ++p) {
    const GridPart& part = grid.parts[p];
    const double area = b.cut.parts[p].share * grid.cell * grid.cell;
    std::vector<std::size_t> corners;
    for (int k = 0; k < 4; ++k) {
      const int i = part.i + k % 2, j = part.j + k / 2;
      if (i < 0 || j < 0 || i >= grid.columns || j >= grid.rows) continue;
      if (const auto n = std::size_t(j * grid.columns + i); particle[n]) corners.push_back(n);
    }
    if (corners.empty())
      corners.push_back(std::size_t(
          particle_nearest(grid, particle, grid_coordinates(grid, polygon_centre(part.loops[0])))));
    for (std::size_t n : corners) grid.area[n] += area / double(corners.size());
  }
}

}  // namespace

Grid grid_make(const Scene& scene, int piece) {
  const scene::PieceSpec& spec = scene.pieces[std::size_t(piece)];
  Grid grid;
  grid.cell = spec.cell;
  grid.paper = scene.outline == scene::OutlineModel::kPaper;
  if (spec.grain != 0) grid.cosine = std::cos(spec.grain), grid.sine = std::sin(spec.grain);
  Vec2 origin = grid_origin(scene, piece, grid);
  const Vec2 first =
      turned(grid, spec.outline[0]);  // move a distant origin close to the piece, to keep precision
  for (std::size_t a = 0; a < 2; ++a) origin[a] += spec.cell * std::round((first[a] - origin[a]) / spec.cell);

  std::vector<std::vector<Vec2>> loops;
  for (const OutlineLoop& loop : outline_flatten(spec)) {
    loops.emplace_back();
    for (const Vec2& p : loop.points) {
      const Vec2 q = turned(grid, p);
      loops.back().push_back(
          {cut_snapped((q[0] - origin[0]) / spec.cell), cut_snapped((q[1] - origin[1]) / spec.cell)});
    }
  }
  const Cut cut = cut_make(loops);
  const Merged merged = grid.paper ? merge_none(cut) : merge_make(cut);
  Build build{cut, merged, grid, 0, 0, {}, {}};
  rows_fit(build, origin);
  if (grid.columns == 0) return grid;
  if (!grid.paper) twins_fill(build);
  cells_fill(build);
  grid.area.assign(std::size_t(grid.nodes()), 0.0);
  for (const GridCell& c : grid.cells)
    for (int n : c.node) grid.area[std::size_t(n)] += grid.cell * grid.cell * c.share / 4;
  parts_fill(build);
  if (grid.paper) strip_share(build);
  return grid;
}

}  // namespace drape::piece
