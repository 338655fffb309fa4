// The work-precision diagram: error at the end against wall time, for Drape's steps and for ARKODE and
// CVODE.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

namespace drape::bench {

// One run. Error: the largest difference of a coordinate from ARKODE at 1e-12 with the reference solver's
// forces, over the largest displacement of a coordinate.
struct PrecisionRow {
  std::string scene, method, forces;  // forces: "kernel", or "judge" for the reference solver's
  int order;                          // 0: variable
  double setting;                     // relative tolerance; step (s) of fixed steps
  double error, seconds;
  long evaluations;
};

// Prints a table per scene during the run. `quick`: takes seconds in all, and its figures are not reliable.
std::vector<PrecisionRow> precision(bool quick);

void precision_write(std::FILE* out, const std::vector<PrecisionRow>& rows);

}  // namespace drape::bench
