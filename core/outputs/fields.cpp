#include "outputs/fields.h"

#include <algorithm>
#include <limits>

#include "model/elements.h"

namespace drape::outputs {
namespace {

double link_tension(const fabric::Law& law, model::YarnDirection along, double strain) {
  const math::Curve& curve = model::law_curve(law, along);
  return curve.segments == 0 ? 0 : math::curve_value(curve, strain);
}

// Sums over the links of a node, for warp, weft, bias: width, width x strain, width x tension.
using LinkSums = std::array<std::array<double, 3>, 3>;

std::vector<LinkSums> link_sums(const System& system, const State& s) {
  std::vector<LinkSums> sums(system.nodes, LinkSums{});
  for (const model::Lattice& l : system.lattices)
    model::links_visit(system, l, [&](const model::Link& link) {
      const double strain = model::link_strain(s, link), tension = link_tension(l.law, link.along, strain);
      for (const std::size_t n : {link.from, link.to}) {
        std::array<double, 3>& sum = sums[n][std::size_t(link.along)];
        sum[0] += link.width;
        sum[1] += link.width * strain;
        sum[2] += link.width * tension;
      }
    });
  return sums;
}

}  // namespace

void fields_fill(Fields& fields, const System& system, const State& s, const contact::ContactStops& stops) {
  const std::vector<LinkSums> sums = link_sums(system, s);
  const std::vector<double> pressure = contact::contact_pressure(system, s, stops);
  fields = Fields{};
  for (const std::size_t n : system.particle) {
    for (const auto& [width, strain, tension] : sums[n]) {
      fields.strain.push_back(width > 0 ? strain / width : 0);
      if (&tension != &sums[n][2][2]) fields.tension.push_back(width > 0 ? tension / width : 0);
    }
    fields.pressure.push_back(pressure[n]);
    fields.area.push_back(system.area[n]);
  }
}

Elongation elongation_of(const System& system, const State& s, const model::Lattice& lattice,
                         model::YarnDirection along, double limit) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Elongation e{kNone, -kNone, 0, 0, 0};
  double area = 0;
  model::links_visit(system, lattice, [&](const model::Link& link) {
    if (link.along != along) return;
    const double strain = model::link_strain(s, link), share = link.width * link.rest;
    e.min = std::min(e.min, strain);
    e.max = std::max(e.max, strain);
    e.mean += share * strain;
    area += share;
    if (strain > limit) e.beyond += share;
    if (along != model::YarnDirection::kBias)
      e.tension_max = std::max(e.tension_max, link_tension(lattice.law, along, strain));
  });
  if (area == 0) return {0, 0, 0, 0, 0};
  e.mean /= area;
  e.beyond /= area;
  return e;
}

}  // namespace drape::outputs
