// Tuning while the cloth moves: checks of tuned values, and how they reach the system. core/README.md,
// section 4, "Tuning".
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "api/cloth.h"
#include "assembly/assemble.h"
#include "dynamics/energy_guard.h"
#include "dynamics/potential_energy.h"
#include "dynamics/step_size/automatic_step.h"
#include "dynamics/step_size/step_limit.h"
#include "math/plain_environment.h"

namespace drape::api {

void log_message(const drape_cloth& c, drape_log_kind kind, const std::string& message) {
  if (c.log) c.log(c.log_user, kind, message.c_str());
}

void log_problems(const drape_cloth& c, const std::vector<Problem>& problems) {
  for (const Problem& p : problems) log_message(c, DRAPE_LOG_ERROR, p.place + " " + p.message);
}

std::string number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

namespace {

// omega^2 at present, 1/s^2. Where the scene gives a fixed step, with the closing forces of all seams that
// are still open.
double omega2_expected(const drape_cloth& c) {
  if (!(c.system.step_given > 0) || c.state.sewn.empty())
    return dynamics::step_limit_omega2(c.system, *c.motion.kernel, c.state);
  State closing = c.state;
  std::replace(closing.sewn.begin(), closing.sewn.end(), model::Sewn::kOpen, model::Sewn::kPulled);
  return dynamics::step_limit_omega2(c.system, *c.motion.kernel, closing);
}

}  // namespace

void step_check(const drape_cloth& c, std::vector<Problem>& problems) {
  const double omega2 = omega2_expected(c), q = c.system.communication,
               limit = dynamics::step_limit_of(c.system, omega2),
               steps = dynamics::leapfrog_steps(c.system, omega2), largest = dynamics::kMaxStepsPerInterval,
               given = c.system.step_given, longest = given > 0 ? given : c.system.step_max;
  const auto set_by = [&] { return ", set by the " + dynamics::step_limit_link(c.system, c.scene, c.state); };
  if (!(limit > 0) || !std::isfinite(omega2)) {
    problems.push_back({"scene.step", "has no limit above 0 s: stiffness over mass is not finite" +
                                          (omega2 > 0 ? set_by() : std::string())});
  } else if (given > limit) {
    problems.push_back({"scene.step", "= " + number(given) + " s; allowed: above 0, at most the step limit " +
                                          number(limit) + " s" + set_by()});
  } else if (!(steps <= largest) && longest * largest < q) {
    problems.push_back({longest == given ? "scene.step" : "step.max",
                        "= " + number(longest) + " s takes " + number(steps) +
                            " steps in a communication interval of " + number(q) + " s; allowed: at most " +
                            number(largest) + ", " + number(q / largest) + " s or more each"});
  } else if (!(steps <= largest)) {
    problems.push_back({"scene.communication",
                        "= " + number(q) + " s takes " + number(steps) + " steps; allowed: at most " +
                            number(largest) + ", but the step limit is " + number(limit) + " s" + set_by()});
  }
}

namespace {

// The fabric of the piece that sets the step limit.
int step_fabric(const drape_cloth& c) {
  int fabric = 0;
  double largest = -1;
  for (const model::Lattice& l : c.system.lattices)
    if (const double omega2 = dynamics::step_limit_lattice(c.system, *c.motion.kernel, l, c.state);
        !(omega2 <= largest))
      largest = omega2, fabric = l.fabric;
  return fabric;
}

void threads_apply(drape_cloth& c, int threads) {
  if (threads == c.system.threads) return;
  c.system.threads = threads;
  dynamics::Workspace& w = c.motion.workspace;
  w = dynamics::workspace_make(c.system, dynamics::threads_wanted(c.system));
  if (w.threads.size() > 1 && !w.workers)
    log_message(c, DRAPE_LOG_WARNING,
                "threads = " + std::to_string(threads) +
                    ": the system starts no more threads; the cloth moves on one");
}

// Applies the numbers of c.parameters to the system. The masses and the step limit may change: the caller
// must check them again.
void parameters_apply(drape_cloth& c, std::vector<Problem>& problems) {
  assembly::system_retune(c.system, parameters_fabrics(c.parameters, c.scene), problems);
  if (!problems.empty()) return;
  const drape_parameters& p = c.parameters.c_view;
  c.system.damping = p.damping;
  c.system.gravity = {p.gravity[0], p.gravity[1], p.gravity[2]};
  c.system.air.normal = p.air_normal;
  c.system.air.tangential = p.air_tangential;
  c.system.step_max = p.step_max;
  constraint::constraints_refactor(c.motion.constraints, c.system.inverse_mass);
  for (int k = 0; k < p.seam_count; ++k) c.system.seams.seam[std::size_t(k)].close = p.seam[k].close != 0;
  threads_apply(c, int(p.threads));
  c.tuning.in_force = parameters_read(c.parameters);
}

// Applies other values; c.parameters keeps its own.
void values_apply(drape_cloth& c, const ParameterValues& values, std::vector<Problem>& problems) {
  if (values == c.tuning.in_force) return;
  const ParameterValues written = parameters_read(c.parameters);
  parameters_write(c.parameters, values);
  parameters_apply(c, problems);
  parameters_write(c.parameters, written);
}

// Applies the parameters, and returns false if the cloth can step on with them. Otherwise resets what
// prevents it, a diagram or all of a fabric, adds a problem, and returns true: try again.
bool parameters_try(drape_cloth& c, const ParameterValues& before, std::vector<Problem>& problems) {
  const auto reset = [&](const std::string& stem, const std::string& name, const std::string& why) {
    if (!parameters_restore(c.parameters, c.scene, before, stem)) return false;
    problems.push_back({name, why});
    return true;
  };
  std::vector<Problem> found;
  parameters_apply(c, found);
  if (!found.empty()) return reset(found[0].place, found[0].place, found[0].message);
  step_check(c, found);
  if (found.empty()) return false;
  if (found[0].place == "step.max") return reset("step.max", "step.max", found[0].message);
  const std::string fabric = "fabric." + c.scene.fabrics[std::size_t(step_fabric(c))].name;
  const std::string why = "keeps its values: with those set, " + scene::problem_text(found[0]);
  // Where none of these was set, the motion itself is the cause: the next advance reports it.
  return reset(fabric + ".", fabric, why) || reset("damping", "damping", why) || reset("air.", "air", why);
}

// Restarts the step and books the work after a change of the system at the present state.
void tuning_changed(drape_cloth& c, double error_before) {
  if (c.state.steps == 0) dynamics::energy_begin(c.system, c.state);
  dynamics::leapfrog_retuned(c.system, c.motion, c.state);
  c.state.input += balance_error(c) - error_before;
}

// Resets a value that is fixed once the cloth has moved, with a problem.
void fixed_validate(const drape_cloth& c, const char* name, const char* unit, double& value, double fixed,
                    std::vector<Problem>& problems) {
  if (c.state.steps == 0 || value == fixed) return;
  problems.push_back({name, "= " + number(value) + unit + "; it is fixed once the cloth has moved, at " +
                                number(fixed) + unit});
  value = fixed;
}

// The mode of a scene does not change.
void mode_validate(drape_cloth& c, std::vector<Problem>& problems) {
  const bool fit = c.scene.mode == scene::Mode::kFit;
  const double own = fit ? DRAPE_MODE_FIT : DRAPE_MODE_DYNAMIC;
  double& mode = c.parameters.c_view.mode;
  if (mode == own) return;
  problems.push_back({"mode", "= " + number(mode) + "; allowed: " + number(own) + " (" +
                                  scene::kModeNames[fit] + "), the mode of the scene"});
  mode = own;
}

// Warns where the values just applied take many times as many steps as those before, at `omega2_before`
// (1/s^2). They are legal, and slow.
void slow_values_warn(drape_cloth& c, const ParameterValues& before, double omega2_before) {
  constexpr double kSurprising = 10;
  if (c.system.fit || c.system.step_given > 0) return;
  const double steps = dynamics::leapfrog_steps(c.system, omega2_expected(c)),
               steps_before = dynamics::leapfrog_steps(c.system, omega2_before), q = c.system.communication;
  if (!(steps > kSurprising * std::max(steps_before, 1.0))) return;
  c.surprised = true;
  log_message(c, DRAPE_LOG_WARNING,
              "with " + parameters_changes_text(c.parameters, c.scene, before) +
                  " the time step falls from about " + number(q / steps_before, 3) + " to " +
                  number(q / steps, 3) + " s, and the run takes " + number(steps / steps_before, 2) +
                  " times as long; the step limit is set by the " +
                  dynamics::step_limit_link(c.system, c.scene, c.state));
}

// Applies the written values. `before`: the targets so far.
void parameters_commit(drape_cloth& c, const ParameterValues& before, std::vector<Problem>& problems) {
  parameters_validate(c.parameters, c.scene, before, problems);
  drape_parameters& p = c.parameters.c_view;
  fixed_validate(c, "step.max", " s", p.step_max, c.system.step_max, problems);
  fixed_validate(c, "threads", "", p.threads, c.system.threads, problems);
  if (parameters_read(c.parameters) == before) return;
  const ParameterValues in_force = c.tuning.in_force;
  const State untouched = c.state;
  const double omega2_before = omega2_expected(c);
  dynamics::change_begin(c.system, c.motion, c.state, dynamics::Change::kFrequent);
  const double error_before = balance_error(c);
  while (parameters_try(c, before, problems)) continue;
  slow_values_warn(c, before, omega2_before);
  // Before the first step there is no motion to disturb: the values apply at once.
  const double ramp = c.state.steps > 0 ? c.parameters.c_view.ramp : 0;
  ramp_set_target(c.tuning.ramp, in_force, parameters_read(c.parameters), ramp / c.system.communication,
                  parameters_groups(c.parameters));
  std::vector<Problem> none;
  values_apply(c, ramp_values(c.tuning.ramp), none);
  if (parameters_change_motion(c.parameters, in_force, c.tuning.in_force)) tuning_changed(c, error_before);
  else c.state = untouched;
}

}  // namespace

double balance_error(drape_cloth& c) {
  if (!c.system.energy || c.state.steps == 0) return 0;
  outputs::outputs_fill(c.outputs, c.system, c.motion, c.state, DRAPE_OUT_ENERGY);
  return c.outputs.c_view.energy.balance_error;
}

void tuning_begin(drape_cloth& c) {
  c.tuning.in_force = parameters_read(c.parameters);
  c.tuning.ramp = ramp_at(c.tuning.in_force);
}

bool tuning_advance(drape_cloth& c, double intervals) {
  Ramp& ramp = c.tuning.ramp;
  if (!ramp_under_way(ramp)) return false;
  ramp_advance(ramp, intervals);
  const ParameterValues values = ramp_values(ramp);
  const bool moves = parameters_change_motion(c.parameters, c.tuning.in_force, values);
  if (moves) dynamics::change_begin(c.system, c.motion, c.state, dynamics::Change::kFrequent);
  const double error_before = moves ? balance_error(c) : 0;
  std::vector<Problem> problems;
  values_apply(c, values, problems);
  // Both ends of the ramp have valid laws, but values in between may not: they wait for the next interval.
  for (const Problem& p : problems)
    log_message(c, DRAPE_LOG_WARNING, "on its way, " + scene::problem_text(p));
  if (moves && problems.empty()) tuning_changed(c, error_before);
  if (!ramp_under_way(ramp))
    log_message(c, DRAPE_LOG_EVENT,
                "at " + number(model::state_time(c.state, c.system.communication), 9) +
                    " s the tuned values are reached");
  return moves;
}

void tuning_restore(drape_cloth& c, const Tuning& tuning) {
  std::vector<Problem> problems;  // stays empty: these values were in force before
  values_apply(c, tuning.in_force, problems);
  c.tuning = tuning;
}

}  // namespace drape::api

using namespace drape;
using namespace drape::api;

drape_status drape_commit(drape_cloth* c) {
  const math::PlainEnvironment plain;
  std::vector<Problem> problems;
  c->surprised = false;
  const ParameterValues before = c->tuning.ramp.to;
  if (!(parameters_read(c->parameters) == before)) parameters_commit(*c, before, problems);
  mode_validate(*c, problems);
  inputs_validate(*c);
  log_problems(*c, problems);
  return problems.empty() ? DRAPE_OK : DRAPE_DISCARD;
}
