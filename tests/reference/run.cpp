// Output times are k every and the end. A row's pin force is the mean over the interval since the row before,
// (J(t_k) - J(t_{k-1})) / (t_k - t_{k-1}); the first row has the value at the start.
#include "reference/run.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "reference/outputs.h"

namespace drape::reference {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kRtolLeast = 1e-12, kRtolMost = 1e-3;
constexpr double kSameTime = 1e-9;  // of the output interval

bool options_good(const Options& o, double until, double every, const Sink& sink) {
  bool good = true;
  const auto demand = [&](bool met, const char* name, double value, const char* allowed) {
    if (met) return;
    std::ostringstream text;
    text << name << " is " << value << "; allowed: " << allowed;
    sink.error(text.str());
    good = false;
  };
  demand(o.rtol >= kRtolLeast && o.rtol <= kRtolMost, "rtol", o.rtol, "1e-12 to 1e-3");
  demand(o.order >= 2 && o.order <= 8, "order", o.order, "2 to 8");
  demand(until > 0 && std::isfinite(until), "until", until, "above 0 s, finite");
  demand(every > 0 && std::isfinite(every), "every", every, "above 0 s, finite");
  return good;
}

void run(const Scene& scene, const Options& options, double until, double every, const Sink& sink) {
  const Motion motion = motion_make(scene);
  const OutputChoice choice{scene.energy, options.nodes};
  const Index pin_values = 3 * Index(motion.lattice.pins.size());
  sink.columns(output_columns(scene, motion.lattice, choice));

  VectorXd y = motion_start(motion);
  SolverHandle solver = solver_open(motion, y, {options.rtol, options.order, 0});
  sink.row(output_row(motion, choice, 0, y, motion_rate(motion, y).tail(pin_values), 0, 0));
  double time = 0;
  for (long k = 1; time < until; ++k) {
    const double asked = double(k) * every, next = asked < until - kSameTime * every ? asked : until;
    const VectorXd given = y.tail(pin_values);
    y = solver_advance(*solver, next);
    const VectorXd pin_force = (y.tail(pin_values) - given) / (next - time);
    time = next;
    sink.row(output_row(motion, choice, time, y, pin_force, solver_last_step(*solver),
                        solver_step_count(*solver)));
  }
}

}  // namespace

int reference_run(const Scene& scene, const Options& options, const Sink& sink) {
  const double until = options.until == 0 ? scene.duration : options.until;
  const double every = options.every == 0 ? scene.duration / 100 : options.every;
  if (!options_good(options, until, every, sink)) return 1;
  try {
    run(scene, options, until, every, sink);
  } catch (const std::exception& problem) {
    sink.error(problem.what());
    return 2;
  }
  return 0;
}

}  // namespace drape::reference
