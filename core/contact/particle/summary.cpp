// Present contact with bodies: depths, pressures, energy.
#include <algorithm>
#include <cmath>

#include "contact/particle/contact.h"
#include "contact/particle/response.h"
#include "math/smooth_ramp.h"
#include "model/body_pose.h"
#include "simd/lane_scalar.h"

namespace drape::contact {
namespace {

using Lane = simd::ScalarLane<false>;

constexpr double kNearStop = 0.999;  // of the depth at which a stop acts

struct Touching {
  std::size_t body, node;
  const model::ContactBlock* block;
  int lane;
  const model::ContactLaw* law;
  Gap<Lane> gap;
  double depth() const { return law->distance - gap.distance.v; }
};

// Visits each particle within its contact distance, once for each surface.
template <class Visit>
void each_touching(const System& system, const State& s, Visit visit) {
  for (std::size_t k = 0; k < s.body.size(); ++k)
    for (const model::ContactPlace& place : s.body[k].blocks.order) {
      const model::ContactBlock& b = s.body[k].blocks.pool[place.block];
      const model::ContactLaw& law = system.lattices[std::size_t(b.lattice)].contact_law;
      for (int i = 0; i < math::kRowUnit; ++i) {
        if (b.offset[i] == -model::kFar) continue;
        const std::size_t n = b.node + std::size_t(i);
        const Vec3 x = model::pose_inward(system.bodies[k], s.body[k], {s.x[n], s.y[n], s.z[n]});
        const double height =
            math::vector3::dot(Vec3{b.side[0][i], b.side[1][i], b.side[2][i]}, x) - b.offset[i];
        const Touching t{k, n, &b, i, &law, contact_gap<Lane>(b, i, {x[0], x[1], x[2]}, height)};
        if (t.depth() > 0) visit(t);
      }
    }
}

// Pressure (Pa) of one surface on a particle: (m/a) W^2 phi(e), and the stop force over the area.
double pressure_of(const System& system, const State& s, const Touching& t, double stop) {
  return (model::inertia_of(system, s, t.node) * t.law->omega2 *
              math::smooth_ramp(kContactBlend * t.law->distance, t.depth()) +
          stop) /
         system.area[t.node];
}

bool is_deep(double contact_distance, double sink, double depth) {
  return depth >= kNearStop * (kContactDeepest * contact_distance - sink);
}

double stop_of(const std::vector<double>& stops, std::size_t k) { return stops.empty() ? 0 : stops[k]; }

double contact_distance_of(const System& system, const EdgeContactPair& t) {
  return system.lattices[std::size_t(t.element->lattice)].contact_law.distance;
}

}  // namespace

bool any_stopped(const System& system, const State& s) {
  bool deep = false;
  each_touching(system, s, [&](const Touching& t) {
    deep = deep || is_deep(t.law->distance, t.block->sink[t.lane], t.depth());
  });
  edge_pairs_visit(system, s, [&](const EdgeContactPair& t, std::size_t, double depth, double) {
    deep = deep || is_deep(contact_distance_of(system, t), 0, depth);
  });
  return deep;
}

ContactStops stop_forces(const System& system, EdgeScratch& scratch, const State& s,
                         const std::vector<EdgeContactPair>& pairs, model::Field acceleration) {
  ContactStops stops;
  double* const a[] = {acceleration.x, acceleration.y, acceleration.z};
  const ContactCoefficients c = coefficients_of(system, s, {.pass = model::Pass::kAcceleration});
  each_touching(system, s, [&](const Touching& t) {
    const model::Body& body = system.bodies[t.body];
    const std::size_t n = t.node;
    const ContactLanes<Lane> law(current_law(system, s, body, system.lattices[std::size_t(t.block->lattice)]),
                                 c, body.damping);
    const Vec3 out = model::pose_outward(body, s.body[t.body], {t.gap.n.x.v, t.gap.n.y.v, t.gap.n.z.v});
    const Vec3 body_acceleration = model::pose_acceleration(body, s.body[t.body], {s.x[n], s.y[n], s.z[n]});
    simd::Vec<Lane> free;  // acceleration relative to the body
    Lane* to[] = {&free.x, &free.y, &free.z};
    for (std::size_t k = 0; k < 3; ++k)
      *to[k] = a[k][n] - t.block->warm_start[k][t.lane] - body_acceleration[k];
    const ContactHit<Lane> hit =
        contact_hit(law, simd::Vec<Lane>{out[0], out[1], out[2]}, t.gap.distance, Lane(t.block->sink[t.lane]),
                    free, free, Lane(t.block->sticking[t.lane]),
                    Lane(s.inverse_mass_scale.empty() ? 1 : 1 / s.inverse_mass_scale[n]));
    const Lane dv[] = {hit.dv.x, hit.dv.y, hit.dv.z};
    for (std::size_t k = 0; k < 3; ++k) a[k][n] = (*to[k] + dv[k]).v + body_acceleration[k];
    stops.particle.push_back(system.mass[n] * hit.stop.v);
  });
  std::vector<EdgeContactPair> accelerated = pairs;
  for (EdgeContactPair& t : accelerated)
    t.body_velocity = model::pose_acceleration(system.bodies[t.body], s.body[t.body], t.at);
  EdgeSums sums;
  edge_respond(system, s, {accelerated, c, {{a[0], a[1], a[2]}, {}, nullptr}}, scratch, sums);
  stops.pair = sums.stop;
  return stops;
}

model::ContactSummary contact_summary(const System& system, const State& s, const ContactStops& stops) {
  model::ContactSummary sum;
  std::vector<char> counted(system.nodes, 0);  // a particle in a groove counts once
  std::size_t k = 0;
  each_touching(system, s, [&](const Touching& t) {
    sum.count += counted[t.node] == 0;
    counted[t.node] = 1;
    sum.penetration = std::max(sum.penetration, t.depth());
    sum.pressure = std::max(sum.pressure, pressure_of(system, s, t, stop_of(stops.particle, k++)));
  });
  edge_pairs_visit(system, s, [&](const EdgeContactPair& t, std::size_t pair, double depth, double force) {
    if (t.gap.share == 0 && !is_deep(contact_distance_of(system, t), 0, depth))
      return;  // only a stop would act on it
    double area = INFINITY;
    for (int i = 0; i < t.element->weights(); ++i) area = std::min(area, system.area[t.element->node[i]]);
    ++sum.count;
    sum.penetration = std::max(sum.penetration, depth);
    sum.pressure = std::max(sum.pressure, (force + stop_of(stops.pair, pair)) / area);
  });
  return sum;
}

std::vector<double> contact_pressure(const System& system, const State& s, const ContactStops& stops) {
  std::vector<double> pressure(system.nodes, 0.0);
  std::size_t k = 0;
  each_touching(system, s, [&](const Touching& t) {
    pressure[t.node] += pressure_of(system, s, t, stop_of(stops.particle, k++));
  });
  edge_pairs_visit(system, s, [&](const EdgeContactPair& t, std::size_t pair, double, double force) {
    for (int i = 0; i < t.element->weights(); ++i)
      pressure[t.element->node[i]] +=
          t.gap.weight[i] * (force + stop_of(stops.pair, pair)) / system.area[t.element->node[i]];
  });
  return pressure;
}

double contact_energy(const System& system, const State& s) {
  double sum = 0;
  each_touching(system, s, [&](const Touching& t) {
    sum += model::inertia_of(system, s, t.node) * t.law->omega2 *
           math::smooth_ramp_integral(kContactBlend * t.law->distance, t.depth());
  });
  edge_pairs_visit(system, s, [&](const EdgeContactPair& t, std::size_t, double depth, double) {
    const double contact_distance = contact_distance_of(system, t);
    sum += t.stiffness *
           math::smooth_ramp_integral(kContactBlend * contact_distance, std::min(depth, contact_distance));
  });
  return sum;
}

}  // namespace drape::contact
