// Drape's own steps, the paper's, and explicit Euler: fixed steps that end exactly at the end.
#pragma once
#include "bench/precision/trial.h"

namespace drape::bench {

enum class Own { kLeapfrog2, kOrder4, kOrder6, kPaper, kEuler };

// True where the scene allows the method.
bool own_fits(const Scene& scene, Own own);

// The number of steps (a real number) from the start to the end, at the step limit of the start.
double own_min_steps(const Scene& scene, Own own, double end);

struct Stepped {
  Eigen::VectorXd r;  // [3 particles]; empty if the run reached numbers that are not finite
  long evaluations;
  double seconds;
};
Stepped own_run(const Scene& scene, Own own, double end, long steps);

}  // namespace drape::bench
