// The four cloths of the work-precision diagram, and their equations y' = f(y) for the solvers.
#pragma once
#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "scene/scene.h"

namespace drape::bench {

// A scene and the time (s) at which errors are measured.
struct Trial {
  Scene scene;
  double end;
};
// Soft cotton, stiff wool, a flag in wind, strongly damped cotton; `quick`: smaller and shorter.
std::vector<Trial> trials(bool quick);

using Rate = std::function<void(const double* y, double* rate)>;

// y holds positions and velocities; with the reference solver's forces also what it integrates beside them.
struct Equations {
  std::vector<double> start;  // y at 0
  std::vector<double> scale;  // absolute tolerance over the relative one: a cell, 1 m/s
  Rate rate;                  // f
  // f = outer + inner: bending, weight and air; stretch, shear, -m c v and r' = v, which set the step limit.
  Rate outer, inner;
  std::function<Eigen::VectorXd(const double* y)> positions;  // [3 particles] in the reference's order
};
Equations equations_of_kernel(const Scene& scene);
Equations equations_of_reference(const Scene& scene);

}  // namespace drape::bench
