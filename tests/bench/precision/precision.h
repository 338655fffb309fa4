// The work-precision diagram: error at the end against wall time, for Drape's steps and for ARKODE and CVODE.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

namespace drape::bench {

// One run. Error: largest difference of a coordinate from ARKODE at 1e-12 on the judge's forces, over the
// largest way that a coordinate has gone.
struct PrecisionRow {
  std::string scene, method, forces;  // forces: "kernel", "judge"
  int order;                          // 0: variable
  double setting;                     // relative tolerance; step (s) of fixed steps
  double error, seconds;
  long evaluations;
};

// Prints a table per scene as it goes; `quick`: seconds in all, no figures to rely on.
std::vector<PrecisionRow> precision(bool quick);

void precision_write(std::FILE* out, const std::vector<PrecisionRow>& rows);

}  // namespace drape::bench
