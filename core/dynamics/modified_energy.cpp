#include "dynamics/modified_energy.h"

#include <algorithm>
#include <vector>

#include "dynamics/constraint_projection.h"
#include "dynamics/kernel/kernel.h"
#include "dynamics/potential_energy.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {
namespace {

// Each node that a pin moves, once.
std::vector<std::size_t> moved_nodes(const Motion& m) {
  std::vector<std::size_t> nodes;
  for (const constraint::FixedNode& f : m.constraints.fixed)
    if (f.target.moves) nodes.push_back(f.node);
  for (std::size_t r : m.constraints.rows_with_target)
    if (m.constraints.rows[r].target.moves)
      nodes.insert(nodes.end(), m.constraints.rows[r].on.node.begin(), m.constraints.rows[r].on.node.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// The sum of a quantity of particles, without those of nodes that pins move.
template <class Term>
double sum_free(const System& system, const Motion& m, Term term) {
  double sum = 0;
  for (std::size_t n : system.particle) sum += term(n);
  for (std::size_t n : moved_nodes(m)) sum -= term(n);
  return sum;
}

// J, h^2 F.(F/m)/8, by the change of velocity from v_{n-1/2} to `now`, half a step of h.
double kick_energy(const System& system, const Motion& m, const State& s) {
  const double energy = sum_free(system, m, [&](std::size_t n) {
    const double x = m.now_x[n] - s.vx[n], y = m.now_y[n] - s.vy[n], z = m.now_z[n] - s.vz[n];
    return system.mass[n] * (x * x + y * y + z * z) / 2;
  });
  return std::max(energy, 0.0);
}

// J, how much more kinetic energy the particles have at `now` than in the state.
double kinetic_gain(const System& system, const Motion& m, const State& s) {
  return sum_free(system, m, [&](std::size_t n) {
    const auto gain = [](double now, double v) { return (now - v) * (now + v); };
    return system.mass[n] / 2 *
           (gain(m.now_x[n], s.vx[n]) + gain(m.now_y[n], s.vy[n]) + gain(m.now_z[n], s.vz[n]));
  });
}

}  // namespace

bool is_pulled(const State& s) {
  return std::find(s.sewn.begin(), s.sewn.end(), model::Sewn::kPulled) != s.sewn.end();
}

bool is_paper(const System& system) { return system.integrator == scene::Integrator::kPaper; }

StepEnergy step_energy_of_motion(const System& system, Motion& motion, State& s,
                                 const std::array<Array, 3>& v, double h) {
  const Array x = s.x, y = s.y, z = s.z;
  std::array<Array, 3> ahead, behind;
  for (std::array<Array, 3>* force : {&ahead, &behind}) {
    const double way = force == &ahead ? h : -h;
    for (std::size_t n : system.particle) {
      s.x[n] = x[n] + way * v[0][n];
      s.y[n] = y[n] + way * v[1][n];
      s.z[n] = z[n] + way * v[2][n];
    }
    for (Array& one : *force) one.assign(system.nodes, 0.0);
    kernel_forces(*motion.kernel, system, s, motion.workspace,
                  {(*force)[0].data(), (*force)[1].data(), (*force)[2].data()});
  }
  s.x = x, s.y = y, s.z = z;
  StepEnergy energy;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t n : system.particle) {
      const double change = (behind[k][n] - ahead[k][n]) / 2;
      energy.second += h / 12 * v[k][n] * change;
      ahead[k][n] = change / system.mass[n];
    }
  HeldMotion held = motion.held;
  std::fill(held.rate.begin(), held.rate.end(), 0.0);
  constraints_project(system, motion.constraints, held, {ahead[0].data(), ahead[1].data(), ahead[2].data()},
                      nullptr);
  for (const Array& change : ahead)
    for (std::size_t n : system.particle)
      energy.fourth += h * h / 60 * system.mass[n] * change[n] * change[n];
  return energy;
}

ModifiedEnergy modified_energy(const System& system, Motion& motion, State& s, double h) {
  ModifiedEnergy of;
  // Where v_n has been completed, the next half kick tells what the last one would.
  const bool completed = s.h_old == 0 && !is_paper(system);
  if (completed) s.h_old = h;
  std::vector<math::Wrench> loads;
  const model::Scheme scheme = is_paper(system)
                                   ? model::Scheme{.pass = model::Pass::kSynchronous, .half = h / 2}
                                   : scheme_of_last_kick(system, s);
  const HalfKick half = half_kick(system, motion, s, scheme, motion_field(motion), loads);
  const double h_kick = is_paper(system) ? h : s.h_old;
  const double kick = kick_energy(system, motion, s) * h * h / (h_kick * h_kick);
  if (completed) {
    s.h_old = 0;
    motion.now_x = s.vx, motion.now_y = s.vy, motion.now_z = s.vz;
  }
  of.energy = potential_energy(system, *motion.kernel, s);
  of.energy.kinetic = model::kinetic_energy(system, motion.now_x, motion.now_y, motion.now_z);
  if (!system.composition && is_pulled(s)) {
    if (system.step_given > 0) of.step.second = -kick;
  } else if (!system.composition) {
    of.step = step_energy_of_motion(system, motion, s, {motion.now_x, motion.now_y, motion.now_z}, h);
    of.step.second -= kick / 3;
  }
  of.h_less_work =
      energy_sum(of.energy) + of.step.sum() - s.drive_work - (completed ? 0 : half.work_of_drives);
  if (is_paper(system)) {
    of.step.first = kinetic_gain(system, motion, s);
    of.energy.kinetic = model::kinetic_energy(system, s);  // of V_n
  }
  return of;
}

}  // namespace drape::dynamics
