#include "outputs/strain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/elements.h"

namespace drape::outputs {
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
  for (const model::Lattice& l : system.lattices)
    model::links_visit(system, l, [&](const model::Link& link) {
      const double strain = model::link_strain(state, link);
      const math::Curve& curve = model::law_curve(l.law, link.along);
      const bool diagonal = link.along == model::YarnDirection::kBias;
      running_add(diagonal                                    ? bias
                  : link.along == model::YarnDirection::kWarp ? warp
                                                              : weft,
                  strain, link.width * link.rest);
      if (curve.segments == 0 || link.doubled) return;
      if (strain > curve.last) ++beyond;
      if (!diagonal) tension = std::max(tension, math::curve_value(curve, strain));
    });
  return {running_result(warp), running_result(weft), running_result(bias), tension, beyond};
}

}  // namespace drape::outputs
