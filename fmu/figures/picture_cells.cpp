// The cells that the grid makes of a piece. A whole cell has the colour of the cloth; a part has the colour
// of its cell's share. A part merged into a neighbour has the neighbour's colour, and no line between them.
// The corners of cut cells outside the outline are particles too: their cells are drawn beyond the outline
// as faint squares.
#include <algorithm>
#include <cmath>
#include <set>

#include "figures/picture_draw.h"

namespace drape::figures {
namespace {

constexpr double kBeyond = 1e-6;  // cells: how far beyond a line the neighbour is searched

std::string line_width(const View& view) { return svg_number(std::clamp(0.05 * view.cell(), 0.2, 0.9)); }

Vec2 corner_of(const piece::Grid& grid, int i, int j) {
  return piece::grid_plane(grid, {double(i), double(j)});
}

std::vector<Vec2> square_of(const piece::Grid& grid, int i, int j) {
  return {corner_of(grid, i, j), corner_of(grid, i + 1, j), corner_of(grid, i + 1, j + 1),
          corner_of(grid, i, j + 1)};
}

void squares_draw(pugi::xml_node parent, const View& view) {
  std::set<std::array<int, 2>> places;
  for (const piece::GridCell& c : view.grid.cells)
    if (piece::grid_is_cut(view.grid, c.i, c.j)) places.insert({c.i, c.j});
  std::string path;
  for (const auto& [i, j] : places) path += view.path(square_of(view.grid, i, j), true);
  svg_append(parent, "path",
             {{"class", "squares"},
              {"d", path},
              {"stroke", kGhostInk},
              {"stroke-width", line_width(view)},
              {"fill", "none"}});
}

void fill(pugi::xml_node parent, const char* kind, const std::string& path, const std::string& colour,
          const std::string& title) {
  svg_title(svg_append(parent, "path",
                       {{"class", kind},
                        {"d", path},
                        {"fill", colour},
                        {"fill-rule", "evenodd"},
                        {"stroke", colour},
                        {"stroke-width", "0.4"}}),
            title);
}

// Draws the parts, and whole cells that have merged parts.
void parts_draw(pugi::xml_node parent, const View& view) {
  const piece::Grid& grid = view.grid;
  if (!grid.paper)
    for (const piece::GridCell& c : grid.cells)
      if (!piece::grid_is_cut(grid, c.i, c.j) && c.share > 1)
        fill(parent, "taker", view.path(square_of(grid, c.i, c.j), true), share_colour(c.share),
             "share " + svg_number(c.share));
  for (const piece::GridPart& part : grid.parts) {
    const piece::GridCell& c = grid.cells[std::size_t(part.cell)];
    std::string path;
    for (const std::vector<Vec2>& loop : part.loops) path += view.path(loop, true);
    if (grid.paper) fill(parent, "part", path, kStripInk, "mass only");
    else
      fill(parent, "part", path, share_colour(c.share),
           (piece::grid_is_merged(grid, part) ? "merged, share " : "share ") + svg_number(c.share));
  }
}

// Lines between whole cells, each drawn as far as it runs straight.
std::string whole_lines(const View& view) {
  const piece::Grid& grid = view.grid;
  const int columns = grid.columns - 1, rows = grid.rows - 1;  // of cells
  std::vector<char> whole(std::size_t(columns) * std::size_t(rows));
  for (int c = 0; c < grid.regular; ++c) {
    const piece::GridCell& cell = grid.cells[std::size_t(c)];
    whole[std::size_t(cell.j * columns + cell.i)] = !piece::grid_is_cut(grid, cell.i, cell.j);
  }
  std::string path;
  for (const bool along_weft : {true, false}) {
    const int lines = along_weft ? rows : columns, length = along_weft ? columns : rows;
    const auto at = [&](int line, int k) {
      return whole[std::size_t(along_weft ? line * columns + k : k * columns + line)];
    };
    const auto corner = [&](int line, int k) {
      return along_weft ? corner_of(grid, k, line) : corner_of(grid, line, k);
    };
    for (int line = 1; line < lines; ++line)
      for (int k = 0, begin = 0; k <= length; ++k) {
        if (k < length && at(line - 1, k) && at(line, k)) continue;
        if (k > begin) path += view.path({corner(line, begin), corner(line, k)}, false);
        begin = k + 1;
      }
  }
  return path;
}

// The sides of parts with another cell beyond them.
std::string part_lines(const View& view) {
  const piece::Grid& grid = view.grid;
  std::string path;
  for (const piece::GridPart& part : grid.parts)
    for (const std::vector<Vec2>& loop : part.loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 p = piece::grid_coordinates(grid, loop[k]);
        const Vec2 q = piece::grid_coordinates(grid, loop[(k + 1) % loop.size()]);
        for (std::size_t a = 0; a < 2; ++a) {
          if (p[a] != q[a] || p[a] != std::floor(p[a])) continue;
          Vec2 beyond{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};  // the part lies to the left of p -> q
          beyond[a] += (a == 0) == (q[1 - a] > p[1 - a]) ? kBeyond : -kBeyond;
          if (grid.paper || piece::grid_cell_of(grid, piece::grid_plane(grid, beyond)) != part.cell)
            path += view.path({piece::grid_plane(grid, p), piece::grid_plane(grid, q)}, false);
        }
      }
  return path;
}

}  // namespace

std::string share_colour(double share) {
  constexpr double kNone[] = {232, 140, 50}, kWhole[] = {253, 243, 222};
  const double t = std::clamp(share, 0.0, 1.0);
  std::string colour;
  for (int k = 0; k < 3; ++k)
    colour += (k ? "," : "rgb(") + std::to_string(std::lround(kNone[k] + t * (kWhole[k] - kNone[k])));
  return colour + ")";
}

void cells_draw(pugi::xml_node parent, const View& view) {
  squares_draw(parent, view);
  std::string outline;
  for (const piece::OutlineLoop& loop : view.loops) outline += view.path(loop.points, true);
  const std::string id = "drape-piece-" + std::to_string(view.piece);
  const pugi::xml_node clip = svg_append(parent, "clipPath", {{"id", id}});
  svg_append(clip, "path", {{"d", outline}, {"clip-rule", "evenodd"}});
  svg_append(parent, "path",
             {{"class", "cloth"}, {"d", outline}, {"fill", kClothInk}, {"fill-rule", "evenodd"}});
  const pugi::xml_node inside = svg_append(parent, "g", {{"clip-path", "url(#" + id + ")"}});
  parts_draw(inside, view);
  svg_append(inside, "path",
             {{"class", "grid"},
              {"d", whole_lines(view) + part_lines(view)},
              {"stroke", kLineInk},
              {"stroke-width", line_width(view)},
              {"fill", "none"}});
  svg_append(parent, "path",
             {{"class", "outline"},
              {"d", outline},
              {"fill", "none"},
              {"stroke", kInk},
              {"stroke-width", "1.3"},
              {"stroke-linejoin", "round"}});
}

}  // namespace drape::figures
