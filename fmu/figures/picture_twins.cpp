// Places with several nodes: each node is drawn shifted towards its own cloth, with a line to the place.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "figures/picture_draw.h"

namespace drape::figures {
namespace {

constexpr double kTwinShift = 0.24;  // cells, from the place

}  // namespace

void twins_draw(pugi::xml_node parent, const View& view) {
  const piece::Grid& grid = view.grid;
  std::set<int> nodes;
  for (int n = grid.columns * grid.rows; n < grid.nodes(); ++n) {
    const auto [i, j] = grid.index(n);
    nodes.insert({n, j * grid.columns + i});
  }
  std::map<int, std::vector<Vec2>> cloth;  // centres of the cells of these nodes
  const auto note = [&](const piece::GridCell& c, Vec2 centre) {
    for (const int n : c.node)
      if (nodes.contains(n)) cloth[n].push_back(centre);
  };
  for (const piece::GridCell& c : grid.cells)
    if (!piece::grid_is_cut(grid, c.i, c.j)) note(c, piece::grid_plane(grid, {c.i + 0.5, c.j + 0.5}));
  for (const piece::GridPart& part : grid.parts)
    note(grid.cells[std::size_t(part.cell)], piece::polygon_centre(part.loops[0]));
  for (const auto& [n, centres] : cloth) {
    const Vec2 at = grid.place(n);
    Vec2 way{0, 0};
    for (const Vec2& c : centres)
      for (std::size_t a = 0; a < 2; ++a) way[a] += (c[a] - at[a]) / double(centres.size());
    const double length = std::hypot(way[0], way[1]), step = length > 0 ? kTwinShift * grid.cell / length : 0;
    twin_mark(parent, view({at[0] + step * way[0], at[1] + step * way[1]}),
              view({at[0] + way[0], at[1] + way[1]}), std::clamp(0.1 * view.cell(), 0.8, 3.0),
              n >= grid.columns * grid.rows);
  }
}

void twin_mark(pugi::xml_node parent, Vec2 at, Vec2 cloth, double radius, bool twin) {
  svg_append(parent, "path",
             {{"class", "tail"},
              {"d", svg_path({at, cloth}, false)},
              {"stroke", kTwinInk},
              {"stroke-width", svg_number(radius / 3)}});
  svg_append(parent, "circle",
             {{"class", twin ? "twin" : "beside"},
              {"cx", svg_number(at[0])},
              {"cy", svg_number(at[1])},
              {"r", svg_number(radius)},
              {"fill", twin ? kTwinInk : "#ffffff"},
              {"stroke", kTwinInk},
              {"stroke-width", svg_number(radius / 3)}});
}

}  // namespace drape::figures
