// A scene run by the judge, row by row. The scene's step and integrator play no part here, its communication
// only where there are inputs over time. A scene in fit mode moves as if it were not: slower to rest, to the
// same equilibrium.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "reference/course.h"
#include "scene/scene.h"

namespace drape::reference {

struct Options {
  double rtol = 1e-10;  // 1e-12 to 1e-3
  int order = 8;        // 2 to 8
  double until = 0;     // s; 0 = scene.duration
  double every = 0;     // s; 0 = scene.duration / 100
  bool nodes = false;   // node.position and node.velocity too
  InputTable inputs{};
};

struct Sink {
  std::function<void(const std::vector<std::string>&)> columns;  // once
  std::function<void(const std::vector<double>&)> row;  // one per output time; the last is the end state
  std::function<void(const std::string&)> error;        // one sentence per problem
};

// Positions and velocities [3 N each] at a time, the particles in the order of the FMU's nodes; with inputs
// the path of the advances is that of `drape run`. Throws std::runtime_error where the run fails.
struct ReferenceState {
  Eigen::VectorXd r, v;
};
ReferenceState reference_state_at(const Scene& scene, const InputTable& inputs, double time, double rtol);

// 0 done, 1 bad options, 2 failed run.
int reference_run(const Scene& scene, const Options& options, const Sink& sink);

}  // namespace drape::reference
