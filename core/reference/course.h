// The inputs of the cloth: wind and pins within an advance, and inputs over time. core/README.md, section 4,
// "Inputs".
#pragma once
#include <string>
#include <vector>

#include "reference/frame.h"
#include "reference/lattice.h"

namespace drape::reference {

// The values of the inputs at a time.
struct Outside {
  std::vector<Frame> pins;  // [Lattice::pins]
  Eigen::Vector3d wind;     // m/s
};
Outside outside_start(const Scene& scene, const Lattice& lattice);

// The path of the inputs within an advance.
struct Course {
  double length;           // s
  std::vector<Path> pins;  // [Lattice::pins]
  Eigen::Vector3d wind_from, wind_to;
};
Course course_make(const Lattice& lattice, const Outside& from, const Outside& to, double length);
Outside course_at(const Course& course, double time);  // time since the beginning of the advance, s

// Columns of inputs, with the names of the FMU's variables. Values are interpolated linearly between rows,
// and constant before the first and after the last row. Inputs without a column keep their start values.
struct InputTable {
  std::vector<std::string> names;          // [columns]
  std::vector<double> time;                // [rows] s, increasing; empty: no inputs
  std::vector<std::vector<double>> value;  // [rows][columns]
};
// The inputs at a time, s. Throws std::runtime_error where a name is no input of the scene, or an orientation
// has length 0.
Outside inputs_at(const InputTable& inputs, const Scene& scene, const Lattice& lattice, double time);

}  // namespace drape::reference
