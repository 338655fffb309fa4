// Forces that depend on velocity: damping along links, and air. Equations: core/README.md, section 3.
#pragma once
#include "reference/lattice.h"

namespace drape::reference {

struct Air {
  double density = 0, normal = 0, tangential = 0;  // kg/m^3, 1, 1
};

// Both functions add to F [3 N], N, and return the dissipated power, W. For air it is relative to the wind.
double add_link_damping(const Lattice& lattice, const Eigen::VectorXd& r, const Eigen::VectorXd& v,
                        Eigen::VectorXd& F);
struct AirPower {
  double dissipated;  // -sum F.u, with u the velocity of the cloth relative to the wind
  double input;       // sum F.wind
};
AirPower add_air(const Lattice& lattice, const Air& air, const Eigen::Vector3d& wind,
                 const Eigen::VectorXd& r, const Eigen::VectorXd& v, Eigen::VectorXd& F);

}  // namespace drape::reference
