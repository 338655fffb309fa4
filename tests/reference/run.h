// A scene run by the judge, row by row. The scene's step, communication and integrator play no part here.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::reference {

struct Options {
  double rtol = 1e-10;  // 1e-12 to 1e-3
  int order = 8;        // 2 to 8
  double until = 0;     // s; 0 = scene.duration
  double every = 0;     // s; 0 = scene.duration / 100
  bool nodes = false;   // node.position and node.velocity too
};

struct Sink {
  std::function<void(const std::vector<std::string>&)> columns;  // once
  std::function<void(const std::vector<double>&)> row;  // one per output time; the last is the end state
  std::function<void(const std::string&)> error;        // one sentence per problem
};

// 0 done, 1 bad options, 2 failed run.
int reference_run(const Scene& scene, const Options& options, const Sink& sink);

}  // namespace drape::reference
