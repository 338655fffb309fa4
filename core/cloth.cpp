// The C interface: a cloth is a scene, the system made from it, its state, and the structs it shows.
#include <cmath>
#include <cstdio>
#include <new>

#include "drape.h"
#include "motion/step_limit.h"
#include "outputs/outputs.h"
#include "scene/read.h"
#include "system/assemble.h"
#include "system/parameters.h"

struct drape_cloth {
  drape_log_fn* log = nullptr;
  void* log_user = nullptr;
  drape::Scene scene;
  std::string text;
  drape::System system;
  drape::Motion motion;
  drape::State state, good;  // now, and when the running advance began
  drape::Parameters parameters;
  drape::ParameterValues in_force;
  drape::Outputs outputs;
  std::vector<std::vector<int>> node;     // [pieces][rows x columns]
  std::vector<std::vector<double>> rest;  // [pieces][rows x columns x 2]
  std::string limit_link;
};

struct drape_snapshot {
  drape::State state;
  drape::ParameterValues in_force, shown;  // shown: also what is set but not committed yet
};

namespace drape {
namespace {

void say(const drape_cloth& c, drape_log_kind kind, const std::string& message) {
  if (c.log) c.log(c.log_user, kind, message.c_str());
}

void say_problems(const drape_cloth& c, const std::vector<Problem>& problems) {
  for (const Problem& p : problems) say(c, DRAPE_LOG_ERROR, p.place + " " + p.message);
}

std::string number(double value, int digits = 6) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

// A given step must respect the limit from the start.
void step_check(const drape_cloth& c, std::vector<Problem>& problems) {
  const double limit = step_limit_of(c.system, c.state.omega2);
  if (c.system.step_given <= limit) return;
  problems.push_back({"scene.step", "= " + number(c.system.step_given) +
                                        " s; allowed: above 0, at most the step limit " + number(limit) +
                                        " s, set by the " + step_limit_link(c.system, c.scene, c.state)});
}

void pieces_describe(drape_cloth& c) {
  int particle = 0;
  for (const Lattice& l : c.system.lattices) {
    const Grid grid = grid_make(c.scene, l.piece);
    std::vector<int> node;
    std::vector<double> rest;
    for (int j = 0; j < l.rows; ++j)
      for (int i = 0; i < l.columns; ++i) {
        node.push_back(c.system.mass[l.node(i, j)] > 0 ? particle++ : -1);
        rest.push_back(grid.x0 + i * grid.cell);
        rest.push_back(grid.y0 + j * grid.cell);
      }
    c.node.push_back(std::move(node));
    c.rest.push_back(std::move(rest));
  }
}

void cloth_assemble(drape_cloth& c, std::vector<Problem>& problems) {
  c.system = system_assemble(c.scene, c.state, problems);
  if (!problems.empty()) return;
  c.motion = motion_make(c.system);
  leapfrog_begin(c.system, c.motion, c.state);
  step_check(c, problems);
  if (!problems.empty()) return;
  c.good = c.state;
  parameters_make(c.parameters, c.scene, c.system.step_max);
  c.in_force = parameters_read(c.parameters);
  outputs_make(c.outputs, c.scene, c.system);
  pieces_describe(c);
}

// Takes the numbers of c.parameters into the system. The masses and the limit may have changed: look again at
// once.
void parameters_take(drape_cloth& c, std::vector<Problem>& problems) {
  system_retune(c.system, parameters_fabrics(c.parameters, c.scene), problems);
  if (!problems.empty()) return;
  const drape_parameters& p = c.parameters.shown;
  c.system.damping = p.damping;
  c.system.gravity = {p.gravity[0], p.gravity[1], p.gravity[2]};
  c.system.step_max = p.step_max;
  c.in_force = parameters_read(c.parameters);
}

// Where a run left the finite numbers, and the likely reason.
std::string trouble_text(const drape_cloth& c) {
  const State& s = c.state;
  for (const Lattice& l : c.system.lattices)
    for (int j = 0; j < l.rows; ++j)
      for (int i = 0; i < l.columns; ++i) {
        const std::size_t n = l.node(i, j);
        if (c.system.mass[n] == 0) continue;
        if (std::isfinite(s.x[n] + s.y[n] + s.z[n]) && std::isfinite(s.vx[n] + s.vy[n] + s.vz[n])) continue;
        return "piece '" + c.scene.pieces[std::size_t(l.piece)].name + "', column " + std::to_string(i + 1) +
               ", row " + std::to_string(j + 1);
      }
  return "the step limit, which fell below every reasonable step";
}

void say_trouble(const drape_cloth& c, Advance how, double length) {
  const double from = state_time(c.good, c.system.communication);
  const std::string when = "between " + number(from, 9) + " and " + number(from + length, 9) + " s";
  if (how == Advance::kNotFinite) {
    say(c, DRAPE_LOG_ERROR,
        when + " the run left the finite numbers, first seen at " + trouble_text(c) + " after step " +
            std::to_string(c.state.steps) + " of size " + number(c.state.h_old) +
            " s; loads or strains grew beyond what the fabric's laws can carry; the state is that of " +
            number(from, 9) + " s");
    return;
  }
  const double limit = step_limit_of(c.system, c.state.omega2);
  say(c, DRAPE_LOG_ERROR,
      "scene.step = " + number(c.system.step_given) + " s is above the step limit, which fell to " +
          number(limit) + " s " + when + ", set by the " + step_limit_link(c.system, c.scene, c.state) +
          "; the state is that of " + number(from, 9) + " s");
}

}  // namespace
}  // namespace drape

using namespace drape;

drape_cloth* drape_open(const char* scene_file, drape_log_fn* log, void* user) {
  auto* c = new drape_cloth;
  c->log = log;
  c->log_user = user;
  std::vector<Problem> problems;
  try {
    c->scene = scene_read(scene_file, problems);
    if (problems.empty()) c->text = scene_resolve(scene_file, problems);
    if (problems.empty()) cloth_assemble(*c, problems);
  } catch (const std::bad_alloc&) {
    problems.push_back(
        {std::string(scene_file) + ":", "does not fit into this machine's memory; use larger cells"});
  }
  if (problems.empty()) return c;
  say_problems(*c, problems);
  delete c;
  return nullptr;
}

void drape_close(drape_cloth* c) { delete c; }

const char* drape_scene_name(const drape_cloth* c) { return c->scene.name.c_str(); }
const char* drape_scene_text(const drape_cloth* c) { return c->text.c_str(); }
double drape_duration(const drape_cloth* c) { return c->scene.duration; }
double drape_communication(const drape_cloth* c) { return c->system.communication; }
int drape_piece_count(const drape_cloth* c) { return int(c->system.lattices.size()); }

drape_piece drape_piece_at(const drape_cloth* c, int index) {
  const Lattice& l = c->system.lattices[std::size_t(index)];
  const auto k = std::size_t(index);
  return {c->scene.pieces[std::size_t(l.piece)].name.c_str(),
          l.columns,
          l.rows,
          c->node[k].data(),
          c->rest[k].data(),
          l.cell};
}

drape_parameters* drape_parameters_of(drape_cloth* c) { return &c->parameters.shown; }

drape_status drape_commit(drape_cloth* c) {
  if (parameters_read(c->parameters) == c->in_force) return DRAPE_OK;
  std::vector<Problem> problems;
  parameters_check(c->parameters, c->scene, problems);
  if (c->state.steps > 0 && c->parameters.shown.step_max != c->system.step_max)
    problems.push_back(
        {"step.max", "is fixed once the cloth has moved; it stays " + number(c->system.step_max) + " s"});
  if (problems.empty()) parameters_take(*c, problems);
  if (problems.empty()) {
    leapfrog_retuned(c->system, c->motion, c->state);
    return DRAPE_OK;
  }
  say_problems(*c, problems);
  parameters_write(c->parameters, c->in_force);
  return DRAPE_DISCARD;
}

drape_status drape_start(drape_cloth* c, double time) {
  if (!std::isfinite(time) || c->state.steps > 0) {
    say(*c, DRAPE_LOG_ERROR,
        std::isfinite(time) ? "the start time is set before the first step"
                            : "the start time must be a finite number of seconds");
    return DRAPE_DISCARD;
  }
  c->state.origin = time;
  return DRAPE_OK;
}

double drape_time(const drape_cloth* c) { return state_time(c->state, c->system.communication); }

drape_status drape_advance(drape_cloth* c, double length) {
  if (!(std::isfinite(length) && length > 0)) {
    say(*c, DRAPE_LOG_ERROR,
        "the length of an advance is " + number(length) + " s; allowed: above 0 s, finite");
    return DRAPE_DISCARD;
  }
  if (drape_commit(c) != DRAPE_OK) return DRAPE_DISCARD;
  c->good = c->state;
  std::string event;
  const Advance how = leapfrog_advance(c->system, c->motion, c->state, length, event);
  if (!event.empty())
    say(*c, DRAPE_LOG_STABILITY, event + ", set by the " + step_limit_link(c->system, c->scene, c->state));
  if (how == Advance::kDone) return DRAPE_OK;
  say_trouble(*c, how, length);
  c->state = c->good;
  return how == Advance::kNotFinite ? DRAPE_ERROR : DRAPE_DISCARD;
}

const drape_outputs* drape_outputs_at(drape_cloth* c, int want_nodes) {
  outputs_fill(c->outputs, c->system, c->motion, c->state, want_nodes != 0);
  return &c->outputs.shown;
}

double drape_step_limit(drape_cloth* c, const char** set_by) {
  if (set_by) {
    c->limit_link = step_limit_link(c->system, c->scene, c->state);
    *set_by = c->limit_link.c_str();
  }
  return step_limit_of(c->system, step_limit_omega2(c->system, *c->motion.kernel, c->state));
}

drape_snapshot* drape_save(drape_cloth* c, drape_snapshot* into) {
  if (!into) into = new drape_snapshot;
  into->state = c->state;
  into->in_force = c->in_force;
  into->shown = parameters_read(c->parameters);
  return into;
}

void drape_restore(drape_cloth* c, const drape_snapshot* from) {
  c->state = from->state;
  parameters_write(c->parameters, from->in_force);
  std::vector<Problem> problems;  // none: these values were in force once
  if (!(from->in_force == c->in_force)) parameters_take(*c, problems);
  parameters_write(c->parameters, from->shown);
}

void drape_snapshot_free(drape_snapshot* s) { delete s; }

const char* drape_version(void) { return DRAPE_VERSION; }
