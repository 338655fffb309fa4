// What a row of the result says, by the names of the FMU's variables.
#pragma once
#include "reference/motion.h"

namespace drape::reference {

struct OutputChoice {
  bool energy = false, nodes = false;
};

std::vector<std::string> output_columns(const Scene& scene, const Lattice& lattice, OutputChoice choice);

// The row at a time. pin_force [3 pins] is on the outside world.
std::vector<double> output_row(const Motion& motion, OutputChoice choice, double time,
                               const Eigen::VectorXd& y, const Eigen::VectorXd& pin_force, double last_step,
                               long step_count);

}  // namespace drape::reference
