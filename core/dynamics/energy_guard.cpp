// What the guard judges is the modified energy H (modified_energy.h), less the work of pins and closing
// seams, which is known step by step. What the damping -m c v takes is found from its power at the checks of
// the step limit; how far that jumps from one to the next counts as unknown.
#include "dynamics/energy_guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "dynamics/modified_energy.h"
#include "dynamics/potential_energy.h"
#include "math/vector3.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {

using namespace math::vector3;

namespace {

constexpr double kUntouched = 0.002;  // of the largest energy: what may be missing without more steps
constexpr double kRipple = 0.003;     // of the largest energy: the ripple of T + U without more steps
constexpr double kRippleOfTwice = 4;  // the ripple at twice the step, over that at the step
// The paper's scheme, whose ripple is of order h. It is not judged in the first kGuardSteps steps: a cloth
// that falls from rest begins with a ripple as large as its energy.
constexpr double kRippleOfPaper = 0.005;
constexpr double kRippleOfPaperTwice = 2;
constexpr double kGrowth = 0.001;     // of the largest energy, more than at the last refinement
constexpr double kSeriesHolds = 0.1;  // of the largest energy: the energy of a step, at most
constexpr double kSameStep = 1e-6;    // relative change of the step that counts as none
constexpr double kLost = 10;          // kGuardAllowed, where the run stops
constexpr double kMaxRefinement = 16;
constexpr double kStepsBeforeEase = 25600;  // without a failure, before the refinement halves; times
constexpr double kMoreBeforeEase = 4;       // this with every refinement after the first
constexpr int kMostRefinements = 30;        // that count so
// Of the largest energy at the last refinement: beyond it, what was missing then is little.
constexpr double kGrown = 4, kStepsBeforeEaseGrown = 1024;
constexpr double kJolt = 1e-4;   // of the largest energy: m |change of v|^2/2 in a jump that counts
constexpr double kFloor = 1e-5;  // of weight times size
constexpr double kFloorWithoutGravity = 1e-6;  // m/s^2, of mass times size
constexpr double kDeviations = 3;              // of the sum of samples
constexpr std::size_t kFewParticles = 64;      // one vibration may keep time with the checks: all steps count
constexpr double kSampling = 0.02;             // of that sum, beside its deviation

double energy_size(const drape_energy& e, const State& s) {
  return std::abs(e.kinetic) + e.stretch + e.shear + e.bending + std::abs(e.gravity - s.guard.gravity) +
         std::abs(s.drive_work);
}

// J, the least that the largest energy counts as.
double size_floor(const System& system) {
  double mass = 0, area = 0;
  for (std::size_t n : system.particle) mass += system.mass[n], area += system.area[n];
  return mass * std::sqrt(area) * std::max(kFloor * norm(system.gravity), kFloorWithoutGravity);
}

// J, of what damping takes.
double unknown(const model::EnergyGuard& g) {
  return kDeviations * std::sqrt(g.variance) + kSampling * g.damped;
}

// Follows a change (J) of the energy of the step: neither energy nor ripple.
void step_energy_add(model::EnergyGuard& g, double change) {
  g.balance += change;
  g.step_energy += change;
}

// J, the energy of the step that counts. Where cloth has stiffened so much that its step was far too large,
// the series of H has no value.
double step_energy_of(const System& system, const State& s, const StepEnergy& step) {
  return std::abs(step.second + step.fourth) <= kSeriesHolds * guard_size(system, s) ? step.sum()
                                                                                     : s.guard.step_energy;
}

// Follows the energy of the step through a change of the step to h. The paper's scheme takes V_n for the
// velocity half a step before t_n, whatever the step; so more changes with it.
void step_follow(const System& system, Motion& motion, State& s, double h) {
  model::EnergyGuard& g = s.guard;
  const ModifiedEnergy before = modified_energy(system, motion, s, g.h);
  if (is_paper(system)) {
    const ModifiedEnergy after = modified_energy(system, motion, s, h);
    const double old = step_energy_of(system, s, before.step), now = after.step.sum();
    g.balance += (after.h_less_work - now) - (before.h_less_work - before.step.sum());
    step_energy_add(g, now - old);
  } else {
    const double square = h * h / (g.h * g.h), old = step_energy_of(system, s, before.step);
    step_energy_add(g, square * before.step.second + square * square * before.step.fourth - old);
  }
  g.h = h;
}

// What is missing when a refinement is decided on.
void missing_remember(State& s) {
  s.guard.missing_refined = guard_missing(s);
  s.guard.ripple_refined = std::abs(s.guard.ripple);
}

// Halves the refinement where it has not been needed for long.
void ease(model::EnergyGuard& g, std::int64_t steps, double size, double ripple_allowed,
          double ripple_of_twice) {
  const bool grown = size > kGrown * g.size_refined;
  const double wait =
      grown ? kStepsBeforeEaseGrown : kStepsBeforeEase * std::pow(kMoreBeforeEase, g.refinements - 1);
  if (g.refinement <= 1 || double(steps - g.refined) < wait) return;
  if (ripple_of_twice * g.ripple_largest <= ripple_allowed) {
    g.refinement /= 2;
    if (grown) g.refinements = std::max(g.refinements - 1, 0);
  }
  g.refined = steps;
  g.ripple_largest = 0;
}

void worst_update(model::EnergyGuard& g, double missing, double size, double time) {
  if (missing * g.worst_size <= std::abs(g.worst) * size) return;
  g.worst = std::copysign(missing, g.unaccounted);
  g.worst_size = size;
  g.worst_time = time;
}

// Updates what is missing at a time that is `length` s after that of the state. What damping along links and
// air take is not known; they do not give it back.
void account(const System& system, const ModifiedEnergy& sight, State& s, double length) {
  model::EnergyGuard& g = s.guard;
  guard_damped(system, s, sight.energy.kinetic);
  g.largest = std::max(g.largest, energy_size(sight.energy, s));
  g.unaccounted = sight.h_less_work + g.damped - g.balance;
  if (model::system_has_rates(system) && g.unaccounted < 0) {
    g.balance += g.unaccounted;
    g.unaccounted = 0;
  }
  g.ripple = g.step_energy - sight.step.sum();
  g.ripple_largest = std::max(g.ripple_largest, std::abs(g.ripple));
  worst_update(g, guard_missing(s), guard_size(system, s),
               model::state_time(s, system.communication) + length);
}

// Ends the balance. Where changes come often, the next one begins so much later that there are kGuardSteps
// from the begin of one to that of the next.
void guard_pause(const System& system, Motion& motion, State& s, bool rare) {
  model::EnergyGuard& g = s.guard;
  g.begun = false;
  if (s.steps > g.checked) account(system, modified_energy(system, motion, s, g.h), s, 0);
  g.gravity -= gravity_energy(system, s);
  g.checked = rare ? s.steps : std::max(s.steps, g.opened + kGuardSteps);
  g.period = rare ? 1 : kGuardSteps;
}

}  // namespace

double guard_missing(const State& s) {
  return std::max(std::abs(s.guard.unaccounted) - unknown(s.guard), 0.0);
}

double guard_excess(const State& s) { return std::max(guard_missing(s), std::abs(s.guard.ripple)); }

bool guard_lost(const System& system, const State& s) {
  return guard_missing(s) > kLost * kGuardAllowed * guard_size(system, s);
}

double guard_size(const System& system, const State& s) {
  return std::max(s.guard.largest, size_floor(system));
}

bool guard_watches(const System& system, const State& s) {
  if (system.fit) return false;
  if (!system.bodies.empty() || contact::self_enabled(system) || !system.links.empty()) return false;
  return !(model::system_has_air(system) && norm(s.wind) > 0);
}

void guard_step(const System& system, Motion& motion, State& s, double h) {
  model::EnergyGuard& g = s.guard;
  if (g.begun && system.damping > 0 && system.particle.size() <= kFewParticles)
    guard_damped(system, s, model::kinetic_energy(system, s));
  if (!g.begun && s.steps >= g.checked && guard_watches(system, s)) {
    g.h = h;
    const ModifiedEnergy sight = modified_energy(system, motion, s, g.h);
    g.begun = true;
    g.checked = g.opened = s.steps;
    g.power = 2 * system.damping * sight.energy.kinetic;
    g.since = 0;
    g.gravity += sight.energy.gravity;
    g.balance = sight.h_less_work + g.damped - g.unaccounted;
    g.step_energy = sight.step.sum() + g.ripple;
    g.largest = std::max(g.largest, energy_size(sight.energy, s));
  } else if (g.begun && std::abs(h - g.h) > kSameStep * h) {
    step_follow(system, motion, s, h);
  }
  g.since += h;
}

void guard_advance(const System& system, const Path& path, State& s) {
  double change2 = 0;
  for (const PinPath& p : path.pins) {
    const Vec3 change = p.to.velocity - p.from.velocity;
    change2 = std::max(change2, dot(change, change));
  }
  if (change2 == 0) return;
  double mass = 0;
  for (std::size_t n : system.particle) mass += system.mass[n];
  if (mass * change2 / 2 > guard_size(system, s)) s.guard.period = 1;
}

void guard_jump(const System& system, Motion& motion, State& s, const std::array<Array, 3>& before) {
  model::EnergyGuard& g = s.guard;
  if (!g.begun || system.composition || is_pulled(s)) return;
  double jolt = 0;
  for (std::size_t n : system.particle) {
    const double x = s.vx[n] - before[0][n], y = s.vy[n] - before[1][n], z = s.vz[n] - before[2][n];
    jolt += system.mass[n] * (x * x + y * y + z * z) / 2;
  }
  if (jolt <= kJolt * guard_size(system, s)) return;
  const double change = step_energy_of_motion(system, motion, s, {s.vx, s.vy, s.vz}, g.h).sum() -
                        step_energy_of_motion(system, motion, s, before, g.h).sum();
  step_energy_add(g, change);
  g.period = 1;
}

void guard_set_inputs(const System& system, Motion& motion, State& s, const std::function<void()>& set) {
  if (!s.guard.begun || !is_paper(system)) return set();
  const StepEnergy before = modified_energy(system, motion, s, s.guard.h).step;
  set();
  const StepEnergy after = modified_energy(system, motion, s, s.guard.h).step;
  step_energy_add(s.guard, after.second + after.fourth - before.second - before.fourth);
}

void change_begin(const System& system, Motion& motion, State& s, Change change) {
  if (s.guard.begun) guard_pause(system, motion, s, change == Change::kRare);
  leapfrog_complete(system, motion, s);
}

void guard_accept(State& s, double refinement) {
  model::EnergyGuard& g = s.guard;
  if (g.refinement > refinement) {
    s.steps_per_interval = std::int64_t(std::ceil(double(s.steps_per_interval) * refinement / g.refinement));
    s.steps_to_limit_check = 0;
  }
  g.refinement = refinement;
  missing_remember(s);
}

bool guard_refine(State& s, double size, bool again) {
  model::EnergyGuard& g = s.guard;
  if (g.refinement >= kMaxRefinement || 2 * s.steps_per_interval > kMaxStepsPerInterval) return false;
  g.refined = s.steps;
  g.ripple_largest = 0;
  missing_remember(s);
  g.size_refined = size;
  if (!again) g.refinements = std::min(g.refinements + 1, kMostRefinements);
  g.refinement *= 2;
  s.steps_per_interval *= 2;
  s.steps_to_limit_check = 0;
  s.intervals_since_change = 0;
  return true;
}

void guard_damped(const System& system, State& s, double kinetic) {
  model::EnergyGuard& g = s.guard;
  const double power = 2 * system.damping * kinetic, change = power - g.power;
  g.damped += g.since * (power + g.power) / 2;
  g.variance += g.since * g.since * change * change / 2;
  g.power = power;
  g.since = 0;
}

void guard_look(const System& system, Motion& motion, State& s) {
  if (s.guard.begun && guard_watches(system, s) && s.steps > s.guard.checked)
    account(system, modified_energy(system, motion, s, s.guard.h), s, 0);
}

Guard guard_check(const System& system, Motion& motion, State& s, double length) {
  model::EnergyGuard& g = s.guard;
  g.begun = g.begun && guard_watches(system, s);
  if (!g.begun || s.steps - g.checked < g.period) return Guard::kKept;
  account(system, modified_energy(system, motion, s, g.h), s, length);
  g.checked = s.steps;
  g.period = std::min(2 * g.period, kGuardSteps);
  const double size = guard_size(system, s), missing = guard_missing(s), ripple = std::abs(g.ripple);
  g.failing = missing > kUntouched * size && missing - g.missing_refined > kGrowth * size;
  const double allowed = is_paper(system) ? kRippleOfPaper : kRipple;
  const bool ripples = s.steps >= (is_paper(system) ? kGuardSteps : 0) && ripple > allowed * size &&
                       ripple - g.ripple_refined > kGrowth * size;
  if (guard_lost(system, s) && (system.step_given > 0 || g.refinement >= kMaxRefinement)) return Guard::kLost;
  if (g.failing || ripples) return Guard::kRepeat;
  ease(g, s.steps, size, allowed * size, is_paper(system) ? kRippleOfPaperTwice : kRippleOfTwice);
  return Guard::kKept;
}

}  // namespace drape::dynamics
