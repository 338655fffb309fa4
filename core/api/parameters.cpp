#include "api/parameters.h"

#include <algorithm>
#include <cstdio>

#include "scene/limits.h"
#include "validation/checks.h"

namespace drape::api {
namespace {

const scene::DiagramSpec* diagrams_of(const scene::FabricSpec& f, int k) {
  return k == 0 ? &f.warp : k == 1 ? &f.weft : &f.bias;
}
scene::DiagramSpec* diagrams_of(scene::FabricSpec& f, int k) {
  return k == 0 ? &f.warp : k == 1 ? &f.weft : &f.bias;
}
drape_diagram* diagram_view(drape_fabric& f, int k) { return k == 0 ? &f.warp : k == 1 ? &f.weft : &f.bias; }
constexpr const char* kDiagram[] = {"warp", "weft", "bias"};

// Visits every number, in a fixed order.
template <class P, class Visit>
void values_visit(P& p, Visit visit) {
  visit(p.c_view.damping);
  for (auto& g : p.c_view.gravity) visit(g);
  visit(p.c_view.air_normal);
  visit(p.c_view.air_tangential);
  visit(p.c_view.ramp);
  visit(p.c_view.step_max);
  visit(p.c_view.threads);
  for (auto& s : p.seams) visit(s.close);
  for (auto& f : p.fabrics)
    for (auto* v : {&f.areal_density, &f.bending_warp, &f.bending_weft, &f.poisson, &f.compression,
                    &f.damping, &f.friction})
      visit(*v);
  for (auto& list : p.force)
    for (auto& v : list) visit(v);
}

// Name and range of every number, in the order of values_visit.
struct ValueRow {
  std::string place;
  const scene::Quantity* limits;
};
std::vector<ValueRow> value_rows(const Parameters& p, const Scene& scene) {
  std::vector<ValueRow> rows{{"damping", &scene::kDamping}};
  for (int k = 1; k <= 3; ++k) rows.push_back({"gravity[" + std::to_string(k) + "]", &scene::kGravity});
  rows.push_back({"air.normal", &scene::kAirCoefficient});
  rows.push_back({"air.tangential", &scene::kAirCoefficient});
  rows.push_back({"parameter_ramp", &scene::kRamp});
  rows.push_back({"step.max", &scene::kStepMax});
  rows.push_back({"threads", &scene::kThreads});
  for (const scene::SeamSpec& s : scene.seams) rows.push_back({"seam." + s.name + ".close", &scene::kClose});
  for (const scene::FabricSpec& f : scene.fabrics) {
    const std::string place = "fabric." + f.name;
    rows.push_back({place + ".areal_density", &scene::kArealDensity});
    rows.push_back({place + ".bending.warp", &scene::kBending});
    rows.push_back({place + ".bending.weft", &scene::kBending});
    rows.push_back({place + ".poisson", &scene::kPoisson});
    rows.push_back({place + ".compression", &scene::kCompression});
    rows.push_back({place + ".damping", &scene::kSpringDamping});
    rows.push_back({place + ".friction", &scene::kFriction});
  }
  for (std::size_t list = 0; list < p.force.size(); ++list)
    for (std::size_t i = 1; i <= p.force[list].size(); ++i)
      rows.push_back({"fabric." + scene.fabrics[list / 3].name + "." + kDiagram[list % 3] + ".force[" +
                          std::to_string(i) + "]",
                      &scene::kForce});
  return rows;
}

// True for parameters of forces that depend on velocity.
bool depends_on_rate(const ValueRow& row) {
  return row.limits == &scene::kAirCoefficient || row.limits == &scene::kSpringDamping;
}

std::string rate_text(const scene::Quantity& q, double value, int order) {
  char text[80];
  std::snprintf(text, sizeof text, "= %.9g%s; allowed: ", value, std::string(q.unit) == "1" ? "" : " s");
  return text + validation::order_allows(order);
}

// The first point of a diagram at which the law, force x correction, or the force itself is less than at the
// point before it; the number of points where there is none.
std::size_t fall_find(const std::vector<double>& force, const scene::DiagramSpec& diagram) {
  const std::vector<double>& correction = diagram.correction;
  double before = 0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double law = correction.empty() ? force[i] : force[i] * correction[i + 1];
    if (law < before || (i > 0 && force[i] < force[i - 1])) return i;
    before = law;
  }
  return force.size();
}

std::string fall_text(const std::vector<double>& force, std::size_t i) {
  char text[160];
  const double before = i > 0 ? force[i - 1] : 0.0;
  const char* why = force[i] < before ? "at least the force before it, %.9g N: a diagram does not fall"
                                      : "what does not let force x correction fall after %.9g N";
  std::snprintf(text, sizeof text, (std::string("= %.9g N; allowed: ") + why).c_str(), force[i], before);
  return text;
}

}  // namespace

std::string limits_text(const scene::Quantity& limits, double value) {
  const std::string unit = std::string(limits.unit) == "1" ? "" : std::string(" ") + limits.unit;
  char text[160];
  std::snprintf(text, sizeof text, "= %.9g%s; allowed: %s %.9g to %.9g%s", value, unit.c_str(),
                limits.above   ? "above"
                : limits.whole ? "a whole number from"
                               : "from",
                limits.low, limits.high, unit.c_str());
  return text;
}

void parameters_make(Parameters& p, const Scene& scene, double step_max) {
  const std::size_t n = scene.fabrics.size();
  p.has_bodies = !scene.bodies.empty();
  p.fabrics.resize(n);
  p.elongation.resize(3 * n);
  p.force.resize(3 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const scene::FabricSpec& f = scene.fabrics[k];
    p.fabrics[k] = {
        f.name.c_str(), f.areal_density, {},        {},           {}, f.bending_warp, f.bending_weft,
        f.poisson,      f.compression,   f.damping, f.friction[0]};
    for (int d = 0; d < 3; ++d) {
      const scene::DiagramSpec& from = *diagrams_of(f, d);
      if (from.force.empty()) continue;
      std::vector<double>&e = p.elongation[3 * k + std::size_t(d)], &force = p.force[3 * k + std::size_t(d)];
      e.assign(from.elongation.begin() + 1, from.elongation.end());
      force.assign(from.force.begin() + 1, from.force.end());
      *diagram_view(p.fabrics[k], d) = {int(force.size()), e.data(), force.data()};
    }
  }
  for (const scene::SeamSpec& s : scene.seams) p.seams.push_back({s.name.c_str(), 0});
  p.c_view = {scene.damping,
              {scene.gravity[0], scene.gravity[1], scene.gravity[2]},
              scene.has_air,
              scene.air_normal,
              scene.air_tangential,
              0,
              step_max,
              1,
              double(scene.mode == scene::Mode::kFit ? DRAPE_MODE_FIT : DRAPE_MODE_DYNAMIC),
              int(n),
              p.fabrics.data(),
              int(p.seams.size()),
              p.seams.data()};
}

namespace {
bool is_closing(const Parameters& p, const double* value) {
  return std::any_of(p.seams.begin(), p.seams.end(),
                     [&](const drape_seam_parameters& s) { return value == &s.close; });
}
}  // namespace

ParameterValues parameters_read(const Parameters& p) {
  ParameterValues v;
  values_visit(p, [&](double x) { v.value.push_back(x); });
  return v;
}

void parameters_write(Parameters& p, const ParameterValues& v) {
  std::size_t k = 0;
  values_visit(p, [&](double& x) { x = v.value[k++]; });
}

bool parameters_change_motion(const Parameters& p, const ParameterValues& a, const ParameterValues& b) {
  const auto idle = [&](const double* value) {
    return value == &p.c_view.ramp || value == &p.c_view.threads || is_closing(p, value) ||
           (!p.has_bodies && std::any_of(p.fabrics.begin(), p.fabrics.end(),
                                         [&](const drape_fabric& f) { return value == &f.friction; }));
  };
  bool changes = false;
  std::size_t k = 0;
  values_visit(p, [&](const double& value) {
    changes = changes || (a.value[k] != b.value[k] && !idle(&value));
    ++k;
  });
  return changes;
}

std::vector<int> parameters_groups(const Parameters& p) {
  std::vector<int> group;
  int next = 0;
  values_visit(p, [&](const double& value) {
    const bool at_once = &value == &p.c_view.ramp || &value == &p.c_view.step_max ||
                         &value == &p.c_view.threads || is_closing(p, &value);
    group.push_back(at_once ? -1 : next++);
  });
  std::size_t k = group.size();
  for (std::size_t list = p.force.size(); list-- > 0;) {
    k -= p.force[list].size();
    for (std::size_t i = 0; i < p.force[list].size(); ++i) group[k + i] = group[k];
  }
  return group;
}

std::vector<scene::FabricSpec> parameters_fabrics(const Parameters& p, const Scene& scene) {
  std::vector<scene::FabricSpec> fabrics = scene.fabrics;
  for (std::size_t k = 0; k < fabrics.size(); ++k) {
    scene::FabricSpec& f = fabrics[k];
    const drape_fabric& view = p.fabrics[k];
    f.areal_density = view.areal_density;
    f.bending_warp = view.bending_warp;
    f.bending_weft = view.bending_weft;
    f.poisson = view.poisson;
    f.compression = view.compression;
    f.damping = view.damping;
    // The static coefficient is tuned; the kinetic one keeps its ratio to it.
    f.friction = {view.friction,
                  f.friction[0] > 0 ? view.friction * (f.friction[1] / f.friction[0]) : view.friction};
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 1; i < diagrams_of(f, d)->force.size(); ++i)
        diagrams_of(f, d)->force[i] = p.force[3 * k + std::size_t(d)][i - 1];
  }
  return fabrics;
}

std::string parameters_changes_text(const Parameters& p, const Scene& scene, const ParameterValues& before) {
  const std::vector<ValueRow> rows = value_rows(p, scene);
  const ParameterValues now = parameters_read(p);
  std::string text;
  std::size_t more = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (now.value[k] == before.value[k]) continue;
    if (!text.empty()) {
      ++more;
      continue;
    }
    char value[60];
    const std::string unit =
        std::string(rows[k].limits->unit) == "1" ? "" : std::string(" ") + rows[k].limits->unit;
    std::snprintf(value, sizeof value, " = %.6g%s", now.value[k], unit.c_str());
    text = rows[k].place + value;
  }
  return more == 0 ? text
                   : text + " and " + std::to_string(more) + (more == 1 ? " more value" : " more values");
}

void parameters_validate(Parameters& p, const Scene& scene, const ParameterValues& in_force,
                         std::vector<Problem>& problems) {
  const std::vector<ValueRow> rows = value_rows(p, scene);
  ParameterValues now = parameters_read(p);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool excluded = scene.order > 2 && depends_on_rate(rows[k]) && now.value[k] > 0;
    if (scene::quantity_fits(*rows[k].limits, now.value[k]) && !excluded) continue;
    problems.push_back({rows[k].place, excluded ? rate_text(*rows[k].limits, now.value[k], scene.order)
                                                : limits_text(*rows[k].limits, now.value[k])});
    now.value[k] = in_force.value[k];
  }
  parameters_write(p, now);
  std::size_t first = now.value.size();
  for (std::size_t list = p.force.size(); list-- > 0;) {
    std::vector<double>& force = p.force[list];
    first -= force.size();
    const std::size_t fall = fall_find(force, *diagrams_of(scene.fabrics[list / 3], int(list % 3)));
    if (fall == force.size()) continue;
    problems.push_back({rows[first + fall].place, fall_text(force, fall)});
    for (std::size_t i = 0; i < force.size(); ++i) force[i] = in_force.value[first + i];
  }
}

bool parameters_restore(Parameters& p, const Scene& scene, const ParameterValues& in_force,
                        const std::string& stem) {
  const std::vector<ValueRow> rows = value_rows(p, scene);
  const ParameterValues now = parameters_read(p);
  ParameterValues restored = now;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].place.starts_with(stem)) restored.value[k] = in_force.value[k];
  parameters_write(p, restored);
  return !(restored == now);
}

}  // namespace drape::api
