// The pins and probes of a piece. Points are squares, edges thick lines, regions translucent polygons;
// clamps are filled and hatched. Edges and regions also show the points that they hold.
#include <algorithm>
#include <cmath>

#include "figures/picture_draw.h"
#include "piece/support/support.h"

namespace drape::figures {
namespace {

// The direction from a mark to the middle of the piece.
Vec2 inwards(const View& view, Vec2 at) {
  const Vec2 middle = view({(view.low[0] + view.high[0]) / 2, (view.low[1] + view.high[1]) / 2});
  return {middle[0] - at[0], middle[1] - at[1]};
}

std::string title_of(const scene::PinSpec& pin) {
  const char* drives[] = {"", ", driven by position", ", driven by velocity",
                          ", driven by position and velocity"};
  return "pin " + pin.name + (pin.clamp ? ", clamp" : "") + drives[int(pin.drive)];
}

void edges_draw(pugi::xml_node parent, const View& view, const scene::PinSpec& pin) {
  const piece::OutlineLoop& rim = view.loops[0];
  const std::size_t n = rim.points.size();
  const auto held = [&](std::size_t k) {
    return std::find(pin.edges.begin(), pin.edges.end(), rim.edge[k]) != pin.edges.end();
  };
  std::size_t begin = 0;  // after a segment that is not held, or anywhere
  while (begin < n && held((begin + n - 1) % n)) ++begin;
  std::vector<Vec2> line;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = (begin + k) % n;
    if (held(at)) {
      if (line.empty()) line.push_back(view(rim.points[at]));
      line.push_back(view(rim.points[(at + 1) % n]));
    }
    if (line.empty() || (held(at) && k + 1 < n)) continue;
    edge_mark(parent, line, pin.clamp);
    line.clear();
  }
}

void pin_draw(pugi::xml_node parent, const View& view, const scene::PinSpec& pin) {
  const piece::Support hold = piece::support_make(view.grid, view.scene, pin);
  const pugi::xml_node group = svg_append(parent, "g", {{"class", "pin"}});
  svg_title(group, title_of(pin));
  if (!pin.region.empty())
    region_mark(group, view.path(pin.region, true), pin.clamp)
        .append_attribute("clip-path")
        .set_value(("url(#drape-piece-" + std::to_string(view.piece) + ")").c_str());
  edges_draw(group, view, pin);
  std::vector<Vec2> points;
  for (const Vec2& point : hold.points) points.push_back(view(point));
  if (pin.at.empty()) held_mark(group, points, std::clamp(0.25 * view.cell(), 1.0, 4.0));
  else
    for (const Vec2& at : points) point_mark(group, at, 7, pin.clamp);
  const bool driven = pin.drive != scene::Drive::kNone;
  if (driven) drive_mark(group, view(hold.centre), 15);
  const Vec2 named = pin.at.empty() ? view(hold.centre) : points[0];
  label_draw(group, named, inwards(view, named), driven ? 24 : 15, pin.name, kPinInk);
}

}  // namespace

void pins_draw(pugi::xml_node parent, const View& view) {
  for (const scene::PinSpec& pin : view.scene.pins)
    if (pin.piece == view.piece) pin_draw(parent, view, pin);
}

void probes_draw(pugi::xml_node parent, const View& view) {
  for (const scene::ProbeSpec& probe : view.scene.probes) {
    if (probe.piece != view.piece) continue;
    const pugi::xml_node group = svg_append(parent, "g", {{"class", "probe"}});
    svg_title(group, "probe " + probe.name);
    const Vec2 at = view(probe.at);
    probe_mark(group, at);
    label_draw(group, at, inwards(view, at), 13, probe.name, kProbeInk);
  }
}

}  // namespace drape::figures
