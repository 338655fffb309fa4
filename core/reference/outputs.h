// What a row of the result says, by the names of the FMU's variables.
#pragma once
#include "reference/motion.h"

namespace drape::reference {

std::vector<std::string> output_columns(const Scene& scene, const Lattice& lattice, bool nodes);

// A row's data at a time.
struct Sample {
  double time;
  Eigen::VectorXd y;
  Outside outside;
  Passed pins;          // mean force and torque on the outside world over the last advance
  double energy_start;  // J
  double step_size;
  long step_count;
};
std::vector<double> output_row(const Scene& scene, const Motion& motion, bool nodes, const Sample& sample);

}  // namespace drape::reference
