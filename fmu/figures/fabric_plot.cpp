#include "figures/fabric_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "figures/picture_draw.h"

namespace drape::figures {
namespace {

constexpr double kWide = 250, kHigh = 200, kLeft = 56, kTop = 64, kBetween = 76, kBelow = 52;  // units

// The smallest of 1, 2, 5 times a power of ten that divides `largest` into at most five parts.
double tick_of(double largest) {
  const double power = std::pow(10, std::floor(std::log10(largest / 5)));
  for (double step : {1.0, 2.0, 5.0})
    if (step * power >= largest / 5) return step * power;
  return 10 * power;
}

std::string tick_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

struct Axes {
  Vec2 corner;  // upper left
  double max_x, max_y;
  Vec2 operator()(double x, double y) const {
    return {corner[0] + kWide * x / max_x, corner[1] + kHigh * (1 - y / max_y)};
  }
};

void line_draw(pugi::xml_node to, const std::vector<Vec2>& points, const char* ink, const char* width) {
  svg_append(to, "path",
             {{"d", svg_path(points, false)}, {"fill", "none"}, {"stroke", ink}, {"stroke-width", width}});
}

void axes_draw(pugi::xml_node to, const Axes& at) {
  const double step_x = tick_of(at.max_x), step_y = tick_of(at.max_y);
  for (int k = 0; k * step_x <= at.max_x * (1 + 1e-9); ++k) {
    const double x = k * step_x;
    line_draw(to, {at(x, 0), at(x, at.max_y)}, kGhostInk, "1");
    svg_text(to, {at(x, 0)[0], at(x, 0)[1] + 16}, tick_text(x),
             {{"text-anchor", "middle"}, {"font-size", "11"}});
  }
  for (int k = 0; k * step_y <= at.max_y * (1 + 1e-9); ++k) {
    const double y = k * step_y;
    line_draw(to, {at(0, y), at(at.max_x, y)}, kGhostInk, "1");
    svg_text(to, {at(0, y)[0] - 6, at(0, y)[1] + 4}, tick_text(y),
             {{"text-anchor", "end"}, {"font-size", "11"}});
  }
  svg_text(to, {at(at.max_x / 2, 0)[0], at(0, 0)[1] + 34}, "elongation, %",
           {{"text-anchor", "middle"}, {"font-size", "11"}});
}

void panel_draw(pugi::xml_node to, const PlotPanel& panel, Vec2 corner) {
  double largest = 0;
  for (double f : panel.input) largest = std::max(largest, f);
  for (double f : panel.simulated) largest = std::max(largest, f);
  const Axes at{corner, panel.elongation.empty() ? 1 : 100 * panel.elongation.back(),
                largest > 0 ? largest : 1};
  axes_draw(to, at);
  svg_text(to, {corner[0], corner[1] - 10}, panel.title + ", N",
           {{"font-size", "13"}, {"font-weight", "bold"}});
  std::vector<Vec2> line{at(0, 0)};
  for (std::size_t k = 0; k < panel.simulated.size(); ++k)
    line.push_back(at(100 * panel.elongation[k], panel.simulated[k]));
  line_draw(to, line, kProbeInk, "1.6");
  for (std::size_t k = 0; k < panel.elongation.size(); ++k) {
    const Vec2 p = at(100 * panel.elongation[k], panel.input[k]);
    svg_append(to, "circle",
               {{"cx", svg_number(p[0])},
                {"cy", svg_number(p[1])},
                {"r", "3"},
                {"fill", "none"},
                {"stroke", kPinInk},
                {"stroke-width", "1.4"}});
  }
}

}  // namespace

std::string fabric_plot_svg(const std::string& title, const std::vector<PlotPanel>& panels) {
  const double count = double(std::max<std::size_t>(panels.size(), 1));
  const std::string width = svg_number(kLeft + count * kWide + (count - 1) * kBetween + 20),
                    height = svg_number(kTop + kHigh + kBelow);
  pugi::xml_document document;
  pugi::xml_node svg = svg_append(document, "svg",
                                  {{"xmlns", "http://www.w3.org/2000/svg"},
                                   {"font-family", "sans-serif"},
                                   {"viewBox", "0 0 " + width + " " + height},
                                   {"width", width}});
  svg_append(svg, "rect", {{"width", width}, {"height", height}, {"fill", "white"}});
  svg_text(svg, {16, 24}, title + ": measured (circles) and simulated (line)",
           {{"font-size", "14"}, {"fill", kInk}});
  for (std::size_t k = 0; k < panels.size(); ++k)
    panel_draw(svg_append(svg, "g", {{"class", "strip"}, {"fill", kInk}}), panels[k],
               {kLeft + double(k) * (kWide + kBetween), kTop});
  std::ostringstream text;
  document.save(text, " ", pugi::format_default | pugi::format_no_declaration);
  return text.str();
}

}  // namespace drape::figures
