// A kick at t_n turns v- = v_{n-1/2} into v+ = v_{n+1/2} by the impulse J of all forces over (h_o + h)/2, and
// the kinetic energy grows by exactly J.(v- + v+)/2. So each force's part of J times the midpoint velocity is
// its work:
//
//   -m c v      m c (h_o v- + h v+)/2 . (v- + v+)/2 is taken away        (paper scheme: m c h v-)
//   rates       F the damping along springs and the air, A the air alone, u = v - wind:
//               -(h_o + h)/2 [F.(v- + v+)/2 - A.wind] is taken away, (h_o + h)/2 A.wind brought in
//
// A turning clamp does work on the hinges between R D and its links: E(R', r) - E(R, r) for a turn from R to
// R', the mean of both ends of the step.
//
// Between kicks the potential energy grows by F.dr, which the work of the kicks equals to O(h^2).
#include "dynamics/energy_balance.h"

#include "dynamics/kernel/kernel.h"
#include "forces/hinge_energy.h"
#include "forces/irregular_elements.h"
#include "forces/rates.h"
#include "forces/seam_closing.h"
#include "model/elements.h"
#include "model/kinetic_energy.h"
#include "model/node_sums.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

void rates_set(const System& system, Balance& b, const State& s, double extrapolation) {
  b.air = {0, 0, 0};
  if (model::system_has_rates(system))
    b.air = forces::rate_forces(system, s, extrapolation, b.fx.data(), b.fy.data(), b.fz.data());
}

// sum F.v over the particles
double power(const System& system, const Balance& b, const Array& vx, const Array& vy, const Array& vz) {
  if (!model::system_has_rates(system)) return 0;
  double sum = 0;
  for (std::size_t n : system.particle) sum += b.fx[n] * vx[n] + b.fy[n] * vy[n] + b.fz[n] * vz[n];
  return sum;
}

Vec3 link_now(const model::ClampHinge& c, const State& s) {
  const std::size_t from = c.node[0], to = c.node[1];
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}

}  // namespace

Balance balance_make(const System& system) {
  Balance b;
  b.held.resize(system.irregular.clamps.size());
  b.link.resize(system.irregular.clamps.size());
  b.pull.resize(system.seams.pair.size());
  b.rate.resize(system.seams.pair.size());
  if (!system.energy) return b;
  for (Array* a : {&b.vx, &b.vy, &b.vz, &b.fx, &b.fy, &b.fz}) a->assign(system.nodes, 0.0);
  return b;
}

void clamps_begin(const System& system, Balance& b, const State& s) {
  for (std::size_t k = 0; k < b.held.size(); ++k) {
    b.held[k] = forces::clamp_direction(system.irregular.clamps[k], s);
    b.link[k] = link_now(system.irregular.clamps[k], s);
  }
}

double clamps_work(const System& system, const Balance& b, const State& s) {
  double sum = 0;
  for (std::size_t k = 0; k < system.irregular.clamps.size(); ++k) {
    const model::ClampHinge& c = system.irregular.clamps[k];
    const Vec3 held = forces::clamp_direction(c, s), link = link_now(c, s);
    const double turned =
        forces::hinge_energy_between(held, link) - forces::hinge_energy_between(b.held[k], link) +
        forces::hinge_energy_between(held, b.link[k]) - forces::hinge_energy_between(b.held[k], b.link[k]);
    sum += model::law_bending(system.lattices[std::size_t(c.lattice)].law, c.warp) * c.share * turned / 2;
  }
  return sum;
}

void pull_begin(const System& system, Balance& b, const State& s, double extrapolation) {
  for (const model::Seam& seam : system.seams.seam)
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      if (s.sewn[p] != model::Sewn::kPulled) continue;
      b.pull[p] = forces::seam_closing_force(system, seam, p, s, extrapolation);
      b.rate[p] = model::sum_value(system.seams.pair[p].gap, s.vx, s.vy, s.vz);
    }
}

double pull_work(const System& system, const Balance& b, const State& s, double span) {
  double power = 0;
  for (std::size_t p = 0; p < b.pull.size(); ++p)
    if (s.sewn[p] == model::Sewn::kPulled)
      power += dot(b.pull[p], b.rate[p] + model::sum_value(system.seams.pair[p].gap, s.vx, s.vy, s.vz)) / 2;
  return span * power;
}

double pull_power(const System& system, Balance& b, const State& s, const model::Field& v) {
  if (!forces::seams_any_pulled(s)) return 0;
  pull_begin(system, b, s, velocity_extrapolation(system, s));
  double sum = 0;
  for (std::size_t p = 0; p < b.pull.size(); ++p)
    if (s.sewn[p] == model::Sewn::kPulled)
      sum += dot(b.pull[p], model::sum_value(system.seams.pair[p].gap, v.x, v.y, v.z));
  return sum;
}

void balance_begin(const System& system, Balance& b, const State& s, double extrapolation) {
  b.vx = s.vx;
  b.vy = s.vy;
  b.vz = s.vz;
  rates_set(system, b, s, extrapolation);
  b.wind = s.wind;
}

void balance_end(const System& system, const Balance& b, State& s, double h_old, double h) {
  const bool paper = system.integrator == scene::Integrator::kPaper;
  const double span = paper ? h : (h_old + h) / 2;
  const double before = paper ? h : h_old / 2, after = paper ? 0 : h / 2;  // of -m c v
  double damped = 0;
  const Array* v0[] = {&b.vx, &b.vy, &b.vz};
  const Array* v1[] = {&s.vx, &s.vy, &s.vz};
  if (system.damping > 0)
    for (int k = 0; k < 3; ++k)
      for (std::size_t n : system.particle) {
        const double p = (*v0[k])[n], q = (*v1[k])[n];
        damped += system.mass[n] * (before * p + after * q) * (p + q) / 2;
      }
  const double wind = span * dot(b.air, b.wind);
  const double rates = span / 2 * (power(system, b, b.vx, b.vy, b.vz) + power(system, b, s.vx, s.vy, s.vz));
  s.dissipated += system.damping * damped - (rates - wind);
  s.input += wind;
}

void balance_drifted(const System& system, State& s, double decay) {
  if (system.damping > 0) s.dissipated += model::kinetic_energy(system, s) * (1 - decay * decay);
}

BalanceNow balance_now(const System& system, Balance& b, const State& s, double extrapolation,
                       const Velocities& v) {
  const Array &vx = v.x, &vy = v.y, &vz = v.z;
  if (system.integrator == scene::Integrator::kPaper || system.composition) return {s.dissipated, s.input};
  rates_set(system, b, s, extrapolation);
  const double damped = system.damping > 0 ? 2 * model::kinetic_energy(system, vx, vy, vz) : 0;
  const double half = s.h_old / 2, wind = dot(b.air, s.wind);
  return {s.dissipated + half * (system.damping * damped - (power(system, b, vx, vy, vz) - wind)),
          s.input + half * wind};
}

}  // namespace drape::dynamics
