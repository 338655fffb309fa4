// What touches bodies now: depths, pressures, energy.
#include <algorithm>
#include <cmath>

#include "contact/penalty.h"
#include "contact/pose.h"
#include "contact/response.h"
#include "forces/lane_scalar.h"
#include "motion/touch.h"

namespace drape {
namespace {

using Lane = ScalarLane<false>;

// Visits the depth (m) of each particle within its layer.
template <class Visit>
void each_depth(const System& system, const State& s, Visit visit) {
  for (std::size_t k = 0; k < s.body.size(); ++k)
    for (const ContactPlace& place : s.body[k].blocks.order) {
      const ContactBlock& b = s.body[k].blocks.pool[place.block];
      const ContactLaw& law = system.lattices[std::size_t(b.lattice)].touch;
      for (int i = 0; i < kRowUnit; ++i) {
        if (b.offset[i] == -kFar) continue;
        const std::size_t n = b.node + std::size_t(i);
        const Vec3 x = pose_inward(system.bodies[k], s.body[k], {s.x[n], s.y[n], s.z[n]});
        const double height = vector3::dot(Vec3{b.side[0][i], b.side[1][i], b.side[2][i]}, x) - b.offset[i];
        const Gap<Lane> gap = contact_gap<Lane>(b, i, {x[0], x[1], x[2]}, height);
        const double depth = law.layer - gap.distance.v;
        if (depth > 0) visit(n, law, depth);
      }
    }
}

// Of a particle, by one surface: (m/a) W^2 phi(e), Pa.
double pressure_of(const System& system, const State& s, std::size_t n, const ContactLaw& law, double depth) {
  return inertia_of(system, s, n) / system.area[n] * law.omega2 *
         contact_penalty(kContactBlend * law.layer, depth);
}

}  // namespace

ContactSummary touch_summary(const System& system, const State& s) {
  ContactSummary sum;
  std::size_t last = system.nodes;  // a particle in a groove counts once
  each_depth(system, s, [&](std::size_t n, const ContactLaw& law, double depth) {
    sum.count += n != last;
    last = n;
    sum.penetration = std::max(sum.penetration, depth);
    sum.pressure = std::max(sum.pressure, pressure_of(system, s, n, law, depth));
  });
  ridge_each(system, s, [&](const RidgeTouch& t, double depth, double force) {
    double area = INFINITY;
    for (int k = 0; k < t.part->weights(); ++k) area = std::min(area, system.area[t.part->node[k]]);
    ++sum.count;
    sum.penetration = std::max(sum.penetration, depth);
    sum.pressure = std::max(sum.pressure, force / area);
  });
  return sum;
}

std::vector<double> touch_pressure(const System& system, const State& s) {
  std::vector<double> pressure(system.nodes, 0.0);
  each_depth(system, s, [&](std::size_t n, const ContactLaw& law, double depth) {
    pressure[n] += pressure_of(system, s, n, law, depth);
  });
  ridge_each(system, s, [&](const RidgeTouch& t, double, double force) {
    for (int k = 0; k < t.part->weights(); ++k)
      pressure[t.part->node[k]] += t.gap.weight[k] * force / system.area[t.part->node[k]];
  });
  return pressure;
}

double touch_energy(const System& system, const State& s) {
  double sum = 0;
  each_depth(system, s, [&](std::size_t n, const ContactLaw& law, double depth) {
    sum += inertia_of(system, s, n) * law.omega2 * contact_penalty_energy(kContactBlend * law.layer, depth);
  });
  ridge_each(system, s, [&](const RidgeTouch& t, double depth, double) {
    const double layer = system.lattices[std::size_t(t.part->lattice)].touch.layer;
    sum += t.stiffness * contact_penalty_energy(kContactBlend * layer, std::min(depth, layer));
  });
  return sum;
}

}  // namespace drape
