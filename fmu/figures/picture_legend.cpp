// The scale and the meaning of the marks that occur.
#include <algorithm>
#include <cmath>
#include <functional>

#include "figures/picture_draw.h"

namespace drape::figures {
namespace {

constexpr double kLine = 24;

struct Item {
  double width;  // of its mark
  std::string text;
  std::function<void(Vec2)> draw;  // to the right of its left middle
};

std::vector<Item> cell_items(pugi::xml_node parent, const Scene& scene,
                             const std::vector<piece::Grid>& grids) {
  const auto square = [parent](Vec2 at, const std::string& colour) {
    svg_append(parent, "rect",
               {{"x", svg_number(at[0])},
                {"y", svg_number(at[1] - 6)},
                {"width", "12"},
                {"height", "12"},
                {"fill", colour},
                {"stroke", kLineInk},
                {"stroke-width", "0.7"}});
  };
  std::vector<Item> items;
  const bool paper = scene.outline == scene::OutlineModel::kPaper;
  const auto any = [&](auto is) { return std::any_of(grids.begin(), grids.end(), is); };
  const auto has_whole = [](const piece::Grid& g) {
    return std::any_of(g.cells.begin(), g.cells.end(),
                       [&](const piece::GridCell& c) { return !piece::grid_is_cut(g, c.i, c.j); });
  };
  if (any(has_whole)) items.push_back({12, "whole cell", [square](Vec2 at) { square(at, kClothInk); }});
  if (any([](const piece::Grid& g) { return !g.parts.empty(); })) {
    if (paper) items.push_back({12, "mass only", [square](Vec2 at) { square(at, kStripInk); }});
    else
      items.push_back(
          {48, "share of a cell that the outline cuts: 0.25, 0.5, 0.75, 1 or more", [square](Vec2 at) {
             for (int k = 0; k < 4; ++k) square({at[0] + 12 * k, at[1]}, share_colour(0.25 * (k + 1)));
           }});
  }
  if (any([](const piece::Grid& g) { return !g.twin.empty(); }))
    items.push_back({30, "particle and its twin at one place, with their cloth", [parent](Vec2 at) {
                       twin_mark(parent, {at[0] + 11, at[1]}, {at[0], at[1]}, 3, false);
                       twin_mark(parent, {at[0] + 19, at[1]}, {at[0] + 30, at[1]}, 3, true);
                     }});
  return items;
}

void hold_draw(pugi::xml_node parent, Vec2 at, bool clamp) {
  point_mark(parent, {at[0] + 4, at[1]}, 7, clamp);
  edge_mark(parent, {{at[0] + 15, at[1] - 2}, {at[0] + 40, at[1] - 2}}, clamp);
  const double left = at[0] + 48, right = at[0] + 64, high = at[1] - 6, low = at[1] + 6;
  region_mark(parent, svg_path({{left, high}, {right, high}, {right, low}, {left, low}}, true), clamp);
}

std::vector<Item> pin_items(pugi::xml_node parent, const Scene& scene) {
  const std::vector<scene::PinSpec>& pins = scene.pins;
  const auto any = [&](auto is) { return std::any_of(pins.begin(), pins.end(), is); };
  std::vector<Item> items;
  for (const bool clamp : {false, true})
    if (any([&](const scene::PinSpec& pin) { return pin.clamp == clamp; }))
      items.push_back({64, std::string(clamp ? "clamp" : "pin") + ": points, edges, region",
                       [parent, clamp](Vec2 at) { hold_draw(parent, at, clamp); }});
  if (any([](const scene::PinSpec& pin) { return pin.at.empty(); }))
    items.push_back(
        {4, "held by an edge or region", [parent](Vec2 at) { held_mark(parent, {{at[0] + 2, at[1]}}, 4); }});
  if (any([](const scene::PinSpec& pin) { return pin.drive != scene::Drive::kNone; }))
    items.push_back({20, "driven pin", [parent](Vec2 at) { drive_mark(parent, {at[0] + 10, at[1]}, 10); }});
  if (!scene.seams.empty())
    items.push_back({40, "seam, its particles and its start", [parent](Vec2 at) {
                       const double x = at[0] + 5;
                       seam_mark(parent, {{x, at[1]}, {x + 34, at[1]}},
                                 {{x, at[1]}, {x + 11, at[1]}, {x + 22, at[1]}, {x + 33, at[1]}});
                     }});
  if (!scene.probes.empty())
    items.push_back({10, "probe", [parent](Vec2 at) { probe_mark(parent, {at[0] + 5, at[1]}); }});
  return items;
}

// The longest of 1, 2 and 5 times a power of ten that takes at most 130 units.
Item scale_item(pugi::xml_node parent, double scale) {
  const double largest = 130 / scale, power = std::pow(10, std::floor(std::log10(largest)));
  const double length = power * (largest >= 5 * power ? 5 : largest >= 2 * power ? 2 : 1);
  const double per_unit = length >= 1 ? 1 : length > 0.009 ? 100 : 1000;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g %s", length * per_unit,
                per_unit == 1     ? "m"
                : per_unit == 100 ? "cm"
                                  : "mm");
  const double width = length * scale;
  return {width, text, [parent, width](Vec2 at) {
            const double left = at[0], right = at[0] + width, y = at[1];
            const std::vector<Vec2> bar = {{left, y - 4}, {left, y + 4},  {left, y},
                                           {right, y},    {right, y - 4}, {right, y + 4}};
            svg_append(parent, "path",
                       {{"class", "scale"},
                        {"d", svg_path(bar, false)},
                        {"fill", "none"},
                        {"stroke", kInk},
                        {"stroke-width", "1.6"}});
          }};
}

}  // namespace

double text_width(const std::string& text) { return 6.4 * double(text.size()); }

double legend_draw(pugi::xml_node parent, const Scene& scene, const std::vector<piece::Grid>& grids,
                   double scale, Vec2 corner, double right) {
  std::vector<Item> items = {scale_item(parent, scale)};
  for (const auto& more : {cell_items(parent, scene, grids), pin_items(parent, scene)})
    items.insert(items.end(), more.begin(), more.end());
  Vec2 at{corner[0], corner[1] + kLine / 2};
  for (const Item& item : items) {
    const double width = item.width + 7 + text_width(item.text);
    if (at[0] > corner[0] && at[0] + width > right) at = {corner[0], at[1] + kLine};
    item.draw(at);
    svg_text(parent, {at[0] + item.width + 7, at[1] + 4}, item.text, {{"font-size", "12"}, {"fill", kInk}});
    at[0] += width + 20;
  }
  return at[1] + kLine / 2 - corner[1];
}

}  // namespace drape::figures
