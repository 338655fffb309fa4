// The marks of pins, probes and seams, without a piece.
#include <algorithm>
#include <cmath>

#include "figures/picture_draw.h"

namespace drape::figures {
namespace {

constexpr double kTick = 7;  // between the ticks of a clamp, and their length

}  // namespace

void label_draw(pugi::xml_node parent, Vec2 at, Vec2 towards, double distance, const std::string& text,
                const char* colour) {
  const auto [x, y] = towards;
  const double length = std::max(1e-9, std::hypot(x, y));
  const Vec2 place{at[0] + distance * x / length, at[1] + distance * y / length + 4};
  const char* anchor = std::abs(x) < 0.4 * length ? "middle" : x > 0 ? "start" : "end";
  svg_text(parent, place, text,
           {{"font-size", "11"},
            {"fill", colour},
            {"text-anchor", anchor},
            {"stroke", "#ffffff"},
            {"stroke-width", "3"},
            {"paint-order", "stroke"},
            {"stroke-linejoin", "round"}});
}

// Particles are dots; the first is a ring.
void seam_mark(pugi::xml_node parent, const std::vector<Vec2>& line, const std::vector<Vec2>& particles) {
  svg_append(parent, "path",
             {{"class", "stitches"},
              {"d", svg_path(line, false)},
              {"fill", "none"},
              {"stroke", kSeamInk},
              {"stroke-width", "2.4"},
              {"stroke-linejoin", "round"}});
  for (std::size_t k = 0; k < particles.size(); ++k)
    svg_append(parent, "circle",
               {{"cx", svg_number(particles[k][0])},
                {"cy", svg_number(particles[k][1])},
                {"r", k == 0 ? "4.5" : "1.8"},
                {"fill", k == 0 ? "#ffffff" : kSeamInk},
                {"stroke", kSeamInk},
                {"stroke-width", k == 0 ? "1.8" : "0"}});
}

void point_mark(pugi::xml_node parent, Vec2 at, double size, bool clamp) {
  svg_append(parent, "rect",
             {{"class", "point"},
              {"x", svg_number(at[0] - size / 2)},
              {"y", svg_number(at[1] - size / 2)},
              {"width", svg_number(size)},
              {"height", svg_number(size)},
              {"fill", clamp ? kPinInk : "#ffffff"},
              {"stroke", kPinInk},
              {"stroke-width", "1.6"}});
}

pugi::xml_node region_mark(pugi::xml_node parent, const std::string& path, bool clamp) {
  return svg_append(parent, "path",
                    {{"class", "region"},
                     {"d", path},
                     {"fill", clamp ? "url(#drape-hatch)" : kPinInk},
                     {"fill-opacity", clamp ? "0.8" : "0.2"},
                     {"stroke", kPinInk},
                     {"stroke-width", "2"}});
}

// The points that a pin over an edge or a region holds.
void held_mark(pugi::xml_node parent, const std::vector<Vec2>& points, double size) {
  std::string path;
  for (const auto& [x, y] : points) {
    const double left = x - size / 2, right = x + size / 2, high = y - size / 2, low = y + size / 2;
    path += svg_path({{left, high}, {right, high}, {right, low}, {left, low}}, true);
  }
  svg_append(parent, "path", {{"class", "held"}, {"d", path}, {"fill", kPinInk}});
}

// A clamp has ticks on the side away from the cloth, like the drawing of a clamped beam.
void edge_mark(pugi::xml_node parent, const std::vector<Vec2>& line, bool clamp) {
  std::string path = svg_path(line, false), ticks;
  double to_next = kTick / 2;
  for (std::size_t k = 0; clamp && k + 1 < line.size(); ++k) {
    const Vec2 p = line[k], q = line[k + 1];
    const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
    if (length == 0) continue;
    const double x = (q[0] - p[0]) / length, y = (q[1] - p[1]) / length;  // outward: (-y, x), y down
    for (; to_next <= length; to_next += kTick) {
      const Vec2 foot{p[0] + to_next * x, p[1] + to_next * y};
      const double back = 0.7 * kTick;
      ticks += svg_path({foot, {foot[0] - back * (y + x), foot[1] + back * (x - y)}}, false);
    }
    to_next -= length;
  }
  svg_append(parent, "path",
             {{"class", "edge"},
              {"d", path},
              {"fill", "none"},
              {"stroke", kPinInk},
              {"stroke-width", "3"},
              {"stroke-linejoin", "round"}});
  if (clamp)
    svg_append(parent, "path",
               {{"class", "ticks"}, {"d", ticks}, {"stroke", kPinInk}, {"stroke-width", "1.2"}});
}

// Arrows to all four sides.
void drive_mark(pugi::xml_node parent, Vec2 at, double size) {
  std::string path;
  for (const auto& [x, y] : {Vec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    const auto point = [&, x = x, y = y](double along, double across) {
      return Vec2{at[0] + size * (along * x - across * y), at[1] + size * (along * y + across * x)};
    };
    path += svg_path({point(0.45, 0), point(1, 0)}, false) +
            svg_path({point(0.75, -0.25), point(1, 0), point(0.75, 0.25)}, false);
  }
  for (const auto& [colour, width] : {std::pair{"#ffffff", "4"}, {kPinInk, "1.6"}})
    svg_append(
        parent, "path",
        {{"class", "drive"}, {"d", path}, {"fill", "none"}, {"stroke", colour}, {"stroke-width", width}});
}

void probe_mark(pugi::xml_node parent, Vec2 at) {
  const std::string x = svg_number(at[0]), y = svg_number(at[1]);
  for (const auto& [radius, colour] : {std::pair{"4.5", "#ffffff"}, {"1.2", kProbeInk}})
    svg_append(parent, "circle",
               {{"cx", x},
                {"cy", y},
                {"r", radius},
                {"fill", colour},
                {"stroke", kProbeInk},
                {"stroke-width", "1.4"}});
}

}  // namespace drape::figures
