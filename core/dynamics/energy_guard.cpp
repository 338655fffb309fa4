// In leapfrog the energy m v-.v+/2 + U of linear cloth is constant, v- and v+ half a step before and after.
// With the synchronous velocity v = (v- + v+)/2 it is m v^2/2 - m (v - v-)^2/2 + U. The second term is that
// of the step: it grows with h^2, so a change of the step changes the constant. What pins and closing seams
// bring in is known step by step. What the damping -m c v takes is found from its power at the checks of the
// step limit; how far that jumps from one to the next counts as unknown.
#include "dynamics/energy_guard.h"

#include <algorithm>
#include <cmath>

#include "dynamics/potential_energy.h"
#include "math/vector3.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {
namespace {

constexpr double kUntouched = 0.003;  // of the largest energy: what may be missing without more steps
constexpr double kGrowth = 0.001;     // of the largest energy, more than at the last refinement
constexpr double kSameStep = 1e-6;    // relative change of the step that counts as none
constexpr double kLost = 10;          // kGuardAllowed, where the run stops
constexpr double kMaxRefinement = 16;
constexpr double kStepsBeforeEase = 25600;     // without a failure, before the refinement halves; times
constexpr double kMoreBeforeEase = 4;          // this with every refinement after the first
constexpr int kMostRefinements = 30;           // that count so
constexpr double kFloor = 1e-5;                // of weight times size
constexpr double kFloorWithoutGravity = 1e-6;  // m/s^2, of mass times size
constexpr double kDeviations = 3;              // of the sum of samples
constexpr double kSampling = 0.02;             // of that sum, beside its deviation

// J, the term of the step; 0 above order 2. Nodes that pins move have none: their kinetic energy is what pins
// bring in.
double step_term(const System& system, const Motion& m, const State& s) {
  if (system.composition) return 0;
  const auto term = [&](std::size_t n) {
    const double x = m.now_x[n] - s.vx[n], y = m.now_y[n] - s.vy[n], z = m.now_z[n] - s.vz[n];
    return system.mass[n] * (x * x + y * y + z * z) / 2;
  };
  double sum = 0;
  for (std::size_t n : system.particle) sum += term(n);
  for (const constraint::FixedNode& f : m.constraints.fixed)
    if (f.target.moves) sum -= term(f.node);
  for (std::size_t r : m.constraints.rows_with_target)
    for (std::size_t n : m.constraints.rows[r].on.node)
      if (m.constraints.rows[r].target.moves) sum -= term(n);
  return std::max(sum, 0.0);
}

// What the guard sees at t_n.
struct Sight {
  drape_energy energy{};
  double step = 0;     // J, the term of the step
  double balance = 0;  // J, energy with that term, less the work of pins and closing seams
};

Sight look(const System& system, Motion& motion, const State& s) {
  Sight sight;
  std::vector<math::Wrench> loads;
  const HalfKick half = leapfrog_synchronous(system, motion, s, motion_field(motion), loads);
  sight.energy = potential_energy(system, *motion.kernel, s);
  sight.energy.kinetic = model::kinetic_energy(system, motion.now_x, motion.now_y, motion.now_z);
  sight.step = step_term(system, motion, s);
  sight.balance = energy_sum(sight.energy) - sight.step - s.drive_work - half.work_of_drives;
  return sight;
}

double energy_size(const drape_energy& e, const State& s) {
  return std::abs(e.kinetic) + e.stretch + e.shear + e.bending + std::abs(e.gravity - s.guard.gravity) +
         std::abs(s.drive_work);
}

// J, the least that the largest energy counts as.
double size_floor(const System& system) {
  double mass = 0, area = 0;
  for (std::size_t n : system.particle) mass += system.mass[n], area += system.area[n];
  return mass * std::sqrt(area) *
         std::max(kFloor * math::vector3::norm(system.gravity), kFloorWithoutGravity);
}

// J, of what damping takes.
double unknown(const model::EnergyGuard& g) {
  return kDeviations * std::sqrt(g.variance) + kSampling * g.damped;
}

void worst_update(model::EnergyGuard& g, double missing, double time) {
  if (missing <= std::abs(g.worst)) return;
  g.worst = std::copysign(missing, g.unaccounted);
  g.worst_time = time;
}

// Updates what is missing at a time that is `length` s after that of the state.
void account(const System& system, const Sight& sight, State& s, double length) {
  model::EnergyGuard& g = s.guard;
  guard_damped(system, s, s.h_old, sight.energy.kinetic);
  g.largest = std::max(g.largest, energy_size(sight.energy, s));
  g.unaccounted = sight.balance + g.damped - g.balance;
  worst_update(g, guard_missing(system, s), model::state_time(s, system.communication) + length);
}

// Ends the balance. Where it began a short time ago and changes are not rare, what is missing since is not
// found, and the next balance begins later.
void guard_pause(const System& system, Motion& motion, State& s, bool rare) {
  model::EnergyGuard& g = s.guard;
  g.begun = false;
  const bool known = rare || s.steps - g.checked >= kGuardSteps;
  if (known) account(system, look(system, motion, s), s, 0);
  g.checked = known ? s.steps : s.steps + kGuardSteps;
  g.period = rare ? 1 : kGuardSteps;
}

}  // namespace

// Damping along links and still air only take energy, and how much is not known.
double guard_missing(const System& system, const State& s) {
  if (model::system_has_rates(system) && s.guard.unaccounted < 0) return 0;
  return std::max(std::abs(s.guard.unaccounted) - unknown(s.guard), 0.0);
}

double guard_size(const System& system, const State& s) {
  return std::max(s.guard.largest, size_floor(system));
}

bool guard_watches(const System& system, const State& s) {
  if (system.fit || system.integrator == scene::Integrator::kPaper) return false;
  if (!system.bodies.empty() || contact::self_enabled(system) || !system.links.empty()) return false;
  return !(model::system_has_air(system) && math::vector3::norm(s.wind) > 0);
}

void guard_step(const System& system, Motion& motion, State& s, double h) {
  model::EnergyGuard& g = s.guard;
  if (s.h_old == 0 || (g.begun ? std::abs(h - s.h_old) <= kSameStep * h : s.steps < g.checked)) return;
  if (!guard_watches(system, s)) return;
  const Sight sight = look(system, motion, s);
  const double change = (1 - h * h / (s.h_old * s.h_old)) * sight.step;
  if (g.begun) {
    g.balance += change;
    return;
  }
  if (g.largest == 0) g.gravity = sight.energy.gravity;
  g.begun = true;
  g.checked = g.sampled = s.steps;
  g.power = 2 * system.damping * sight.energy.kinetic;
  g.balance = sight.balance + change + g.damped - g.unaccounted;
  g.largest = std::max(g.largest, energy_size(sight.energy, s));
}

void change_begin(const System& system, Motion& motion, State& s, Change change) {
  if (s.guard.begun) guard_pause(system, motion, s, change == Change::kRare);
  leapfrog_complete(system, motion, s);
}

void guard_accept(const System& system, State& s, double refinement) {
  s.guard.refinement = refinement;
  s.guard.missing_refined = guard_missing(system, s);
}

bool guard_refine(const System& system, State& s, bool again) {
  model::EnergyGuard& g = s.guard;
  g.refined = s.steps;
  g.missing_refined = guard_missing(system, s);
  if (!again) g.refinements = std::min(g.refinements + 1, kMostRefinements);
  if (g.refinement >= kMaxRefinement) return false;
  g.refinement *= 2;
  s.steps_per_interval *= 2;
  s.steps_to_limit_check = 0;
  s.intervals_since_change = 0;
  return true;
}

void guard_damped(const System& system, State& s, double h, double kinetic) {
  model::EnergyGuard& g = s.guard;
  const double power = 2 * system.damping * kinetic, time = double(s.steps - g.sampled) * h,
               change = power - g.power;
  g.damped += time * (power + g.power) / 2;
  g.variance += time * time * change * change / 2;
  g.power = power;
  g.sampled = s.steps;
}

Guard guard_check(const System& system, Motion& motion, State& s, double length) {
  model::EnergyGuard& g = s.guard;
  g.begun = g.begun && guard_watches(system, s);
  if (!g.begun || s.steps - g.checked < g.period) return Guard::kKept;
  account(system, look(system, motion, s), s, length);
  g.checked = s.steps;
  g.period = std::min(2 * g.period, kGuardSteps);
  const double size = guard_size(system, s), missing = guard_missing(system, s);
  g.failing = missing > kUntouched * size && missing - g.missing_refined > kGrowth * size;
  if (missing > kLost * kGuardAllowed * size && (system.step_given > 0 || g.refinement >= kMaxRefinement))
    return Guard::kLost;
  if (g.failing) return Guard::kRepeat;
  const double before_ease = kStepsBeforeEase * std::pow(kMoreBeforeEase, g.refinements - 1);
  if (g.refinement > 1 && double(s.steps - g.refined) >= before_ease) {
    g.refinement /= 2;
    g.refined = s.steps;
  }
  return Guard::kKept;
}

}  // namespace drape::dynamics
