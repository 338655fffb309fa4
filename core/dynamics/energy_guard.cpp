// Leapfrog keeps an energy that differs from T + U by O(h^2), but for O(h^4), whatever the laws are (Hairer,
// Lubich, Wanner 2003, Acta Numerica 12, section 3.2, the modified Hamiltonian):
//
//     H = T + U + (h^2/12) v.(U'' v) - (h^2/24) F.(F/m).
//
// In linear cloth m v-.v+/2 + U is constant too, v- and v+ half a step before and after; but where energy
// moves into stiff vibrations, it falls by (h omega)^2/6 of what moves. What H differs by is the energy of
// the step. It grows with h^2, so a change of the step changes the constant, and so does a jump of v. Pins
// that move count as particles of infinite mass. What they and closing seams bring in is known step by step.
// What the damping -m c v takes is found from its power at the checks of the step limit; how far that jumps
// from one to the next counts as unknown.
#include "dynamics/energy_guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dynamics/constraint_projection.h"
#include "dynamics/kernel/kernel.h"
#include "dynamics/potential_energy.h"
#include "math/vector3.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {

using namespace math::vector3;

namespace {

constexpr double kUntouched = 0.002;  // of the largest energy: what may be missing without more steps
constexpr double kRipple = 0.003;     // of the largest energy: the ripple of T + U without more steps
constexpr double kRippleOfTwice = 4;  // the ripple at twice the step, over that at the step
constexpr double kGrowth = 0.001;     // of the largest energy, more than at the last refinement
constexpr double kSeriesHolds = 0.1;  // of the largest energy: the energy of a step, at most
constexpr double kSameStep = 1e-6;    // relative change of the step that counts as none
constexpr double kLost = 10;          // kGuardAllowed, where the run stops
constexpr double kMaxRefinement = 16;
constexpr double kStepsBeforeEase = 25600;  // without a failure, before the refinement halves; times
constexpr double kMoreBeforeEase = 4;       // this with every refinement after the first
constexpr int kMostRefinements = 30;        // that count so
constexpr double kJolt = 1e-4;   // of the largest energy: m |change of v|^2/2 in a jump that counts
constexpr double kFloor = 1e-5;  // of weight times size
constexpr double kFloorWithoutGravity = 1e-6;  // m/s^2, of mass times size
constexpr double kDeviations = 3;              // of the sum of samples
constexpr std::size_t kFewParticles = 64;      // one vibration may keep time with the checks: all steps count
constexpr double kSampling = 0.02;             // of that sum, beside its deviation

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

// J, h^2 F.(F/m)/8, by the change of velocity from v_{n-1/2} to `now`, half a step of h.
double kick_energy(const System& system, const Motion& m, const State& s) {
  const auto term = [&](std::size_t n) {
    const double x = m.now_x[n] - s.vx[n], y = m.now_y[n] - s.vy[n], z = m.now_z[n] - s.vz[n];
    return system.mass[n] * (x * x + y * y + z * z) / 2;
  };
  double sum = 0;
  for (std::size_t n : system.particle) sum += term(n);
  for (std::size_t n : moved_nodes(m)) sum -= term(n);
  return std::max(sum, 0.0);
}

// J, the parts of the energy of the step that grow with h^2 and h^4.
struct StepEnergy {
  double second = 0, fourth = 0;
  double sum() const { return second + fourth; }
};

// The parts of motion, by h U'' v = (F(x - h v) - F(x + h v))/2.
StepEnergy motion_energy(const System& system, Motion& motion, State& s, const std::array<Array, 3>& v,
                         double h) {
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

// Forces that pull seams shut belong to no energy, and H changes by more than their work. What can be refined
// is compared by T + U, as outputs show it. At a given step that would be too strict: there it is
// m v-.v+/2 + U, which changes by their work alone in linear cloth. Every weld begins a new balance.
bool is_pulled(const State& s) {
  return std::find(s.sewn.begin(), s.sewn.end(), model::Sewn::kPulled) != s.sewn.end();
}

// What the guard sees at t_n.
struct Sight {
  drape_energy energy{};
  StepEnergy step;     // at h; 0 above order 2
  double balance = 0;  // J, H less the work of pins and closing seams
};

// Where v_n has been completed, the next half kick tells what the last one would.
Sight look(const System& system, Motion& motion, State& s) {
  Sight sight;
  const double h = s.guard.h;
  const bool completed = s.h_old == 0;
  if (completed) s.h_old = h;
  std::vector<math::Wrench> loads;
  const HalfKick half = leapfrog_synchronous(system, motion, s, motion_field(motion), loads);
  const double kick = kick_energy(system, motion, s) * h * h / (s.h_old * s.h_old);
  if (completed) {
    s.h_old = 0;
    motion.now_x = s.vx, motion.now_y = s.vy, motion.now_z = s.vz;
  }
  sight.energy = potential_energy(system, *motion.kernel, s);
  sight.energy.kinetic = model::kinetic_energy(system, motion.now_x, motion.now_y, motion.now_z);
  if (!system.composition && is_pulled(s)) {
    if (system.step_given > 0) sight.step.second = -kick;
  } else if (!system.composition) {
    sight.step = motion_energy(system, motion, s, {motion.now_x, motion.now_y, motion.now_z}, h);
    sight.step.second -= kick / 3;
  }
  sight.balance =
      energy_sum(sight.energy) + sight.step.sum() - s.drive_work - (completed ? 0 : half.work_of_drives);
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

// What is missing when a refinement is decided on.
void missing_remember(State& s) {
  s.guard.missing_refined = guard_missing(s);
  s.guard.ripple_refined = std::abs(s.guard.ripple);
}

void worst_update(model::EnergyGuard& g, double missing, double size, double time) {
  if (missing * g.worst_size <= std::abs(g.worst) * size) return;
  g.worst = std::copysign(missing, g.unaccounted);
  g.worst_size = size;
  g.worst_time = time;
}

// Updates what is missing at a time that is `length` s after that of the state. What damping along links and
// air take is not known; they do not give it back.
void account(const System& system, const Sight& sight, State& s, double length) {
  model::EnergyGuard& g = s.guard;
  guard_damped(system, s, sight.energy.kinetic);
  g.largest = std::max(g.largest, energy_size(sight.energy, s));
  g.unaccounted = sight.balance + g.damped - g.balance;
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
  if (s.steps > g.checked) account(system, look(system, motion, s), s, 0);
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
  if (system.fit || system.integrator == scene::Integrator::kPaper) return false;
  if (!system.bodies.empty() || contact::self_enabled(system) || !system.links.empty()) return false;
  return !(model::system_has_air(system) && norm(s.wind) > 0);
}

void guard_step(const System& system, Motion& motion, State& s, double h) {
  model::EnergyGuard& g = s.guard;
  if (g.begun && system.damping > 0 && system.particle.size() <= kFewParticles)
    guard_damped(system, s, model::kinetic_energy(system, s));
  if (!g.begun && s.steps >= g.checked && guard_watches(system, s)) {
    g.h = h;
    const Sight sight = look(system, motion, s);
    g.begun = true;
    g.checked = g.opened = s.steps;
    g.power = 2 * system.damping * sight.energy.kinetic;
    g.since = 0;
    g.gravity += sight.energy.gravity;
    g.balance = sight.balance + g.damped - g.unaccounted;
    g.step_energy = sight.step.sum() + g.ripple;
    g.largest = std::max(g.largest, energy_size(sight.energy, s));
  } else if (g.begun && std::abs(h - g.h) > kSameStep * h) {
    const StepEnergy step = look(system, motion, s).step;
    const double square = h * h / (g.h * g.h), size = guard_size(system, s);
    // Where cloth has stiffened so much that its step was far too large, the series of H has no value.
    const double old = std::abs(step.sum()) <= kSeriesHolds * size ? step.sum() : g.step_energy;
    const double change = square * step.second + square * square * step.fourth - old;
    step_energy_add(g, change);
    g.h = h;
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
  const double change = motion_energy(system, motion, s, {s.vx, s.vy, s.vz}, g.h).sum() -
                        motion_energy(system, motion, s, before, g.h).sum();
  step_energy_add(g, change);
  g.period = 1;
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

bool guard_refine(State& s, bool again) {
  model::EnergyGuard& g = s.guard;
  if (g.refinement >= kMaxRefinement || 2 * s.steps_per_interval > kMaxStepsPerInterval) return false;
  g.refined = s.steps;
  g.ripple_largest = 0;
  missing_remember(s);
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
    account(system, look(system, motion, s), s, 0);
}

Guard guard_check(const System& system, Motion& motion, State& s, double length) {
  model::EnergyGuard& g = s.guard;
  g.begun = g.begun && guard_watches(system, s);
  if (!g.begun || s.steps - g.checked < g.period) return Guard::kKept;
  account(system, look(system, motion, s), s, length);
  g.checked = s.steps;
  g.period = std::min(2 * g.period, kGuardSteps);
  const double size = guard_size(system, s), missing = guard_missing(s), ripple = std::abs(g.ripple);
  g.failing = missing > kUntouched * size && missing - g.missing_refined > kGrowth * size;
  const bool ripples = ripple > kRipple * size && ripple - g.ripple_refined > kGrowth * size;
  if (guard_lost(system, s) && (system.step_given > 0 || g.refinement >= kMaxRefinement)) return Guard::kLost;
  if (g.failing || ripples) return Guard::kRepeat;
  const double before_ease = kStepsBeforeEase * std::pow(kMoreBeforeEase, g.refinements - 1);
  if (g.refinement > 1 && double(s.steps - g.refined) >= before_ease) {
    if (kRippleOfTwice * g.ripple_largest <= kRipple * size) g.refinement /= 2;
    g.refined = s.steps;
    g.ripple_largest = 0;
  }
  return Guard::kKept;
}

}  // namespace drape::dynamics
