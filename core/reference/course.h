// What the outside world does with the cloth: wind and pins within an advance, and inputs over time.
// core/README.md, section 4, "Inputs".
#pragma once
#include <string>
#include <vector>

#include "reference/frame.h"
#include "reference/lattice.h"

namespace drape::reference {

// Where the inputs are, or are to be.
struct Outside {
  std::vector<Frame> pins;  // [Lattice::pins]
  Eigen::Vector3d wind;     // m/s
};
Outside outside_start(const Scene& scene, const Lattice& lattice);

// The way of the inputs within an advance.
struct Course {
  double length;           // s
  std::vector<Path> pins;  // [Lattice::pins]
  Eigen::Vector3d wind_from, wind_to;
};
Course course_make(const Lattice& lattice, const Outside& from, const Outside& to, double length);
Outside course_at(const Course& course, double time);  // since the beginning of the advance

// Columns of inputs by the names of the FMU's variables, linear between the rows; the first and the last row
// hold outside. Inputs without a column keep their start values.
struct InputTable {
  std::vector<std::string> names;          // [columns]
  std::vector<double> time;                // [rows] s, rising; none: no inputs
  std::vector<std::vector<double>> value;  // [rows][columns]
};
// The inputs at a time; throws std::runtime_error where a name is no input of the scene.
Outside inputs_at(const InputTable& inputs, const Scene& scene, const Lattice& lattice, double time);

}  // namespace drape::reference
