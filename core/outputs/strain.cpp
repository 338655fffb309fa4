#include "outputs/strain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "outputs/links.h"

namespace drape {
namespace {

struct Running {
  double min = std::numeric_limits<double>::infinity(), max = -std::numeric_limits<double>::infinity();
  double sum = 0, weight = 0;
};

void running_add(Running& r, double strain, double weight) {
  r.min = std::min(r.min, strain);
  r.max = std::max(r.max, strain);
  r.sum += weight * strain;
  r.weight += weight;
}

drape_strain running_result(const Running& r) {
  if (r.weight == 0) return {0, 0, 0};
  return {r.min, r.max, r.sum / r.weight};
}

}  // namespace

StrainSummary strain_summary(const System& system, const State& state) {
  Running warp, weft, bias;
  double tension = 0, beyond = 0;
  for (const Lattice& l : system.lattices)
    each_link(system, l, [&](const Link& link) {
      const double strain = link_strain(state, link);
      const bool diagonal = link.law == &l.law.bias;
      running_add(diagonal ? bias : link.law == &l.law.warp ? warp : weft, strain, link.width * link.rest);
      if (link.law->segments == 0) return;
      if (strain > link.law->last) ++beyond;
      if (!diagonal) tension = std::max(tension, curve_value(*link.law, strain));
    });
  return {running_result(warp), running_result(weft), running_result(bias), tension, beyond};
}

}  // namespace drape
