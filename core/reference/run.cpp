// Output times are k every, and the end. Without inputs there is one advance from each output time to the
// next. With inputs, advances are as long as scene.communication (the last may be shorter), and each goes to
// the inputs at its end. A row's pin forces and torques are means over the advance before it, (J(t) - J(t -
// H))/H. The impulse that the pins take up at the start belongs to the first advance. The first row has the
// values at the start.
#include "reference/run.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "reference/outputs.h"

namespace drape::reference {
namespace {

using Eigen::VectorXd;

constexpr double kMaxTime = 1e7, kMaxRows = 1e7;  // s; rows
constexpr double kMinRtol = 1e-12, kMaxRtol = 1e-3;
constexpr double kSameTime = 1e-9;  // relative to the output interval

bool options_good(const Options& o, double until, double every, const Sink& sink) {
  bool good = true;
  const auto demand = [&](bool met, const char* name, double value, const char* allowed) {
    if (met) return;
    std::ostringstream text;
    text << name << " is " << value << "; allowed: " << allowed;
    sink.error(text.str());
    good = false;
  };
  demand(o.rtol >= kMinRtol && o.rtol <= kMaxRtol, "rtol", o.rtol, "1e-12 to 1e-3");
  demand(o.order >= 2 && o.order <= 8, "order", o.order, "2 to 8");
  demand(until > 0 && std::isfinite(until), "until", until, "above 0 s, finite");
  demand(every > 0 && std::isfinite(every), "every", every, "above 0 s, finite");
  demand(!(until > kMaxTime), "until", until, "at most 1e7 s");
  demand(!(until / every > kMaxRows), "every", every, "at least a ten-millionth of the time to the end");
  return good;
}

// The state of a run.
struct Run {
  const Scene& scene;
  const Options& options;
  Motion motion;
  SolverHandle solver;
  Sample sample;
};

Passed passed_of(const Motion& motion, const VectorXd& y) {
  const Layout at = layout_of(motion.lattice);
  return {y.segment(at.impulse, at.angular - at.impulse), y.segment(at.angular, at.input - at.angular)};
}

// Without inputs, one advance leads to the next row. With seams it is divided into communication intervals,
// as their events happen at the beginning of one.
VectorXd advance_to_row(Run& run, double time) {
  const double q = run.scene.communication, begin = run.sample.time;
  const double intervals = run.scene.seams.empty() ? 1 : std::max(1.0, std::ceil((time - begin) / q - 1e-9));
  for (double k = 1; k < intervals; ++k) solver_advance(*run.solver, begin + k * q);
  return solver_advance(*run.solver, time);
}

void advance(Run& run, double time) {
  Sample& s = run.sample;
  const double length = time - s.time;
  const Passed before = s.time > 0 ? passed_of(run.motion, s.y) : passed_of(run.motion, 0 * s.y);
  const InputTable& inputs = run.options.inputs;
  s.y = inputs.time.empty()
            ? advance_to_row(run, time)
            : solver_advance(*run.solver, time, inputs_at(inputs, run.scene, run.motion.lattice, time));
  const Passed after = passed_of(run.motion, s.y);
  s.pins = {(after.force - before.force) / length, (after.torque - before.torque) / length};
  s.time = time;
  s.outside = solver_outside(*run.solver);
  s.step_size = solver_last_step(*run.solver);
  s.step_count = solver_step_count(*run.solver);
}

void advance_in_intervals(Run& run, double time) {
  const double q = run.scene.communication, begin = run.sample.time;
  const double steps =
      run.options.inputs.time.empty() ? 1 : std::max(1.0, std::ceil((time - begin) / q - 1e-9));
  for (double k = 1; k <= steps; ++k) advance(run, k < steps ? begin + k * q : time);
}

Run run_open(const Scene& scene, const Options& options) {
  Run run{scene, options, motion_make(scene), {}, {}};
  Motion& motion = run.motion;
  if (!options.inputs.time.empty())
    motion.start.wind = inputs_at(options.inputs, scene, motion.lattice, 0).wind;
  const VectorXd y = motion_start(motion);
  const Course still = course_make(motion.lattice, motion.start, motion.start, 1);
  run.sample = {0,
                y,
                motion.start,
                passed_of(motion, motion_rate(motion, still, y)),
                motion_energy(motion, turns_of(motion.start), y).total(),
                0,
                0};
  return run;
}

void run_rows(const Scene& scene, const Options& options, double until, double every, const Sink& sink) {
  Run run = run_open(scene, options);
  run.solver = solver_open(run.motion, run.sample.y, {options.rtol, options.order, 0});
  sink.columns(output_columns(scene, run.motion.lattice, options.nodes));
  sink.row(output_row(scene, run.motion, options.nodes, run.sample));
  for (long k = 1; run.sample.time < until; ++k) {
    const double output_time = double(k) * every;
    advance_in_intervals(run, output_time < until - kSameTime * every ? output_time : until);
    sink.row(output_row(scene, run.motion, options.nodes, run.sample));
  }
}

}  // namespace

ReferenceState reference_state_at(const Scene& scene, const InputTable& inputs, double time, double rtol) {
  Options options;
  options.rtol = rtol;
  options.inputs = inputs;
  Run run = run_open(scene, options);
  run.solver = solver_open(run.motion, run.sample.y, {rtol, options.order, 0});
  advance_in_intervals(run, time);
  const Eigen::Index n = 3 * run.motion.lattice.count;
  return {run.sample.y.head(n), run.sample.y.segment(n, n)};
}

int reference_run(const Scene& scene, const Options& options, const Sink& sink) {
  const double until = options.until == 0 ? scene.duration : options.until;
  const double every = options.every == 0 ? scene.duration / 100 : options.every;
  if (!options_good(options, until, every, sink)) return 1;
  if (scene.outline == scene::OutlineModel::kPaper && !scene.seams.empty()) {
    sink.error(
        "options.outline = \"paper\" ties seams by rigid links, which the reference does not have; allowed: "
        "\"cutcell\", or a scene without seams");
    return 1;
  }
  try {
    run_rows(scene, options, until, every, sink);
  } catch (const std::exception& problem) {
    sink.error(problem.what());
    return 2;
  }
  return 0;
}

}  // namespace drape::reference
