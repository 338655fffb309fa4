#include "picture.h"

#include <algorithm>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>

#include "piece/hold.h"

namespace drape {
namespace {

constexpr double kHeight = 400, kMargin = 30;  // of the drawing, in its own units

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

pugi::xml_node append(pugi::xml_node parent, const char* tag,
                      std::initializer_list<std::pair<const char*, std::string>> attributes) {
  pugi::xml_node node = parent.append_child(tag);
  for (const auto& [name, value] : attributes) node.append_attribute(name).set_value(value.c_str());
  return node;
}

// From a piece's plane to the drawing, whose y axis points down.
struct View {
  double left, top, scale;  // x and y of the view's corner in the plane, drawing units per metre
  double offset;            // of the piece in the drawing

  double x(double plane_x) const { return offset + (plane_x - left) * scale; }
  double y(double plane_y) const { return kMargin + (top - plane_y) * scale; }
};

void draw_grid(pugi::xml_node parent, const Grid& grid, const View& view) {
  const double right = grid.x0 + (grid.columns - 1) * grid.cell, high = grid.y0 + (grid.rows - 1) * grid.cell;
  std::string path;
  const auto line = [&](double x1, double y1, double x2, double y2) {
    path += "M" + text_of(view.x(x1)) + " " + text_of(view.y(y1)) + "L" + text_of(view.x(x2)) + " " +
            text_of(view.y(y2));
  };
  for (int i = 0; i < grid.columns; ++i)
    line(grid.x0 + i * grid.cell, grid.y0, grid.x0 + i * grid.cell, high);
  for (int j = 0; j < grid.rows; ++j) line(grid.x0, grid.y0 + j * grid.cell, right, grid.y0 + j * grid.cell);
  append(parent, "path", {{"d", path}, {"stroke", "#b8c4d0"}, {"stroke-width", "0.5"}, {"fill", "none"}});
}

void draw_piece(pugi::xml_node svg, const Scene& scene, int index, const Grid& grid, const View& view) {
  const PieceSpec& piece = scene.pieces[std::size_t(index)];
  std::string outline;
  for (const Vec2& point : piece.outline)
    outline += text_of(view.x(point[0])) + "," + text_of(view.y(point[1])) + " ";
  append(svg, "polygon", {{"points", outline}, {"fill", "#eef2f6"}, {"stroke", "none"}});
  draw_grid(svg, grid, view);
  append(svg, "polygon",
         {{"points", outline}, {"fill", "none"}, {"stroke", "#203040"}, {"stroke-width", "1.5"}});
  append(svg, "text", {{"x", text_of(view.x(view.left))}, {"y", text_of(kMargin - 10)}})
      .text()
      .set(piece.name.c_str());
  for (const PinSpec& pin : scene.pins) {
    if (pin.piece != index) continue;
    for (const Vec2& point : hold_make(grid, scene, pin).points)
      append(svg, "rect",
             {{"x", text_of(view.x(point[0]) - 3)},
              {"y", text_of(view.y(point[1]) - 3)},
              {"width", "6"},
              {"height", "6"},
              {"fill", "#c03020"}})
          .append_child("title")
          .text()
          .set(("pin " + pin.name).c_str());
  }
  for (const ProbeSpec& probe : scene.probes)
    if (probe.piece == index)
      append(svg, "circle",
             {{"cx", text_of(view.x(probe.at[0]))},
              {"cy", text_of(view.y(probe.at[1]))},
              {"r", "4"},
              {"fill", "#2060c0"}})
          .append_child("title")
          .text()
          .set(("probe " + probe.name).c_str());
}

}  // namespace

std::string picture_svg(const Scene& scene) {
  std::vector<Grid> grids;
  double tallest = 0;
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    grids.push_back(grid_make(scene, int(p)));
    tallest = std::max(tallest, (grids.back().rows - 1) * grids.back().cell);
  }
  const double scale = (kHeight - 2 * kMargin) / tallest;
  pugi::xml_document document;
  pugi::xml_node svg =
      append(document, "svg", {{"xmlns", "http://www.w3.org/2000/svg"}, {"font-size", "14"}});
  double offset = kMargin;
  for (std::size_t p = 0; p < grids.size(); ++p) {
    const Grid& grid = grids[p];
    const View view{grid.x0, grid.y0 + (grid.rows - 1) * grid.cell, scale, offset};
    draw_piece(svg, scene, int(p), grid, view);
    offset += (grid.columns - 1) * grid.cell * scale + kMargin;
  }
  svg.append_attribute("viewBox").set_value(("0 0 " + text_of(offset) + " " + text_of(kHeight)).c_str());
  svg.append_attribute("width").set_value(text_of(offset).c_str());
  std::ostringstream text;
  document.save(text, " ", pugi::format_default | pugi::format_no_declaration);
  return text.str();
}

}  // namespace drape
