#include "dynamics/advance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "dynamics/energy_guard.h"
#include "dynamics/relaxation.h"
#include "dynamics/step_size/automatic_step.h"
#include "math/plain_environment.h"
#include "math/vector3.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {
namespace {

using namespace math::vector3;

// The step may grow where neither so many intervals nor so many steps needed it as it is; by a tenth or more.
constexpr std::int64_t kIntervalsBeforeGrowth = 50, kStepsBeforeGrowth = 20000;
constexpr double kLeastGrowth = 0.1;
constexpr double kMargin = 0.9;  // of the allowed step, for the intervals after one in which it fell

// Allocates v_{n-3/2} where forces depend on velocity. While it is unknown, v_{n-1/2} stands for it.
void rates_begin(const System& system, State& s) {
  const bool rates = model::system_has_rates(system);
  if (rates != s.wx.empty()) return;
  const Array none;
  s.wx = rates ? s.vx : none;
  s.wy = rates ? s.vy : none;
  s.wz = rates ? s.vz : none;
}

bool all_finite(const System& system, const State& s) {
  double sum = 0;
  for (std::size_t n : system.particle)
    sum += 0 * (s.x[n] + s.y[n] + s.z[n]) + 0 * (s.vx[n] + s.vy[n] + s.vz[n]);
  return sum == 0;
}

void describe_step(std::string& event, const char* verb, double time, double h, const State& s) {
  char text[160];
  std::snprintf(text, sizeof text, "at %.9g s the step %s to %.4g s (omega = %.4g 1/s)", time, verb, h,
                std::sqrt(s.omega2));
  event = text;
}

// Fewer steps for the next interval of q, where the last ones would have allowed it.
void steps_relax(const System& system, State& s, std::string& event) {
  const std::int64_t since = s.intervals_since_change;
  const bool long_enough =
      since >= kIntervalsBeforeGrowth || double(since) * double(s.steps_per_interval) >= kStepsBeforeGrowth;
  if (since == 0 || !long_enough || system.fit) return;
  const double q = system.communication;
  const std::int64_t expected = steps_for(q, step_needed(system, s));
  s.intervals_since_change = 0;
  largest_begin(s);
  if (double(expected) > (1 - kLeastGrowth) * double(s.steps_per_interval)) return;
  s.steps_per_interval = expected;
  s.steps_to_limit_check = 0;
  describe_step(event, "grows", model::state_time(s, q), q / double(expected), s);
}

// Steps that fill `length` (s), of which some are done.
struct Interval {
  double length;
  std::int64_t steps, done = 0;
  double h() const { return length / double(steps); }
};

// Checks the step limit within an interval. Where it has fallen, the number of steps doubles; in a fit the
// inertia grows.
Advance limit_check(const System& system, Motion& motion, State& s, Interval& interval, std::string& event) {
  if (!all_finite(system, s)) return Advance::kNotFinite;
  if (system.fit) {
    relaxation_update(system, motion, s, interval.h());
    return Advance::kDone;
  }
  check_step_limit(system, motion, s, interval.h());
  if (system.step_given > 0)
    return interval.h() > step_limit_of(system, s.omega2) ? Advance::kStepAboveLimit : Advance::kDone;
  while (interval.h() > step_now(system, s)) {
    if (interval.h() * double(kMaxStepsPerInterval) < system.communication) return Advance::kTooManySteps;
    interval.steps *= 2;
    interval.done *= 2;
    s.guard.period = 1;
    s.steps_per_interval = std::min(
        2 * s.steps_per_interval,
        std::max(s.steps_per_interval + 1, steps_for(system.communication, kMargin * step_now(system, s))));
    s.intervals_since_change = 0;
    largest_begin(s);
    const double h = interval.h();
    describe_step(event, "falls", model::state_time(s, system.communication) + double(interval.done) * h, h,
                  s);
  }
  return Advance::kDone;
}

// Takes the steps of an interval; more when the limit falls meanwhile. None where a fit is at rest.
Advance interval_run(const System& system, Motion& motion, State& s, Interval interval, std::string& event) {
  for (; interval.done < interval.steps && !s.relaxation.at_rest; ++interval.done) {
    if (s.steps_to_limit_check-- <= 0) {
      if (const Advance how = limit_check(system, motion, s, interval, event); how != Advance::kDone)
        return how;
      --s.steps_to_limit_check;
    }
    const double steps = double(interval.steps);
    guard_step(system, motion, s, interval.h());
    leapfrog_step(system, motion, s, interval.length / steps, double(interval.done + 1) / steps, 1 / steps);
  }
  if (system.fit && !s.relaxation.at_rest && !path_moves(motion.path)) check_convergence(system, motion, s);
  return Advance::kDone;
}

// An interval watched by the energy guard. One that fails, and is long enough for a check of its own, is
// repeated from its start with twice the steps. After a shorter one, the next have twice the steps.
Advance interval_watched(const System& system, Motion& motion, State& s, double length, std::string& event) {
  const double q = system.communication;
  const auto steps = [&] {
    return length == q ? s.steps_per_interval : steps_for(length, q / double(s.steps_per_interval));
  };
  const bool repeats = guard_watches(system, s) && system.step_given == 0 && steps() >= s.guard.period;
  if (repeats) motion.before = s;
  const double refinement = s.guard.refinement, known = guard_excess(s);  // before the interval
  const std::string told = event;
  bool again = false;
  for (double failed = INFINITY;; again = true) {
    const Advance how = interval_run(system, motion, s, {length, steps()}, event);
    const bool fell = how == Advance::kNotFinite && repeats;
    if (how != Advance::kDone && !fell) return how;
    const Guard guard = fell ? Guard::kRepeat : guard_check(system, motion, s, length);
    if (guard == Guard::kLost) return Advance::kEnergyLost;
    if (guard == Guard::kKept || system.step_given > 0) return Advance::kDone;
    const double missing = fell ? INFINITY : guard_excess(s) - known;
    if (missing > kGuardHelps * failed) {
      event = told;
      guard_accept(s, refinement);
      return guard_lost(system, s) ? Advance::kEnergyLost : Advance::kDone;
    }
    if (!guard_refine(repeats ? motion.before : s, guard_size(system, s), again)) {
      if (fell) return how;
      guard_accept(s, s.guard.refinement);
      return Advance::kDone;
    }
    failed = missing;
    if (repeats) {
      if (fell) workspace_clear(motion.workspace);
      s = motion.before;
      held_follow(motion.constraints, s, motion.held);
    }
    describe_step(event, "is refined, since energy is missing,",
                  model::state_time(s, q) + (repeats ? 0 : length), q / double(s.steps_per_interval), s);
    if (!repeats) return Advance::kDone;
  }
}

// The motion of the first step, at the velocities that the forces give within it: cloth under load starts
// from rest, and jolts.
void motion_begin(const System& system, Motion& motion, State& s) {
  constexpr int kTrials = 12;
  free_accelerations(system, motion, s);
  const Array x = s.vx, y = s.vy, z = s.vz;
  for (int trial = 0; trial < kTrials; ++trial) {
    const double h = step_now(system, s);
    for (std::size_t n : system.particle) {
      s.vx[n] = x[n] + h * motion.now_x[n];
      s.vy[n] = y[n] + h * motion.now_y[n];
      s.vz[n] = z[n] + h * motion.now_z[n];
    }
    motion_update(system, motion, -h, 1, s);
    if (h <= step_now(system, s)) break;
  }
  s.vx = x, s.vy = y, s.vz = z;
}

void steps_begin(const System& system, Motion& motion, State& s) {
  if (system.step_given == 0) s.max_contact_step = contact::max_step(system, s);
  s.omega2 = step_limit_omega2(system, *motion.kernel, s);
  s.mean_defect = s.mean_kinetic = s.flutter = 0;
  if (system.step_given == 0 && !system.fit) motion_begin(system, motion, s);
  largest_begin(s);
  s.flutter = std::max(s.flutter, flutter_unknown(system, s.omega2));
  s.steps_per_interval = steps_for(system.communication, step_now(system, s));
  s.steps_to_limit_check = 0;
}

// Links on sharp edges share nodes with each other and with particles in contact. So the impulse that was
// reported for the half step before this advance is computed as it was then, and taken out of its first step.
void edge_half_kick_report(const System& system, Motion& motion, State& s) {
  motion.contact.half_kick_reported = contact::edge_any(s) && last_half(system, s) > 0 && !system.fit;
  if (!motion.contact.half_kick_reported) return;
  std::vector<math::Wrench> pins;
  leapfrog_synchronous(system, motion, s, motion_field(motion), pins);
  for (std::size_t b = 0; b < s.body.size(); ++b)
    s.body[b].impulse = {-1.0 * motion.contact.load[b].force, -1.0 * motion.contact.load[b].torque};
}

// Begins the paths of an advance. Where the velocity of a pin jumps, so does that of the cloth; the impulse
// is the first of the advance. (In the paper's scheme it is part of the first step.)
void inputs_begin(const System& system, Motion& motion, State& s, double length) {
  s.pin_impulse.assign(s.pin_impulse.size(), math::Wrench{});
  for (model::BodyContact& body : s.body) body.impulse = math::Wrench{};
  motion.path = path_make(system, s, motion.inputs, length);
  for (std::size_t b = 0; b < s.body.size(); ++b)
    s.body[b].velocity_given =
        system.bodies[b].moves &&
        body_drive(system.bodies[b], s.body[b], motion.inputs.body[b]) == scene::Drive::kBoth;
  if (system.fit && path_moves(motion.path)) relaxation_resume(s);
  if (!motion.path.pins.empty()) guard_advance(system, motion.path, s);
  const bool jumps = pins_jump(motion.path) && system.integrator == scene::Integrator::kLeapfrog;
  if (jumps) leapfrog_complete(system, motion, s);
  edge_half_kick_report(system, motion, s);
  const auto set = [&] {
    path_follow(motion.path, 0, s);
    bodies_follow(motion.path, 0, s);
    held_follow(motion.constraints, s, motion.held);
  };
  if (pins_jump(motion.path)) guard_set_inputs(system, motion, s, set);
  else set();
  const double before = jumps ? model::kinetic_energy(system, s) : 0;
  if (jumps) {
    const std::array<Array, 3> velocity = {s.vx, s.vy, s.vz};
    constraints_project(system, motion.constraints, motion.held, {s.vx.data(), s.vy.data(), s.vz.data()},
                        &s.pin_impulse);
    guard_jump(system, motion, s, velocity);
    if (!s.wx.empty()) s.wx = s.vx, s.wy = s.vy, s.wz = s.vz;
  }
  if (!s.body.empty() && (jumps || bodies_jump(motion.path)))  // neighbours took all to move as before
    contact::update_proximity(system, motion.kernel->contact, motion.contact, s, 0,
                              model::step_next(system, s));
  if (jumps) s.drive_work += model::kinetic_energy(system, s) - before;
  if (jumps || bodies_jump(motion.path)) s.steps_to_limit_check = 0;
}

// Lets the system change before an interval. Where it has, targets and rates of held points are updated.
void interval_open(Motion& motion, State& s, double intervals, const IntervalBegins& begins) {
  if (!begins || !begins(intervals)) return;
  held_follow(motion.constraints, s, motion.held);
}

}  // namespace

Motion motion_make(const System& system) {
  Motion m;
  m.kernel = &kernel_pick();
  m.workspace = workspace_make(system, threads_wanted(system));
  m.constraints = system.constraints;
  m.held = held_make(m.constraints);
  m.balance = balance_make(system);
  m.contact = contact::workspace_make(system);
  contact::mark_tied(system, m.constraints, m.contact);
  m.torque.resize(system.constraints.pins.size());
  for (Array* a : {&m.now_x, &m.now_y, &m.now_z}) a->assign(system.nodes, 0.0);
  return m;
}

void leapfrog_begin(const System& system, Motion& motion, State& s) {
  motion.inputs = inputs_at(s);
  motion.path.wind_from = motion.path.wind_to = s.wind;
  held_follow(motion.constraints, s, motion.held);
  constraints_project(system, motion.constraints, motion.held, {s.vx.data(), s.vy.data(), s.vz.data()},
                      nullptr);
  rates_begin(system, s);
  steps_begin(system, motion, s);
  if (s.body.empty() && !contact::self_enabled(system)) return;
  contact::begin(system, motion.kernel->contact, motion.contact, s);
  contact::self_begin(system, s);
  steps_begin(system, motion, s);  // with contact in the bound
}

void leapfrog_welded(const System& system, Motion& motion, State& s) {
  if (system.step_given == 0 && !system.fit) motion_begin(system, motion, s);
  leapfrog_retuned(system, motion, s);
}

void leapfrog_retuned(const System& system, Motion& motion, State& s) {
  rates_begin(system, s);
  s.steps_to_limit_check = 0;
  s.limit_check_period = 1;
  if (system.fit) relaxation_resume(s), relaxation_forget(s);
  if (s.steps == 0) steps_begin(system, motion, s);
}

Advance leapfrog_advance(const System& system, Motion& motion, State& s, double length, std::string& event,
                         const IntervalBegins& interval_begins) {
  const math::FlushToZero flush;
  const double q = system.communication;
  const double whole = std::round(length / q);
  // A master's own clock rounds: the length may be off by some units in the last place of the time.
  const double rounding =
      1e-12 * length + 8 * std::numeric_limits<double>::epsilon() * std::abs(model::state_time(s, q));
  const bool on_grid = whole >= 1 && std::abs(length - whole * q) <= rounding;
  s.advance_length = length;
  s.advance_begins = true;
  inputs_begin(system, motion, s, length);
  contact::self_invalidate_proximity(system, s, 0);
  motion.path.intervals = on_grid ? std::int64_t(whole) : 1;
  Advance result = Advance::kDone;
  if (on_grid) {
    for (std::int64_t k = 0; k < std::int64_t(whole) && result == Advance::kDone; ++k) {
      interval_open(motion, s, 1, interval_begins);
      steps_relax(system, s, event);
      path_interval(motion.path, s, k, q);
      result = interval_watched(system, motion, s, q, event);
      ++s.tick;
      ++s.intervals_since_change;
    }
  } else {
    interval_open(motion, s, length / q, interval_begins);
    steps_relax(system, s, event);
    result = interval_watched(system, motion, s, length, event);
    s.intervals_since_change += std::max<std::int64_t>(1, std::int64_t(length / q));
    s.origin = model::state_time(s, q) + length;
    s.tick = 0;
  }
  if (result == Advance::kDone && !all_finite(system, s)) result = Advance::kNotFinite;
  if (result != Advance::kDone) workspace_clear(motion.workspace);
  return result;
}

}  // namespace drape::dynamics
