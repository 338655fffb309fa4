// ARKODE and CVODE on the equations of a trial.
#pragma once
#include <vector>

#include "bench/precision/trial.h"

namespace drape::bench {

enum class Family { kErk, kDirk, kImex, kAdams, kAdamsKrylov, kBdf };

struct Method {
  const char* name;
  Family family;
  int order;  // 0: the solver's choice
  bool krylov() const { return family != Family::kErk && family != Family::kAdams; }
};
const std::vector<Method>& methods();

struct Solved {
  bool done = false;  // false: more evaluations than allowed, or the solver gave up
  std::vector<double> y;
  long evaluations = 0;  // of forces, those of Krylov products included
  double seconds = 0;
};
Solved solve(const Equations& equations, const Method& method, double end, double rtol, long max_evaluations);

}  // namespace drape::bench
