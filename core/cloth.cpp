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
  drape_inputs inputs{}, input_rates{};
  drape::ParameterValues in_force;
  drape::Outputs outputs;
  struct Piece {
    int first = 0;
    std::vector<double> rest;  // [particles x 2]
    std::vector<int> corner;   // [cells x 4]
  };
  std::vector<Piece> pieces;
  std::string limit_link;
  bool stuck = false;  // the last advance met a step limit below the given step
};

struct drape_snapshot {
  drape::State state;
  drape::ParameterValues in_force, shown;  // shown: also what is set but not committed yet
};

namespace drape {
namespace {

constexpr double kIntervalsMost = 1e9;  // in one advance

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

// What keeps the cloth from stepping on from its present state: no step limit, a given step above it, or more
// than kSubsMost steps in an interval.
void step_check(const drape_cloth& c, std::vector<Problem>& problems) {
  const double omega2 = step_limit_omega2(c.system, *c.motion.kernel, c.state), q = c.system.communication,
               limit = step_limit_of(c.system, omega2), steps = leapfrog_steps(c.system, omega2),
               most = kSubsMost, given = c.system.step_given, longest = given > 0 ? given : c.system.step_max;
  const auto set_by = [&] { return ", set by the " + step_limit_link(c.system, c.scene, c.state); };
  if (!(limit > 0) || !std::isfinite(omega2)) {
    problems.push_back({"scene.step", "has no limit above 0 s: stiffness over mass is not finite" +
                                          (omega2 > 0 ? set_by() : std::string())});
  } else if (given > limit) {
    problems.push_back({"scene.step", "= " + number(given) + " s; allowed: above 0, at most the step limit " +
                                          number(limit) + " s" + set_by()});
  } else if (!(steps <= most) && longest * most < q) {
    problems.push_back({longest == given ? "scene.step" : "step.max",
                        "= " + number(longest) + " s takes " + number(steps) +
                            " steps in a communication interval of " + number(q) + " s; allowed: at most " +
                            number(most) + ", " + number(q / most) + " s or more each"});
  } else if (!(steps <= most)) {
    problems.push_back({"scene.communication",
                        "= " + number(q) + " s takes " + number(steps) + " steps; allowed: at most " +
                            number(most) + ", but the step limit is " + number(limit) + " s" + set_by()});
  }
}

// The fabric of the piece that sets the step limit.
int step_fabric(const drape_cloth& c) {
  int fabric = 0;
  double most = -1;
  for (const Lattice& l : c.system.lattices)
    for (int j = 0; j + 1 < l.rows; ++j)
      if (const double omega2 = c.motion.kernel->omega2(c.system, l, c.state, j, 0); !(omega2 <= most))
        most = omega2, fabric = l.fabric;
  return fabric;
}

void pieces_describe(drape_cloth& c) {
  int particle = 0;
  for (const Lattice& l : c.system.lattices) {
    const Grid grid = grid_make(c.scene, l.piece);
    drape_cloth::Piece piece;
    piece.first = particle;
    std::vector<int> number(std::size_t(grid.nodes()), -1);
    for (int n = 0; n < grid.nodes(); ++n) {
      if (grid.area[std::size_t(n)] == 0) continue;
      number[std::size_t(n)] = particle++;
      const Vec2 place = grid.place(n);
      piece.rest.insert(piece.rest.end(), place.begin(), place.end());
    }
    for (const GridCell& cell : grid.cells)
      for (int k : {0, 1, 3, 2}) piece.corner.push_back(number[std::size_t(cell.node[k])]);
    c.pieces.push_back(std::move(piece));
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

// Takes the parameters if the cloth can step on with them. Otherwise puts back what stands in the way, a
// diagram or all of a fabric, tells of it, and is true: to be tried again.
bool parameters_try(drape_cloth& c, const ParameterValues& before, std::vector<Problem>& problems) {
  const auto put_back = [&](const std::string& stem, const std::string& name, const std::string& why) {
    if (!parameters_restore(c.parameters, c.scene, before, stem)) return false;
    problems.push_back({name, why});
    return true;
  };
  std::vector<Problem> found;
  parameters_take(c, found);
  if (!found.empty()) return put_back(found[0].place, found[0].place, found[0].message);
  step_check(c, found);
  if (found.empty()) return false;
  if (found[0].place == "step.max") return put_back("step.max", "step.max", found[0].message);
  const std::string fabric = "fabric." + c.scene.fabrics[std::size_t(step_fabric(c))].name;
  const std::string why = "keeps its values: with those set, " + problem_text(found[0]);
  // Where neither has been set, the motion itself has come to this: a matter of the next advance.
  return put_back(fabric + ".", fabric, why) || put_back("damping", "damping", why);
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
  return "no particle";
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
  if (how == Advance::kTooManySteps) {
    say(c, DRAPE_LOG_ERROR,
        when + " the step limit fell to " + number(limit) + " s, more than " + number(double(kSubsMost)) +
            " steps in a communication interval, set by the " +
            step_limit_link(c.system, c.scene, c.state, c.state.h_old) +
            "; loads or strains grew beyond what the fabric's laws can carry; the state is that of " +
            number(from, 9) + " s");
    return;
  }
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
    if (problems.empty()) {
      cloth_assemble(*c, problems);
      for (Problem& p : problems) p.place = scene_place(scene_file, p.place);
    }
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
  const drape_cloth::Piece& p = c->pieces[std::size_t(index)];
  return {c->scene.pieces[std::size_t(l.piece)].name.c_str(),
          l.cell,
          p.first,
          int(p.rest.size() / 2),
          p.rest.data(),
          int(p.corner.size() / 4),
          p.corner.data()};
}

drape_parameters* drape_parameters_of(drape_cloth* c) { return &c->parameters.shown; }

drape_status drape_commit(drape_cloth* c) {
  const ParameterValues before = c->in_force;
  if (parameters_read(c->parameters) == before) return DRAPE_OK;
  std::vector<Problem> problems;
  parameters_mend(c->parameters, c->scene, before, problems);
  double& step_max = c->parameters.shown.step_max;
  if (c->state.steps > 0 && step_max != c->system.step_max) {
    problems.push_back({"step.max", "= " + number(step_max) +
                                        " s; it is fixed once the cloth has moved, at " +
                                        number(c->system.step_max) + " s"});
    step_max = c->system.step_max;
  }
  if (!(parameters_read(c->parameters) == before)) {
    while (parameters_try(*c, before, problems)) continue;
    if (!(c->in_force == before)) leapfrog_retuned(c->system, c->motion, c->state);
  }
  say_problems(*c, problems);
  return problems.empty() ? DRAPE_OK : DRAPE_DISCARD;
}

drape_inputs* drape_inputs_of(drape_cloth* c) { return &c->inputs; }
drape_inputs* drape_input_rates_of(drape_cloth* c) { return &c->input_rates; }
int drape_at_rest(const drape_cloth*) { return 0; }

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
  if (length / c->system.communication > kIntervalsMost) {
    say(*c, DRAPE_LOG_ERROR,
        "the length of an advance is " + number(length) + " s; allowed: at most " +
            number(kIntervalsMost * c->system.communication) + " s, " + number(kIntervalsMost) +
            " communication intervals");
    return DRAPE_DISCARD;
  }
  c->stuck = false;
  if (drape_commit(c) != DRAPE_OK) return DRAPE_DISCARD;
  c->good = c->state;
  std::string event;
  const Advance how = leapfrog_advance(c->system, c->motion, c->state, length, event);
  if (!event.empty())
    say(*c, DRAPE_LOG_STABILITY, event + ", set by the " + step_limit_link(c->system, c->scene, c->state));
  if (how == Advance::kDone) return DRAPE_OK;
  say_trouble(*c, how, length);
  c->state = c->good;
  c->stuck = how == Advance::kStepAboveLimit;
  return c->stuck ? DRAPE_DISCARD : DRAPE_ERROR;
}

int drape_stuck(const drape_cloth* c) { return c->stuck; }

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
  c->stuck = false;
  c->state = from->state;
  parameters_write(c->parameters, from->in_force);
  std::vector<Problem> problems;  // none: these values were in force once
  if (!(from->in_force == c->in_force)) parameters_take(*c, problems);
  parameters_write(c->parameters, from->shown);
}

void drape_snapshot_free(drape_snapshot* s) { delete s; }

const char* drape_version(void) { return DRAPE_VERSION; }
