#include "outputs/fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraint/vector3.h"
#include "contact/job.h"
#include "system/links.h"

namespace drape {
namespace {

using namespace vector3;

double link_tension(const Law& law, Thread along, double strain) {
  const Curve& curve = law_curve(law, along);
  return curve.segments == 0 ? 0 : curve_value(curve, strain);
}

// The depth of a particle in the layer of a surface near it, d = s |D (x - p)|: core/README.md, section 7.
double depth_of(const ContactBlock& b, std::size_t i, const ContactLaw& law, const Vec3& x) {
  const auto at = [i](const double(&row)[kRowUnit]) { return row[i]; };
  const Vec3 e = x - Vec3{at(b.point[0]), at(b.point[1]), at(b.point[2])};
  const Vec3 u{at(b.shape[0]) * e[0] + at(b.shape[1]) * e[1] + at(b.shape[2]) * e[2],
               at(b.shape[1]) * e[0] + at(b.shape[3]) * e[1] + at(b.shape[4]) * e[2],
               at(b.shape[2]) * e[0] + at(b.shape[4]) * e[1] + at(b.shape[5]) * e[2]};
  const double height = dot(Vec3{at(b.side[0]), at(b.side[1]), at(b.side[2])}, x) - at(b.offset);
  return law.layer - std::copysign(norm(u), height);
}

// phi of the penalty.
double penalty(const ContactLaw& law, double depth) {
  const double blend = kContactBlend * law.layer, t = std::clamp(depth / blend, 0.0, 1.0);
  return blend * t * t * t * (1 - t / 2) + std::max(depth - blend, 0.0);
}

Vec3 inward(const Body& body, const BodyContact& c, const Vec3& at) {
  if (!body.moves) return at;
  const Vec3 d = at - c.frame.position;
  return d[0] * c.turn[0] + d[1] * c.turn[1] + d[2] * c.turn[2];
}

// p = (m/a) W^2 phi(e), summed over the surfaces that a particle touches.
std::vector<double> pressure_of_nodes(const System& system, const State& s) {
  std::vector<double> pressure(system.nodes, 0.0);
  for (std::size_t k = 0; k < s.body.size(); ++k)
    for (const ContactPlace& place : s.body[k].blocks.order) {
      const ContactBlock& b = s.body[k].blocks.pool[place.block];
      const ContactLaw& law = system.lattices[std::size_t(b.lattice)].touch;
      for (std::size_t i = 0; i < std::size_t(kRowUnit); ++i) {
        const std::size_t n = b.node + i;
        if (b.offset[i] == -kFar || system.area[n] == 0) continue;
        const Vec3 x = inward(system.bodies[k], s.body[k], {s.x[n], s.y[n], s.z[n]});
        pressure[n] += system.mass[n] / system.area[n] * law.omega2 * penalty(law, depth_of(b, i, law, x));
      }
    }
  return pressure;
}

// Sums of a node over its links: width, width x strain, width x tension; of warp, weft, bias.
using LinkSums = std::array<std::array<double, 3>, 3>;

std::vector<LinkSums> link_sums(const System& system, const State& s) {
  std::vector<LinkSums> sums(system.nodes, LinkSums{});
  for (const Lattice& l : system.lattices)
    each_link(system, l, [&](const Link& link) {
      const double strain = link_strain(s, link), tension = link_tension(l.law, link.along, strain);
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

void fields_fill(Fields& fields, const System& system, const State& s) {
  const std::vector<LinkSums> sums = link_sums(system, s);
  const std::vector<double> pressure = pressure_of_nodes(system, s);
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

Elongation elongation_of(const System& system, const State& s, const Lattice& lattice, Thread along,
                         double limit) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Elongation e{kNone, -kNone, 0, 0, 0};
  double area = 0;
  each_link(system, lattice, [&](const Link& link) {
    if (link.along != along) return;
    const double strain = link_strain(s, link), share = link.width * link.rest;
    e.min = std::min(e.min, strain);
    e.max = std::max(e.max, strain);
    e.mean += share * strain;
    area += share;
    if (strain > limit) e.beyond += share;
    if (along != Thread::kBias)
      e.tension_max = std::max(e.tension_max, link_tension(lattice.law, along, strain));
  });
  if (area == 0) return {0, 0, 0, 0, 0};
  e.mean /= area;
  e.beyond /= area;
  return e;
}

}  // namespace drape
