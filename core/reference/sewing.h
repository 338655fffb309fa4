// Seams: the pull on their pairs, and the welds. Equations: core/README.md, section 6.
#pragma once
#include "reference/motion.h"

namespace drape::reference {

Sewing sewing_start(const Lattice& lattice);

// s' of all pairs.
Eigen::VectorXd hold_rates(const Motion& motion, double time, const Eigen::VectorXd& r,
                           const Eigen::VectorXd& v);

// Adds the pull of all pulled pairs to F [3 N] and returns its power on the cloth, W; s of all pairs.
double add_pulls(const Lattice& lattice, const Sewing& sewing, const Eigen::VectorXd& s,
                 const Eigen::VectorXd& r, const Eigen::VectorXd& v, Eigen::VectorXd& F);

// The hinges across welded pairs and the links along them: their forces, and their energies, J.
void add_bonds(const Lattice& lattice, const Sewing& sewing, const Eigen::VectorXd& r, Eigen::VectorXd& F);
struct BondEnergy {
  double bending = 0, stretch = 0;
};
BondEnergy bond_energy(const Lattice& lattice, const Sewing& sewing, const Eigen::VectorXd& r);

// The beginning of an interval at a time: pulling begins, and pairs that have come together are welded, y
// with them. True where pairs have been welded.
bool motion_sew(Motion& motion, double time, const Outside& outside, Eigen::VectorXd& y);

}  // namespace drape::reference
