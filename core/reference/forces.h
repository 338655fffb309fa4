// Internal forces of the cloth as plain loops over the lists, and their potential energies.
// Equations: core/README.md, section 3.
#pragma once
#include "reference/lattice.h"

namespace drape::reference {

double link_strain(const Link& link, const Eigen::VectorXd& r);  // l/rest - 1

// psi(y) = theta/sin(theta) of a hinge and its energy over kappa, theta by atan2; continued past 120 degrees.
struct Fold {
  double y, psi, energy;
};
Fold fold_of(const Eigen::Vector3d& a, const Eigen::Vector3d& c);

// How far each pin's frame is turned since the start [pins].
using Turns = std::vector<Eigen::Matrix3d>;
Turns unturned(const Lattice& lattice);

// Each law adds to F [3 N].
void add_stretch(const Lattice& lattice, const Eigen::VectorXd& r, Eigen::VectorXd& F);
void add_shear(const Lattice& lattice, const Eigen::VectorXd& r, Eigen::VectorXd& F);
void add_bending(const Lattice& lattice, const Eigen::VectorXd& r, Eigen::VectorXd& F);
// The hinges between clamps and links; returns the couple that they exert on each clamp [3 pins].
Eigen::VectorXd add_clamps(const Lattice& lattice, const Turns& turns, const Eigen::VectorXd& r,
                           Eigen::VectorXd& F);
Eigen::VectorXd forces(const Lattice& lattice, const Eigen::VectorXd& r, const Turns& turns);  // all four
Eigen::VectorXd forces(const Lattice& lattice, const Eigen::VectorXd& r);  // with no pin turned

// J.
double stretch_energy(const Lattice& lattice, const Eigen::VectorXd& r);
double shear_energy(const Lattice& lattice, const Eigen::VectorXd& r);
double bending_energy(const Lattice& lattice, const Eigen::VectorXd& r);  // of the cloth's own hinges
double clamp_energy(const Lattice& lattice, const Turns& turns, const Eigen::VectorXd& r);

}  // namespace drape::reference
