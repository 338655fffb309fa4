// The C interface: opening and advancing a cloth, and its outputs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <new>
#include <utility>

#include "api/cloth.h"
#include "assembly/assemble.h"
#include "dynamics/energy_guard.h"
#include "dynamics/potential_energy.h"
#include "dynamics/seam_welding.h"
#include "dynamics/step_size/automatic_step.h"
#include "dynamics/step_size/step_limit.h"
#include "math/plain_environment.h"
#include "scene/files.h"
#include "validation/load.h"

namespace drape::api {
namespace {

constexpr double kMaxIntervals = 1e9, kMinIntervals = 1e-9;  // in one advance
constexpr double kMaxStart = 1e9;                            // s

// Warns of sides of very different length, which are probably a mistake.
void seams_warn(const drape_cloth& c) {
  constexpr double kUsual = 1.5;
  for (std::size_t k = 0; k < c.scene.seams.size(); ++k) {
    const double a = c.system.seams.seam[k].length[0], b = c.system.seams.seam[k].length[1];
    const double ratio = std::max(a, b) / std::min(a, b);
    if (ratio > kUsual)
      log_message(c, DRAPE_LOG_WARNING,
                  "seam." + c.scene.seams[k].name + " sews " + number(a) + " m to " + number(b) +
                      " m: the longer side is " + number(ratio, 4) +
                      " times the shorter, which it is gathered to; usual: up to " + number(kUsual));
  }
}

void cloth_assemble(drape_cloth& c, std::vector<Problem>& problems) {
  c.system = assembly::system_assemble(c.scene, c.state, problems);
  if (!problems.empty()) return;
  c.motion = dynamics::motion_make(c.system);
  dynamics::leapfrog_begin(c.system, c.motion, c.state);
  dynamics::energy_begin(c.system, c.state);
  contact::check_start(c.system, c.scene, c.motion.contact, c.state, problems);
  contact::self_check_start(c.system, c.scene, c.state, problems);
  step_check(c, problems);
  if (!problems.empty()) return;
  c.good = c.state;
  parameters_make(c.parameters, c.scene, c.system.step_max);
  tuning_begin(c);
  inputs_make(c);
  outputs::outputs_make(c.outputs, c.scene, c.system);
  seams_warn(c);
  for (const model::Body& body : c.system.bodies)
    for (const std::string& remark : body.remarks) log_message(c, DRAPE_LOG_WARNING, remark);
}

// "piece 'sheet', column 5, row 4"
std::string node_place(const drape_cloth& c, std::size_t node) {
  const model::Lattice& l = model::system_lattice_of(c.system, node);
  const auto [column, row] = l.place_of(node);
  return "piece '" + c.scene.pieces[std::size_t(l.piece)].name + "', column " + std::to_string(column + 1) +
         ", row " + std::to_string(row + 1);
}

// The first particle whose values are not finite.
std::string failure_place(const drape_cloth& c) {
  const State& s = c.state;
  for (std::size_t n : c.system.particle)
    if (!std::isfinite(s.x[n] + s.y[n] + s.z[n] + s.vx[n] + s.vy[n] + s.vz[n])) return node_place(c, n);
  return "no particle";
}

void log_failure(const drape_cloth& c, dynamics::Advance how, double length) {
  const double from = model::state_time(c.good, c.system.communication);
  const std::string when = "between " + number(from, 9) + " and " + number(from + length, 9) + " s";
  if (how == dynamics::Advance::kNotFinite) {
    log_message(
        c, DRAPE_LOG_ERROR,
        when + " the run left the finite numbers, first seen at " + failure_place(c) + " after step " +
            std::to_string(c.state.steps) + " of size " + number(c.state.h_old) +
            " s; loads or strains grew beyond what the fabric's laws can carry; the state is that of " +
            number(from, 9) + " s");
    return;
  }
  if (how == dynamics::Advance::kEnergyLost) {
    const model::EnergyGuard& g = c.state.guard;
    log_message(
        c, DRAPE_LOG_ERROR,
        when + " the cloth has " + (g.unaccounted > 0 ? "gained " : "lost ") +
            number(dynamics::guard_missing(c.state), 3) + " J that no force accounts for, " +
            number(100 * dynamics::guard_missing(c.state) / dynamics::guard_size(c.system, c.state), 3) +
            " % of its largest energy, at a step of " + number(c.state.h_old, 3) + " s, set by the " +
            dynamics::step_limit_link(c.system, c.scene, c.state) +
            "; give the cloth smaller steps (scene.step, step.max) or slower motion; the state is that of " +
            number(from, 9) + " s");
    return;
  }
  const double limit = dynamics::step_limit_of(c.system, c.state.omega2);
  if (how == dynamics::Advance::kTooManySteps) {
    const bool contact = dynamics::step_set_by_contact(c.system, c.state);
    log_message(c, DRAPE_LOG_ERROR,
                when + " the largest step fell to " + number(contact ? c.state.max_contact_step : limit) +
                    " s, more than " + number(double(dynamics::kMaxStepsPerInterval)) +
                    " steps in a communication interval, set by the " + step_setter(c, c.state.h_old) +
                    "; loads or strains grew beyond what the fabric's laws can carry; the state is that of " +
                    number(from, 9) + " s");
    return;
  }
  log_message(c, DRAPE_LOG_ERROR,
              "scene.step = " + number(c.system.step_given) + " s is above the step limit, which fell to " +
                  number(limit) + " s " + when + ", set by the " +
                  dynamics::step_limit_link(c.system, c.scene, c.state) + "; the state is that of " +
                  number(from, 9) + " s");
}

}  // namespace

std::string step_setter(const drape_cloth& c, double ahead) {
  if (!dynamics::step_set_by_contact(c.system, c.state))
    return dynamics::step_limit_link(c.system, c.scene, c.state, ahead);
  const contact::MaxStep least = contact::max_step_setter(c.system, c.state);
  return "node of " + node_place(c, least.node) + ", which body '" + c.scene.bodies[least.body].name +
         "' approaches at up to " + number(least.speed, 3) + " m/s";
}

}  // namespace drape::api

using namespace drape;
using namespace drape::api;

drape_cloth* drape_open(const char* scene_file, drape_log_fn* log, void* user) {
  const math::PlainEnvironment plain;
  auto c = std::make_unique<drape_cloth>();
  c->log = log;
  c->log_user = user;
  std::vector<Problem> problems;
  try {
    c->scene = validation::scene_load(scene::path_of(scene_file), problems);
    if (problems.empty()) c->text = scene::scene_inline_files(scene::path_of(scene_file), problems);
    for (const scene::BodySpec& body : c->scene.bodies)
      c->files.push_back(scene::body_file(body.name, body.mesh));
    if (problems.empty()) {
      cloth_assemble(*c, problems);
      for (Problem& p : problems) p.place = scene::scene_location(scene_file, p.place);
    }
  } catch (const std::bad_alloc&) {
    problems.push_back(
        {std::string(scene_file) + ":", "does not fit into this machine's memory; use larger cells"});
  }
  if (problems.empty()) return c.release();
  log_problems(*c, problems);
  return nullptr;
}

void drape_close(drape_cloth* c) { delete c; }

const char* drape_scene_name(const drape_cloth* c) { return c->scene.name.c_str(); }
const char* drape_scene_text(const drape_cloth* c) { return c->text.c_str(); }
int drape_file_count(const drape_cloth* c) { return int(c->scene.bodies.size()); }
const char* drape_file_path(const drape_cloth* c, int index) {
  return c->scene.bodies[std::size_t(index)].mesh.c_str();
}
const char* drape_file_name(const drape_cloth* c, int index) { return c->files[std::size_t(index)].c_str(); }
drape_about drape_scene_about(const drape_cloth* c) {
  const scene::About& a = c->scene.about;
  return {a.description.c_str(), a.author.c_str(), a.version.c_str(), a.copyright.c_str(), a.license.c_str()};
}
double drape_duration(const drape_cloth* c) { return c->scene.duration; }
double drape_communication(const drape_cloth* c) { return c->system.communication; }

drape_parameters* drape_parameters_of(drape_cloth* c) { return &c->parameters.c_view; }

drape_inputs* drape_inputs_of(drape_cloth* c) { return &c->inputs; }
drape_inputs* drape_input_rates_of(drape_cloth* c) { return &c->input_rates; }
void drape_inputs_start(drape_cloth* c) {
  const math::PlainEnvironment plain;
  if (c->state.steps > 0 || std::equal(c->state.wind.begin(), c->state.wind.end(), c->inputs.wind)) return;
  std::copy(c->inputs.wind, c->inputs.wind + 3, c->state.wind.begin());
  dynamics::leapfrog_retuned(c->system, c->motion, c->state);
}
int drape_at_rest(const drape_cloth* c) { return c->state.relaxation.at_rest; }

drape_unaccounted drape_energy_unaccounted(drape_cloth* c) {
  const math::PlainEnvironment plain;
  const model::EnergyGuard kept = c->state.guard;
  dynamics::guard_look(c->system, c->motion, c->state);
  const model::EnergyGuard now = std::exchange(c->state.guard, kept);
  return {now.worst, now.worst_size, now.worst_time, dynamics::kGuardAllowed};
}

drape_status drape_start(drape_cloth* c, double time) {
  const math::PlainEnvironment plain;
  if (!(std::abs(time) <= kMaxStart) || c->state.steps > 0) {
    log_message(*c, DRAPE_LOG_ERROR,
                c->state.steps > 0 ? "the start time is set before the first step"
                                   : "the start time is " + number(time) + " s; allowed: from " +
                                         number(-kMaxStart) + " to " + number(kMaxStart) + " s");
    return DRAPE_DISCARD;
  }
  c->state.origin = time;
  return DRAPE_OK;
}

double drape_time(const drape_cloth* c) {
  const math::PlainEnvironment plain;
  return model::state_time(c->state, c->system.communication);
}

drape_status drape_advance(drape_cloth* c, double length) {
  const math::PlainEnvironment plain;
  if (!(std::isfinite(length) && length > 0)) {
    log_message(*c, DRAPE_LOG_ERROR,
                "the length of an advance is " + number(length) + " s; allowed: above 0 s, finite");
    return DRAPE_DISCARD;
  }
  const double clock = std::abs(drape_time(c));
  const double shortest =
      std::max(kMinIntervals * c->system.communication, std::nextafter(clock, INFINITY) - clock);
  if (length < shortest) {
    log_message(*c, DRAPE_LOG_ERROR,
                "the length of an advance is " + number(length) + " s; allowed: at least " +
                    number(shortest) + " s at this time, " + number(kMinIntervals) +
                    " communication intervals and the last bit of the clock");
    return DRAPE_DISCARD;
  }
  if (length / c->system.communication > kMaxIntervals) {
    log_message(*c, DRAPE_LOG_ERROR,
                "the length of an advance is " + number(length) + " s; allowed: at most " +
                    number(kMaxIntervals * c->system.communication) + " s, " + number(kMaxIntervals) +
                    " communication intervals");
    return DRAPE_DISCARD;
  }
  c->step_above_limit = false;
  const bool committed = drape_commit(c) == DRAPE_OK;  // sets c->surprised anew
  std::vector<Problem> problems;
  if (!inputs_apply(*c, length, problems)) log_problems(*c, problems);
  if (!committed || !problems.empty()) return DRAPE_DISCARD;
  c->good = c->state;
  c->tuning_good = c->tuning;
  std::string event;
  const dynamics::Advance how =
      dynamics::leapfrog_advance(c->system, c->motion, c->state, length, event, [c](double intervals) {
        if (c->on_interval) c->on_interval(c->on_interval_user);
        const bool tuned = tuning_advance(*c, intervals);
        return seam_events_advance(*c) || tuned;
      });
  if (!event.empty())
    log_message(*c, DRAPE_LOG_STABILITY,
                event + ", set by the " + dynamics::step_limit_link(c->system, c->scene, c->state));
  if (how == dynamics::Advance::kDone) {
    inputs_clear_rates(*c);
    return DRAPE_OK;
  }
  log_failure(*c, how, length);
  c->state = c->good;
  tuning_restore(*c, c->tuning_good);
  dynamics::seams_restore(c->system, c->motion, c->state);
  c->step_above_limit = how == dynamics::Advance::kStepAboveLimit;
  return c->step_above_limit ? DRAPE_DISCARD : DRAPE_ERROR;
}

int drape_surprised(const drape_cloth* c) { return c->surprised; }
int drape_step_above_limit(const drape_cloth* c) { return c->step_above_limit; }

const drape_outputs* drape_get_outputs(drape_cloth* c, int mask) {
  const math::PlainEnvironment plain;
  outputs::outputs_fill(c->outputs, c->system, c->motion, c->state, mask);
  return &c->outputs.c_view;
}

double drape_step_limit(drape_cloth* c, const char** set_by) {
  const math::PlainEnvironment plain;
  if (set_by) {
    c->limit_link = dynamics::step_limit_link(c->system, c->scene, c->state);
    *set_by = c->limit_link.c_str();
  }
  return dynamics::step_limit_of(c->system,
                                 dynamics::step_limit_omega2(c->system, *c->motion.kernel, c->state));
}

const char* drape_version(void) { return DRAPE_VERSION; }
