// Runs a scene with the reference solver and returns the result row by row. The scene's step and integrator
// have no effect here, and its communication only where there are inputs over time. A scene in fit mode runs
// as a dynamic one: it reaches the same equilibrium, more slowly.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "reference/course.h"
#include "scene/scene.h"

namespace drape::reference {

struct Options {
  double rtol = 1e-10;  // relative tolerance, 1e-12 to 1e-3
  int order = 8;        // of the method, 2 to 8
  double until = 0;     // s, end time; 0 = scene.duration
  double every = 0;     // s, output interval; 0 = scene.duration / 100
  bool nodes = false;   // true: also node.position and node.velocity
  InputTable inputs{};
};

struct Sink {
  std::function<void(const std::vector<std::string>&)> columns;  // called once, with the names
  std::function<void(const std::vector<double>&)>
      row;                                        // called at each output time; the last row is the end state
  std::function<void(const std::string&)> error;  // called with one sentence for each problem
};

// Positions, m, and velocities, m/s, [3 N] each, at a time. Particles are in the order of the FMU's nodes.
// With inputs, the advances are those of `drape run`. Throws std::runtime_error where the run fails.
struct ReferenceState {
  Eigen::VectorXd r, v;
};
ReferenceState reference_state_at(const Scene& scene, const InputTable& inputs, double time, double rtol);

// Runs the scene. Returns 0: done, 1: invalid options, 2: the run failed.
int reference_run(const Scene& scene, const Options& options, const Sink& sink);

}  // namespace drape::reference
