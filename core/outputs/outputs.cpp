#include "outputs/outputs.h"

#include <algorithm>
#include <cmath>

#include "dynamics/potential_energy.h"
#include "dynamics/step_size/step_limit.h"
#include "math/vector3.h"
#include "model/kinetic_energy.h"
#include "model/node_sums.h"
#include "outputs/strain.h"

namespace drape::outputs {
namespace {

using namespace math::vector3;

// Interpolates a field x, y, z [nodes] at each probe.
void probes_fill(Outputs& o, const System& system, double (drape_probe::*to)[3], const Array& x,
                 const Array& y, const Array& z) {
  const Array* field[] = {&x, &y, &z};
  for (std::size_t p = 0; p < o.probes.size(); ++p) {
    const model::Probe& probe = system.probes[p];
    for (int k = 0; k < 3; ++k) {
      double sum = 0;
      for (int n = 0; n < 4; ++n) sum += probe.weight[n] * (*field[k])[probe.node[n]];
      (o.probes[p].*to)[k] = sum;
    }
  }
}

// The force is the impulse of the last advance over its length. The impulse of the state lacks the last kick
// up to the present time, which is the load times the time of that kick.
void pins_fill(Outputs& o, const System& system, const State& s) {
  const double half = dynamics::last_half(system, s);
  for (std::size_t p = 0; p < o.pins.size(); ++p) {
    const math::Wrench &impulse = s.pin_impulse[p], &load = o.pin_load[p];
    for (std::size_t k = 0; k < 3; ++k) {
      const bool moved = s.advance_length > 0 && !system.fit;
      o.pins[p].force[k] =
          moved ? (impulse.force[k] + half * load.force[k]) / s.advance_length : load.force[k];
      o.pins[p].torque[k] =
          moved ? (impulse.torque[k] + half * load.torque[k]) / s.advance_length : load.torque[k];
    }
  }
}

// Likewise for bodies, where the load is already the impulse of the last kick.
void bodies_fill(Outputs& o, const System& system, const dynamics::Motion& motion, const State& s) {
  const bool moved = s.advance_length > 0 && !system.fit, half = dynamics::last_half(system, s) > 0;
  for (std::size_t b = 0; b < o.bodies.size(); ++b) {
    math::Wrench load = motion.contact.load[b];
    if (moved) {
      const double last = half ? 1 : 0, length = s.advance_length;
      load.force = (1 / length) * (s.body[b].impulse.force + last * load.force);
      load.torque = (1 / length) * (s.body[b].impulse.torque + last * load.torque);
    }
    std::copy(load.force.begin(), load.force.end(), o.bodies[b].force);
    std::copy(load.torque.begin(), load.torque.end(), o.bodies[b].torque);
  }
}

void seams_fill(Outputs& o, const System& system, const State& s) {
  for (std::size_t k = 0; k < o.seams.size(); ++k) {
    const model::Seam& seam = system.seams.seam[k];
    drape_seam& view = o.seams[k];
    view.gap_max = view.length = 0;
    view.closed = 1;
    view.due = 0;
    Vec3 before{};
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      const model::SeamPair& pair = system.seams.pair[p];
      const Vec3 a = model::point_now(pair.side[0], s), b = model::point_now(pair.side[1], s),
                 middle = 0.5 * (a + b);
      view.gap_max = std::max(view.gap_max, norm(b - a));
      if (s.sewn[p] != model::Sewn::kOpen) view.due = 1;
      if (s.sewn[p] != model::Sewn::kWelded || view.gap_max > seam.gap_tolerance) view.closed = 0;
      if (p > seam.first) view.length += norm(middle - before);
      before = middle;
    }
  }
}

double* nodes_fill(std::vector<double>& to, const System& system, const Array& x, const Array& y,
                   const Array& z) {
  to.resize(3 * system.particle.size());
  double* at = to.data();
  for (std::size_t n : system.particle) {
    *at++ = x[n];
    *at++ = y[n];
    *at++ = z[n];
  }
  return to.data();
}

void summary_fill(Outputs& o, const System& system, const State& s, const contact::ContactStops& stops) {
  const StrainSummary strain = strain_summary(system, s);
  o.c_view.strain_warp = strain.warp;
  o.c_view.strain_weft = strain.weft;
  o.c_view.strain_bias = strain.bias;
  o.c_view.tension_max = strain.tension_max;
  o.c_view.strain_beyond_test_count = strain.beyond_test_count;
  const model::ContactSummary contact = contact::contact_summary(system, s, stops),
                              self = contact::self_summary(system, s);
  o.c_view.contact_count = double(contact.count + self.count);
  o.c_view.contact_penetration = std::max(contact.penetration, self.penetration);
  o.c_view.contact_pressure = std::max(contact.pressure, self.pressure);
  o.c_view.step_size = s.h_old > 0 ? s.h_old : system.communication / double(s.steps_per_interval);
  o.c_view.step_count = double(s.steps);
  const double stability = o.c_view.step_size * std::sqrt(s.omega2) / dynamics::step_limit_angle(system);
  o.c_view.step_stability = s.guard.failing ? std::max(stability, 1.0) : stability;
  o.c_view.fit_residual = s.relaxation.residual;
}

void energy_fill(Outputs& o, const System& system, dynamics::Motion& motion, const State& s) {
  drape_energy& e = o.c_view.energy;
  e = dynamics::potential_energy(system, s);
  e.kinetic = model::kinetic_energy(system, o.velocity[0], o.velocity[1], o.velocity[2]);
  if (!o.c_view.has_balance) return;
  const dynamics::BalanceNow now =
      dynamics::balance_now(system, motion.balance, s, dynamics::velocity_extrapolation(system, s),
                            {o.velocity[0], o.velocity[1], o.velocity[2]});
  e.dissipated = now.dissipated + o.half_kick.dissipated;
  e.input = now.input + s.drive_work + o.half_kick.work_of_drives + o.half_kick.work_of_bodies;
  e.balance_error = dynamics::energy_sum(e) - s.energy_start - e.input + e.dissipated;
}

}  // namespace

void outputs_make(Outputs& o, const Scene& scene, const System& system) {
  for (const scene::ProbeSpec& probe : scene.probes) o.probes.push_back({probe.name.c_str(), {}, {}});
  for (const scene::PinSpec& pin : scene.pins) o.pins.push_back({pin.name.c_str(), {}, {}});
  for (std::size_t k = 0; k < scene.seams.size(); ++k) {
    const model::Seam& seam = system.seams.seam[k];
    o.seams.push_back(
        {scene.seams[k].name.c_str(), int(seam.count), {seam.length[0], seam.length[1]}, 0, 0, 0, 0});
  }
  for (const scene::BodySpec& body : scene.bodies) o.bodies.push_back({body.name.c_str(), {}, {}});
  for (Array& v : o.velocity) v.assign(system.nodes, 0.0);
  o.c_view.has_energy = scene.energy;
  o.c_view.has_balance = system.energy;
  o.c_view.has_self_contact = scene.self_contact;
  o.c_view.has_fit = scene.mode == scene::Mode::kFit;
  o.c_view.probe_count = int(o.probes.size());
  o.c_view.probe = o.probes.data();
  o.c_view.pin_count = int(o.pins.size());
  o.c_view.pin = o.pins.data();
  o.c_view.seam_count = int(o.seams.size());
  o.c_view.seam = o.seams.data();
  o.c_view.body_count = int(o.bodies.size());
  o.c_view.body = o.bodies.data();
  o.c_view.node_count = int(system.particle.size());
}

void outputs_fill(Outputs& o, const System& system, dynamics::Motion& motion, const State& s, int mask) {
  const contact::ContactStops stops =
      mask & DRAPE_OUT_STRAIN ? dynamics::leapfrog_stops(system, motion, s) : contact::ContactStops{};
  if (mask & (DRAPE_OUT_VELOCITY | DRAPE_OUT_ENERGY | DRAPE_OUT_NODE_VELOCITY))
    o.half_kick = dynamics::leapfrog_synchronous(
        system, motion, s, {o.velocity[0].data(), o.velocity[1].data(), o.velocity[2].data()}, o.pin_load);
  if (mask & DRAPE_OUT_POSITION) {
    probes_fill(o, system, &drape_probe::position, s.x, s.y, s.z);
    seams_fill(o, system, s);
  }
  if (mask & DRAPE_OUT_VELOCITY) {
    probes_fill(o, system, &drape_probe::velocity, o.velocity[0], o.velocity[1], o.velocity[2]);
    pins_fill(o, system, s);
    bodies_fill(o, system, motion, s);
  }
  if (mask & DRAPE_OUT_STRAIN) summary_fill(o, system, s, stops);
  if ((mask & DRAPE_OUT_ENERGY) && o.c_view.has_energy) energy_fill(o, system, motion, s);
  if (mask & DRAPE_OUT_NODE_POSITION)
    o.c_view.node_position = nodes_fill(o.node_position, system, s.x, s.y, s.z);
  if (mask & DRAPE_OUT_NODE_VELOCITY)
    o.c_view.node_velocity = nodes_fill(o.node_velocity, system, o.velocity[0], o.velocity[1], o.velocity[2]);
}

}  // namespace drape::outputs
