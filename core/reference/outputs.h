// The columns of the result, with the names of the FMU's variables, and their values.
#pragma once
#include "reference/motion.h"

namespace drape::reference {

std::vector<std::string> output_columns(const Scene& scene, const Lattice& lattice, bool nodes);

// The data of one row.
struct Sample {
  double time;
  Eigen::VectorXd y;
  Outside outside;
  Passed pins;          // N, N m, mean over the last advance, on the outside world
  double energy_start;  // J
  double step_size;
  long step_count;
};
std::vector<double> output_row(const Scene& scene, const Motion& motion, bool nodes, const Sample& sample);

}  // namespace drape::reference
