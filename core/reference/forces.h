// Internal forces of the cloth as plain loops over the lists, and their potential energies.
// Equations: core/README.md, section 3.
#pragma once
#include "reference/lattice.h"

namespace drape::reference {

double link_strain(const Link& link, const Eigen::VectorXd& r);  // l/rest - 1

// psi(y) = theta/sin(theta) of a hinge, and its energy over kappa. theta is computed by atan2; beyond 120
// degrees both are continued.
struct Fold {
  double y, psi, energy;
};
Fold fold_of(const Eigen::Vector3d& a, const Eigen::Vector3d& c);

// The rotation of each pin since the start [pins].
using Turns = std::vector<Eigen::Matrix3d>;
Turns unturned(const Lattice& lattice);

// Each function adds the forces of one law to F [3 N], N.
void add_stretch(const Lattice& lattice, const Eigen::VectorXd& r, Eigen::VectorXd& F);
void add_shear(const Lattice& lattice, const Eigen::VectorXd& r, Eigen::VectorXd& F);
void add_bending(const Lattice& lattice, const Eigen::VectorXd& r, Eigen::VectorXd& F);
// Adds the forces of the clamp hinges. Returns their couple on each clamp [3 pins], N m.
Eigen::VectorXd add_clamps(const Lattice& lattice, const Turns& turns, const Eigen::VectorXd& r,
                           Eigen::VectorXd& F);
Eigen::VectorXd forces(const Lattice& lattice, const Eigen::VectorXd& r, const Turns& turns);  // all four
Eigen::VectorXd forces(const Lattice& lattice, const Eigen::VectorXd& r);  // with all pins unrotated

// Energies, J.
double stretch_energy(const Lattice& lattice, const Eigen::VectorXd& r);
double shear_energy(const Lattice& lattice, const Eigen::VectorXd& r);
double bending_energy(const Lattice& lattice, const Eigen::VectorXd& r);  // without the clamp hinges
double clamp_energy(const Lattice& lattice, const Turns& turns, const Eigen::VectorXd& r);

}  // namespace drape::reference
