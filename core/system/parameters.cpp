#include "system/parameters.h"

#include <cmath>
#include <cstdio>

namespace drape {
namespace {

const DiagramSpec* diagrams_of(const FabricSpec& f, int k) {
  return k == 0 ? &f.warp : k == 1 ? &f.weft : &f.bias;
}
DiagramSpec* diagrams_of(FabricSpec& f, int k) { return k == 0 ? &f.warp : k == 1 ? &f.weft : &f.bias; }
drape_diagram* shown_of(drape_fabric& f, int k) { return k == 0 ? &f.warp : k == 1 ? &f.weft : &f.bias; }
constexpr const char* kDiagram[] = {"warp", "weft", "bias"};

// Visits every number in a fixed order.
template <class P, class Visit>
void each_value(P& p, Visit visit) {
  visit(p.shown.damping);
  for (auto& g : p.shown.gravity) visit(g);
  visit(p.shown.step_max);
  for (auto& f : p.fabrics)
    for (auto* v : {&f.areal_density, &f.bending_warp, &f.bending_weft, &f.poisson, &f.compression})
      visit(*v);
  for (auto& list : p.force)
    for (auto& v : list) visit(v);
}

std::string with_unit(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9g%s%s", value, *unit ? " " : "", unit);
  return text;
}

void check_range(double value, bool inside, const std::string& place, const char* allowed, const char* unit,
                 std::vector<Problem>& problems) {
  if (inside) return;
  problems.push_back({place, "is " + with_unit(value, unit) + "; allowed: " + allowed});
}

void check_diagram(const drape_diagram& d, const std::string& place, std::vector<Problem>& problems) {
  double before = 0;
  for (int i = 0; i < d.count; ++i) {
    const std::string at = place + ".force[" + std::to_string(i + 1) + "]";
    if (!std::isfinite(d.force[i])) {
      problems.push_back({at, "is not a finite number (N on the strip)"});
    } else if (d.force[i] < before) {
      problems.push_back({at, "is " + with_unit(d.force[i], "N") + ", below the force before it, " +
                                  with_unit(before, "N") + "; a diagram may not fall"});
    }
    before = d.force[i];
  }
}

}  // namespace

void parameters_make(Parameters& p, const Scene& scene, double step_max) {
  const std::size_t n = scene.fabrics.size();
  p.fabrics.resize(n);
  p.elongation.resize(3 * n);
  p.force.resize(3 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const FabricSpec& f = scene.fabrics[k];
    p.fabrics[k] = {f.name.c_str(), f.areal_density, {},        {},           {},
                    f.bending_warp, f.bending_weft,  f.poisson, f.compression};
    for (int d = 0; d < 3; ++d) {
      const DiagramSpec& from = *diagrams_of(f, d);
      if (from.force.empty()) continue;
      std::vector<double>&e = p.elongation[3 * k + std::size_t(d)], &force = p.force[3 * k + std::size_t(d)];
      e.assign(from.elongation.begin() + 1, from.elongation.end());
      force.assign(from.force.begin() + 1, from.force.end());
      *shown_of(p.fabrics[k], d) = {int(force.size()), e.data(), force.data()};
    }
  }
  p.shown = {scene.damping,
             {scene.gravity[0], scene.gravity[1], scene.gravity[2]},
             step_max,
             int(n),
             p.fabrics.data()};
}

ParameterValues parameters_read(const Parameters& p) {
  ParameterValues v;
  each_value(p, [&](double x) { v.value.push_back(x); });
  return v;
}

void parameters_write(Parameters& p, const ParameterValues& v) {
  std::size_t k = 0;
  each_value(p, [&](double& x) { x = v.value[k++]; });
}

std::vector<FabricSpec> parameters_fabrics(const Parameters& p, const Scene& scene) {
  std::vector<FabricSpec> fabrics = scene.fabrics;
  for (std::size_t k = 0; k < fabrics.size(); ++k) {
    FabricSpec& f = fabrics[k];
    const drape_fabric& shown = p.fabrics[k];
    f.areal_density = shown.areal_density;
    f.bending_warp = shown.bending_warp;
    f.bending_weft = shown.bending_weft;
    f.poisson = shown.poisson;
    f.compression = shown.compression;
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 1; i < diagrams_of(f, d)->force.size(); ++i)
        diagrams_of(f, d)->force[i] = p.force[3 * k + std::size_t(d)][i - 1];
  }
  return fabrics;
}

void parameters_check(const Parameters& p, const Scene& scene, std::vector<Problem>& problems) {
  const drape_parameters& s = p.shown;
  const auto not_negative = [](double v) { return std::isfinite(v) && v >= 0; };
  check_range(s.damping, not_negative(s.damping), "damping", "0 and above, 1/s", "1/s", problems);
  for (int k = 0; k < 3; ++k)
    check_range(s.gravity[k], std::isfinite(s.gravity[k]), "gravity[" + std::to_string(k + 1) + "]",
                "finite, m/s2", "m/s2", problems);
  check_range(s.step_max, std::isfinite(s.step_max) && s.step_max > 0, "step.max", "above 0, s", "s",
              problems);
  for (std::size_t k = 0; k < p.fabrics.size(); ++k) {
    const drape_fabric& f = p.fabrics[k];
    const std::string place = "fabric." + scene.fabrics[k].name;
    check_range(f.areal_density, std::isfinite(f.areal_density) && f.areal_density > 0,
                place + ".areal_density", "above 0, kg/m2", "kg/m2", problems);
    check_range(f.bending_warp, not_negative(f.bending_warp), place + ".bending.warp", "0 and above, N m",
                "N m", problems);
    check_range(f.bending_weft, not_negative(f.bending_weft), place + ".bending.weft", "0 and above, N m",
                "N m", problems);
    check_range(f.poisson, f.poisson >= 0 && f.poisson <= 0.999, place + ".poisson", "0 to 0.999", "",
                problems);
    check_range(f.compression, f.compression >= 0 && f.compression <= 1, place + ".compression", "0 to 1", "",
                problems);
    for (int d = 0; d < 3; ++d)
      check_diagram(*shown_of(const_cast<drape_fabric&>(f), d), place + "." + kDiagram[d], problems);
  }
}

}  // namespace drape
