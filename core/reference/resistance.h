// Forces that depend on velocity. Equations: core/README.md, section 3, damping along springs and air.
#pragma once
#include "reference/lattice.h"

namespace drape::reference {

struct Air {
  double density = 0, normal = 0, tangential = 0;  // kg/m^3, 1, 1
};

// Both add to F [3 N] and return the power that they take from the cloth, W; of the air, as seen by the wind.
double add_link_damping(const Lattice& lattice, const Eigen::VectorXd& r, const Eigen::VectorXd& v,
                        Eigen::VectorXd& F);
struct AirPower {
  double taken;  // -sum F.u, u the velocity of the cloth relative to the wind
  double given;  // sum F.wind
};
AirPower add_air(const Lattice& lattice, const Air& air, const Eigen::Vector3d& wind,
                 const Eigen::VectorXd& r, const Eigen::VectorXd& v, Eigen::VectorXd& F);

}  // namespace drape::reference
