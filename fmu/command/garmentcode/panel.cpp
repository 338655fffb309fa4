// Edges run from vertex s to vertex e. In the frame of an edge a point is
//
//   P = s + p0 (e - s) + p1 perp,      perp = (-(e - s).y, (e - s).x)
//
// and a panel's point (x, y) is at Rz Ry Rx (x, y, 0) + translation. M. Korosteleva, O. Sorkine-Hornung,
// GarmentCode: Programming Parametric Sewing Patterns, ACM TOG 42(6), 2023.
#include "command/garmentcode/panel.h"

#include <cmath>
#include <numbers>

#include "scene/diagnostics.h"

namespace drape::command {
namespace {

constexpr double kLargest = 1e4;  // m
constexpr double kGrain = 1e-8;   // m, to which coordinates are rounded, to keep the text short

double grained(double metres) { return std::round(metres / kGrain) * kGrain; }

struct Edge {
  int from, to;
};

// Reads the type and the parameters of a curvature: { type, params }, or a control point alone.
bool curvature_open(const JsonFaults& faults, const Json& curvature, const std::string& path,
                    std::string& type, const Json*& params) {
  if (curvature.is_array()) return type = "quadratic", params = nullptr, true;
  if (!curvature.is_object()) {
    json_fault(faults, path,
               std::string("is ") + json_kind(curvature.type()) +
                   "; wanted: a control point [x, y] or an object { type, params }");
    return false;
  }
  const Json* name = json_member(faults, curvature, path, "type", Json::value_t::string);
  params = json_member(faults, curvature, path, "params", Json::value_t::array);
  if (!name) return false;
  type = name->get<std::string>();
  if (type == "quadratic" || type == "cubic" || type == "circle") return params != nullptr;
  json_fault(faults, path + ".type",
             "= " + scene::in_quotes(type) + "; allowed: \"quadratic\", \"cubic\", \"circle\"");
  return false;
}

void arc_read(const JsonFaults& faults, const Json& params, const std::string& path, double chord,
              const PatternUnits& units, scene::CurveSpec& curve) {
  const auto numbers = json_numbers(faults, params, path, 3, kLargest * units.per_metre);
  if (!numbers) return;
  for (std::size_t k : {1, 2})
    if ((*numbers)[k] != 0 && (*numbers)[k] != 1)
      json_fault(faults, scene::entry(path, k),
                 "= " + scene::number_text((*numbers)[k]) + "; allowed: 0 or 1");
  const double radius = (*numbers)[0] / units.per_metre;
  if (!(radius >= chord / 2 * (1 - 1e-6)))
    json_fault(faults, scene::entry(path, 0),
               "= " + scene::number_text((*numbers)[0]) + "; allowed: at least " +
                   scene::number_text(chord / 2 * units.per_metre) + ", half the chord of the edge");
  curve.radius = std::max(radius, chord / 2);  // rounding may make the radius of a semicircle too small
  curve.large = (*numbers)[1] == 1;
  curve.right = (*numbers)[2] == 1;
}

scene::CurveSpec curve_read(const JsonFaults& faults, const Json& curvature, const std::string& path, Vec2 s,
                            Vec2 e, const PatternUnits& units) {
  scene::CurveSpec curve;
  std::string type;
  const Json* params = nullptr;
  if (!curvature_open(faults, curvature, path, type, params)) return curve;
  const Vec2 along{e[0] - s[0], e[1] - s[1]};
  const std::string at = params ? path + ".params" : path;
  if (params && type == "circle")
    return arc_read(faults, *params, at, std::hypot(along[0], along[1]), units, curve), curve;
  const std::size_t count = type == "cubic" ? 2 : 1;
  if (params && params->size() != count)
    return json_fault(faults, at,
                      "has " + scene::entries_text(params->size()) + "; wanted: " + std::to_string(count) +
                          " control points of a " + type + " curve"),
           curve;
  const double size = kLargest * (units.absolute ? units.per_metre : 1);
  for (std::size_t k = 0; k < count; ++k) {
    const auto p =
        json_numbers(faults, params ? (*params)[k] : curvature, params ? scene::entry(at, k) : at, 2, size);
    if (!p) return curve;
    const auto [p0, p1] = Vec2{(*p)[0], (*p)[1]};
    const Vec2 point = units.absolute
                           ? Vec2{p0 / units.per_metre, p1 / units.per_metre}
                           : Vec2{s[0] + p0 * along[0] - p1 * along[1], s[1] + p0 * along[1] + p1 * along[0]};
    curve.bezier.push_back({grained(point[0]), grained(point[1])});
  }
  return curve;
}

std::vector<Vec2> vertices_read(const JsonFaults& faults, const Json& list, const std::string& path,
                                const PatternUnits& units) {
  std::vector<Vec2> vertices;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (const auto p = json_numbers(faults, list[k], scene::entry(path, k), 2, kLargest * units.per_metre))
      vertices.push_back({grained((*p)[0] / units.per_metre), grained((*p)[1] / units.per_metre)});
  if (vertices.size() < list.size()) vertices.clear();
  return vertices;
}

// The edges of a closed loop: each starts at the vertex where the one before it ends.
std::vector<Edge> loop_read(const JsonFaults& faults, const Json& list, const std::string& path,
                            std::size_t vertices) {
  std::vector<Edge> edges;
  if (list.size() < 3)
    return json_fault(faults, path,
                      "has " + scene::entries_text(list.size()) + "; allowed: at least 3 edges"),
           edges;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string at = scene::entry(path, k);
    if (!list[k].is_object()) {
      json_fault(faults, at, std::string("is ") + json_kind(list[k].type()) + "; wanted: an object {...}");
      continue;
    }
    const Json* ends = json_member(faults, list[k], at, "endpoints", Json::value_t::array);
    if (!ends) continue;
    if (ends->size() != 2) {
      json_fault(faults, at + ".endpoints",
                 "has " + scene::entries_text(ends->size()) + "; wanted: 2 vertices");
      continue;
    }
    const auto from = json_index(faults, (*ends)[0], at + ".endpoints[0]", vertices);
    const auto to = json_index(faults, (*ends)[1], at + ".endpoints[1]", vertices);
    if (from && to) edges.push_back({*from, *to});
  }
  if (edges.size() < list.size()) return {};
  bool closed = true;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::size_t next = (k + 1) % edges.size();
    if (edges[k].to == edges[next].from) continue;
    json_fault(faults, scene::entry(path, next),
               "starts at vertex " + std::to_string(edges[next].from) + "; wanted: vertex " +
                   std::to_string(edges[k].to) + ", where edge " + std::to_string(k) +
                   " ends: the edges do not close a loop");
    closed = false;
  }
  return closed ? edges : std::vector<Edge>{};
}

// A closed outline: edges [n] between vertices (m).
struct Loop {
  std::vector<Edge> edges;
  std::vector<Vec2> vertices;
};

// Appends the outline, the labels and the curves of the loop's edges to the panel.
void edges_read(const JsonFaults& faults, const Json& list, const std::string& path, const Loop& loop,
                const PatternUnits& units, Panel& panel) {
  for (std::size_t k = 0; k < loop.edges.size(); ++k) {
    const Vec2 s = loop.vertices[std::size_t(loop.edges[k].from)],
               e = loop.vertices[std::size_t(loop.edges[k].to)];
    panel.outline.push_back(s);
    const auto label = list[k].find("label");
    panel.edge_label.push_back(label != list[k].end() && label->is_string() ? label->get<std::string>() : "");
    const auto curvature = list[k].find("curvature");
    if (curvature == list[k].end() || curvature->is_null()) continue;
    panel.curves.push_back(curve_read(faults, *curvature, scene::entry(path, k) + ".curvature", s, e, units));
    panel.curves.back().edge = int(k);
  }
}

}  // namespace

void panel_axes(const std::vector<double>& degrees, Vec3& axis_x, Vec3& axis_y) {
  double c[3], s[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = degrees[k] * std::numbers::pi / 180;
    c[k] = std::cos(angle), s[k] = std::sin(angle);
  }
  axis_x = {c[2] * c[1], s[2] * c[1], -s[1]};
  axis_y = {c[2] * s[1] * s[0] - s[2] * c[0], s[2] * s[1] * s[0] + c[2] * c[0], c[1] * s[0]};
}

Panel panel_read(const JsonFaults& faults, const Json& json, const std::string& name,
                 const PatternUnits& units) {
  Panel panel;
  panel.name = name;
  const std::string path = "pattern.panels." + name;
  const std::size_t before = faults.problems.size();
  if (const auto label = json.find("label"); label != json.end() && label->is_string())
    panel.label = label->get<std::string>();
  const Json* translation = json_member(faults, json, path, "translation", Json::value_t::array);
  const Json* rotation = json_member(faults, json, path, "rotation", Json::value_t::array);
  const Json* vertices = json_member(faults, json, path, "vertices", Json::value_t::array);
  const Json* edges = json_member(faults, json, path, "edges", Json::value_t::array);
  if (translation)
    if (const auto t =
            json_numbers(faults, *translation, path + ".translation", 3, kLargest * units.per_metre))
      for (std::size_t k = 0; k < 3; ++k) panel.origin[k] = grained((*t)[k] / units.per_metre);
  if (rotation)
    if (const auto r = json_numbers(faults, *rotation, path + ".rotation", 3, 3600))
      panel_axes(*r, panel.axis_x, panel.axis_y);
  if (!vertices || !edges) return panel;
  Loop loop;
  loop.vertices = vertices_read(faults, *vertices, path + ".vertices", units);
  loop.edges = loop_read(faults, *edges, path + ".edges", vertices->size());
  if (!loop.vertices.empty()) edges_read(faults, *edges, path + ".edges", loop, units, panel);
  if (faults.problems.size() > before) panel.outline.clear();
  return panel;
}

}  // namespace drape::command
