#include "figures/picture.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "figures/picture_draw.h"

namespace drape::figures {
namespace {

// Lengths in units of the drawing.
constexpr double kTallest = 460, kTallestOfSeveral = 320, kWidest = 900;  // piece
constexpr double kRow = 1100;  // pieces side by side, before the next row begins
constexpr double kMargin = 24, kHead = 46, kArrow = 17;

// The text above the piece.
std::vector<std::string> head_of(const View& view) {
  std::size_t particles = 0;
  for (const double area : view.grid.area) particles += area > 0;
  char text[96];
  std::snprintf(text, sizeof text, "cell %.6g mm, %zu particles", 1e3 * view.grid.cell, particles);
  return {view.scene.pieces[std::size_t(view.piece)].name, text};
}

double head_width(const View& view) {
  const std::vector<std::string> head = head_of(view);
  return std::max(text_width(head[0]) * 1.25, text_width(head[1])) + 40 + text_width("warp") + 2 * kArrow;
}

void head_draw(pugi::xml_node parent, const View& view, Vec2 corner) {
  const std::vector<std::string> head = head_of(view);
  svg_text(parent, {corner[0], corner[1] + 14}, head[0],
           {{"font-size", "15"}, {"font-weight", "bold"}, {"fill", kInk}});
  svg_text(parent, {corner[0], corner[1] + 31}, head[1], {{"font-size", "12"}, {"fill", kInk}});
  const Vec2 middle{corner[0] + head_width(view) - kArrow, corner[1] + 18};
  const double x = -view.grid.sine, y = -view.grid.cosine;  // along the warp; the drawing's y points down
  const auto point = [&](double along, double across) {
    return Vec2{middle[0] + along * x - across * y, middle[1] + along * y + across * x};
  };
  svg_append(parent, "path",
             {{"class", "warp"},
              {"d", svg_path({point(-kArrow, 0), point(kArrow, 0)}, false) +
                        svg_path({point(kArrow - 6, -4), point(kArrow, 0), point(kArrow - 6, 4)}, false)},
              {"fill", "none"},
              {"stroke", kInk},
              {"stroke-width", "1.6"}});
  svg_text(parent, {middle[0] - kArrow - 4, middle[1] + 4}, "warp",
           {{"font-size", "12"}, {"fill", kInk}, {"text-anchor", "end"}});
}

struct Size {
  double width, height;
};
Size size_of(const View& view) {
  return {(view.high[0] - view.low[0]) * view.scale, (view.high[1] - view.low[1]) * view.scale};
}

// Places pieces side by side, in rows. Returns the size of the whole.
Size views_place(std::vector<View>& views) {
  Size whole{0, 0};
  Vec2 at{kMargin, kMargin};
  double tallest = 0;
  for (View& view : views) {
    const Size size = size_of(view);
    const double width = std::max(size.width, head_width(view));
    if (at[0] > kMargin && at[0] + width > kRow) {
      at = {kMargin, at[1] + kHead + tallest + kMargin};
      tallest = 0;
    }
    view.corner = {at[0], at[1] + kHead};
    tallest = std::max(tallest, size.height);
    at[0] += width + 2 * kMargin;
    whole = {std::max(whole.width, at[0] - kMargin), at[1] + kHead + tallest + kMargin};
  }
  return whole;
}

void hatch_define(pugi::xml_node svg) {
  const pugi::xml_node pattern = svg_append(svg_append(svg, "defs", {}), "pattern",
                                            {{"id", "drape-hatch"},
                                             {"width", "6"},
                                             {"height", "6"},
                                             {"patternUnits", "userSpaceOnUse"},
                                             {"patternTransform", "rotate(45)"}});
  for (const auto& [width, opacity] : {std::pair{"6", "0.18"}, {"1.5", "0.7"}})
    svg_append(pattern, "rect",
               {{"width", width}, {"height", "6"}, {"fill", kPinInk}, {"fill-opacity", opacity}});
}

}  // namespace

View view_make(const Scene& scene, int piece, const piece::Grid& grid) {
  View view{scene, piece, grid, piece::outline_flatten(scene.pieces[std::size_t(piece)]), {}, {}, 1, {}};
  view.low = view.high = view.loops[0].points[0];
  const auto include = [&](Vec2 p) {
    for (std::size_t a = 0; a < 2; ++a)
      view.low[a] = std::min(view.low[a], p[a]), view.high[a] = std::max(view.high[a], p[a]);
  };
  for (const Vec2& p : view.loops[0].points) include(p);
  for (int n = 0; n < grid.nodes(); ++n)
    if (grid.area[std::size_t(n)] > 0) include(grid.place(n));
  return view;
}

std::string picture_svg(const Scene& scene) {
  std::vector<piece::Grid> grids;
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) grids.push_back(piece::grid_make(scene, int(p)));
  std::vector<View> views;
  const double tallest = grids.size() > 1 ? kTallestOfSeveral : kTallest;
  double scale = INFINITY;
  for (std::size_t p = 0; p < grids.size(); ++p) {
    views.push_back(view_make(scene, int(p), grids[p]));
    const Size size = size_of(views[p]);
    scale = std::min({scale, tallest / size.height, kWidest / size.width});
  }
  for (View& view : views) view.scale = scale;
  const Size whole = views_place(views);

  pugi::xml_document document;
  pugi::xml_node svg =
      svg_append(document, "svg", {{"xmlns", "http://www.w3.org/2000/svg"}, {"font-family", "sans-serif"}});
  hatch_define(svg);
  for (const View& view : views) {
    const pugi::xml_node group = svg_append(svg, "g", {{"class", "piece"}});
    head_draw(group, view, {view.corner[0], view.corner[1] - kHead});
    cells_draw(group, view);
    twins_draw(group, view);
    seams_draw(group, view);
    pins_draw(group, view);
    probes_draw(group, view);
  }
  const double width = std::max(whole.width, 560.0);
  const double legend = legend_draw(svg, scene, grids, scale, {kMargin, whole.height}, width - kMargin);
  const std::string height = svg_number(whole.height + legend + 8);
  svg.append_attribute("viewBox").set_value(("0 0 " + svg_number(width) + " " + height).c_str());
  svg.append_attribute("width").set_value(svg_number(width).c_str());
  std::ostringstream text;
  document.save(text, " ", pugi::format_default | pugi::format_no_declaration);
  return text.str();
}

}  // namespace drape::figures
