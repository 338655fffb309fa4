#include "dynamics/step_size/automatic_step.h"

#include <algorithm>
#include <cmath>

#include "dynamics/energy_guard.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {
namespace {

constexpr int kLimitCheckLongest = 32;  // steps between two checks of the step limit, at most
constexpr double kMeanSteps = 256;      // over which the energy defect is averaged
constexpr int kLimitCheckGiven = 8;     // where the scene gives the step

MotionBound motion_bound(const State& s) {
  return {s.mean_defect > 0 ? s.mean_defect / s.mean_kinetic : 0, s.flutter};
}

// The largest step allowed at an omega^2 and a motion.
double step_allowed(const System& system, double omega2, const MotionBound& motion) {
  if (system.step_given > 0) return std::min(system.step_given, system.step_max);
  return std::min(step_automatic(system, omega2, motion), system.step_max);
}

// The same with what is near the cloth at present.
double step_near(const System& system, const State& s, double omega2, const MotionBound& motion) {
  const double refined = system.step_given > 0 ? 1 : s.guard.refinement;
  return std::min(step_allowed(system, omega2, motion) / refined, s.max_contact_step);
}

void largest_update(State& s) {
  s.max_omega2 = std::max(s.max_omega2, s.omega2);
  s.max_drift = std::max(s.max_drift, motion_bound(s).drift);
  s.max_flutter = std::max(s.max_flutter, s.flutter);
}

}  // namespace

std::int64_t steps_for(double length, double longest) {
  const double n = std::ceil(length / longest * (1 - 1e-12));
  constexpr double kMax = 1e16;  // more than 1e9 intervals of kMaxStepsPerInterval steps; also for NaN
  return n < 1 ? 1 : std::int64_t(n < kMax ? n : kMax);
}

double step_now(const System& system, const State& s) {
  return step_near(system, s, s.omega2, motion_bound(s));
}

double step_needed(const System& system, const State& s) {
  return step_near(system, s, s.max_omega2, {s.max_drift, s.max_flutter});
}

// Pins and bodies that move may jolt the cloth at any time.
void motion_update(const System& system, const Motion& motion, double h, double weight, State& s) {
  const StepDefect defect = step_defect(system, *motion.kernel, s, h);
  const double kinetic = model::kinetic_energy(system, s);
  s.flutter = defect.omega2 / std::abs(h);
  if (path_moves(motion.path)) s.flutter = std::max(s.flutter, flutter_unknown(system, s.omega2));
  s.mean_defect += weight * (defect.energy / std::pow(std::abs(h), 3) - s.mean_defect);
  s.mean_kinetic += weight * (kinetic - s.mean_kinetic);
  if (h > 0) guard_damped(system, s, kinetic);
}

void largest_begin(State& s) {
  s.max_omega2 = s.omega2;
  s.max_drift = motion_bound(s).drift;
  s.max_flutter = s.flutter;
}

// A check over many steps that finds the step too large is repeated over fewer: in vibrating cloth velocities
// reverse long before.
void check_step_limit(const System& system, const Motion& motion, State& s, double h) {
  if (system.step_given > 0) {
    if (system.damping > 0) guard_damped(system, s, model::kinetic_energy(system, s));
    s.omega2 = step_limit_omega2(system, *motion.kernel, s);
    s.steps_to_limit_check = kLimitCheckGiven;
    return;
  }
  s.max_contact_step = contact::max_step(system, s);
  motion_update(system, motion, h, std::min(1.0, s.limit_check_period / kMeanSteps), s);
  for (;; s.limit_check_period = std::max(s.limit_check_period / 4, 1)) {
    s.omega2 = step_limit_omega2(system, *motion.kernel, s, s.limit_check_period * h);
    if (h <= step_now(system, s) || s.limit_check_period == 1) break;
  }
  largest_update(s);
  s.steps_to_limit_check = s.limit_check_period;
  s.limit_check_period = std::min(2 * s.limit_check_period, kLimitCheckLongest);
}

bool step_set_by_contact(const System& system, const State& s) {
  return s.max_contact_step <= step_now(system, s);
}

double leapfrog_steps(const System& system, double omega2) {
  return system.communication / step_allowed(system, omega2, {});
}

}  // namespace drape::dynamics
