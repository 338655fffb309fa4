#include "command/garmentcode/pattern.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>

#include "scene/diagnostics.h"
#include "scene/files.h"

namespace drape::command {
namespace {

constexpr double kMaxPerMetre = 1e4;  // a tenth of a millimetre

PatternUnits units_read(const JsonFaults& faults, const Json& root) {
  PatternUnits units;
  const Json* properties = json_member(faults, root, "", "properties", Json::value_t::object);
  if (!properties) return units;
  const auto per_metre = properties->find("units_in_meter");
  if (per_metre == properties->end())
    json_fault(faults, "properties.units_in_meter", "is missing; wanted: 100 for centimetres, 1 for metres");
  else if (const auto n = json_number(faults, *per_metre, "properties.units_in_meter", 1, kMaxPerMetre))
    units.per_metre = *n;
  const Json* coords =
      json_member(faults, *properties, "properties", "curvature_coords", Json::value_t::string);
  if (!coords) return units;
  const std::string word = coords->get<std::string>();
  units.absolute = word == "absolute";
  if (word != "relative" && word != "absolute")
    json_fault(faults, "properties.curvature_coords",
               "= " + scene::in_quotes(word) + "; allowed: \"relative\", \"absolute\"");
  return units;
}

// The names of the panels, in the order of panel_order; without it, in the order of the file.
std::vector<std::string> panel_names(const JsonFaults& faults, const Json& pattern, const Json& panels) {
  std::vector<std::string> names, ordered;
  for (const auto& [name, panel] : panels.items()) names.push_back(name);
  const auto order = pattern.find("panel_order");
  if (order == pattern.end() || !order->is_array()) return names;
  for (std::size_t k = 0; k < order->size(); ++k) {
    const std::string path = scene::entry("pattern.panel_order", k);
    const std::string name = (*order)[k].is_string() ? (*order)[k].get<std::string>() : "";
    const bool there = std::find(names.begin(), names.end(), name) != names.end();
    const bool again = std::find(ordered.begin(), ordered.end(), name) != ordered.end();
    if (!there || again)
      json_fault(
          faults, path,
          "= " + json_text((*order)[k]) + (again ? " stands there twice" : " is no panel of the pattern"));
    else ordered.push_back(name);
  }
  for (const std::string& name : names)
    if (std::find(ordered.begin(), ordered.end(), name) == ordered.end()) ordered.push_back(name);
  return ordered;
}

struct StitchSide {
  int panel, edge;
};

// One side of a stitch: { panel, edge }. Panel p has `edges[p]` edges. Nothing where the side has a fault.
std::optional<StitchSide> side_read(const JsonFaults& faults, const Json& side, const std::string& path,
                                    const Pattern& pattern, const std::vector<std::size_t>& edges) {
  if (!side.is_object()) {
    json_fault(faults, path,
               std::string("is ") + json_kind(side.type()) + "; wanted: an object { panel, edge }");
    return std::nullopt;
  }
  const Json* name = json_member(faults, side, path, "panel", Json::value_t::string);
  const auto number = side.find("edge");
  if (number == side.end()) json_fault(faults, path + ".edge", "is missing; wanted: a whole number");
  if (!name) return std::nullopt;
  const std::string panel_name = name->get<std::string>();
  const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                  [&](const Panel& p) { return p.name == panel_name; });
  if (found == pattern.panels.end()) {
    json_fault(faults, path + ".panel", "= " + scene::in_quotes(panel_name) + " is no panel of the pattern");
    return std::nullopt;
  }
  if (number == side.end()) return std::nullopt;
  const int panel = int(found - pattern.panels.begin());
  const auto index = json_index(faults, *number, path + ".edge", edges[std::size_t(panel)]);
  if (!index) return std::nullopt;
  return StitchSide{panel, *index};
}

void stitches_read(const JsonFaults& faults, const Json& list, const std::vector<std::size_t>& edges,
                   Pattern& pattern) {
  std::map<std::pair<int, int>, std::string> sewn;  // (panel, edge) -> path of the stitch that sews it
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string path = scene::entry("pattern.stitches", k);
    const Json& json = list[k];
    if (!json.is_array() || json.size() < 2 || json.size() > 3) {
      json_fault(faults, path,
                 "is no stitch; wanted: [{ panel, edge }, { panel, edge }], and \"right_wrong\" or nothing");
      continue;
    }
    Stitch stitch;
    bool valid = true;
    for (std::size_t s = 0; s < 2; ++s) {
      const std::string at = scene::entry(path, s);
      const auto side = side_read(faults, json[s], at, pattern, edges);
      if (!side) {
        valid = false;
        continue;
      }
      stitch.panel[s] = side->panel;
      stitch.edge[s] = side->edge;
      const auto [known, fresh] = sewn.emplace(std::pair{stitch.panel[s], stitch.edge[s]}, at);
      if (!fresh)
        json_fault(faults, at,
                   "sews edge " + std::to_string(stitch.edge[s]) + " of " +
                       scene::in_quotes(pattern.panels[std::size_t(stitch.panel[s])].name) + ", which " +
                       known->second + " sews already; an edge belongs to one seam");
    }
    if (json.size() == 3) {
      stitch.right_wrong = json[2] == "right_wrong";
      if (!stitch.right_wrong)
        json_fault(faults, scene::entry(path, 2),
                   "= " + json_text(json[2]) + "; allowed: \"right_wrong\", or nothing");
    }
    if (valid) pattern.stitches.push_back(stitch);
  }
}

void pattern_fill(const JsonFaults& faults, const Json& root, Pattern& pattern) {
  const PatternUnits units = units_read(faults, root);
  const Json* body = json_member(faults, root, "", "pattern", Json::value_t::object);
  if (!body) return;
  const Json* panels = json_member(faults, *body, "pattern", "panels", Json::value_t::object);
  const Json* stitches = json_member(faults, *body, "pattern", "stitches", Json::value_t::array);
  if (!panels) return;
  if (panels->empty()) json_fault(faults, "pattern.panels", "holds no panel; allowed: at least one");
  std::vector<std::size_t> edges;  // the number of edges of each panel, whether or not it has faults
  for (const std::string& name : panel_names(faults, *body, *panels)) {
    const Json& panel = (*panels)[name];
    edges.push_back(0);
    if (!panel.is_object()) {
      pattern.panels.emplace_back().name = name;
      json_fault(faults, "pattern.panels." + name,
                 std::string("is ") + json_kind(panel.type()) + "; wanted: an object {...}");
      continue;
    }
    if (const auto list = panel.find("edges"); list != panel.end() && list->is_array())
      edges.back() = list->size();
    pattern.panels.push_back(panel_read(faults, panel, name, units));
  }
  if (stitches) stitches_read(faults, *stitches, edges, pattern);
}

}  // namespace

Pattern pattern_read(const std::filesystem::path& file, std::vector<Problem>& problems) {
  Pattern pattern;
  const JsonFaults faults{file.string(), problems};
  if (const std::string hindrance = scene::file_hindrance(file, scene::kMaxText); !hindrance.empty())
    return json_fault(faults, "", hindrance), pattern;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return json_fault(faults, "", "cannot be read"), pattern;
  Json root;
  std::string problem;
  if (!json_parse(stream, root, problem)) return json_fault(faults, "", problem), pattern;
  if (root.is_object()) pattern_fill(faults, root, pattern);
  else json_fault(faults, "", std::string("is ") + json_kind(root.type()) + "; wanted: an object {...}");
  return pattern;
}

}  // namespace drape::command
