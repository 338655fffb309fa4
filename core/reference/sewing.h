// Seams: the closing forces of their pairs, and the welds. Equations: core/README.md, section 6.
#pragma once
#include "reference/motion.h"

namespace drape::reference {

Sewing sewing_start(const Lattice& lattice);

// The rates s' of the integral terms of all pairs, m/s.
Eigen::VectorXd integral_rates(const Motion& motion, double time, const Eigen::VectorXd& r,
                               const Eigen::VectorXd& v);

// Adds the closing forces of all pairs that are kPulled to F [3 N], N, and returns their power on the cloth,
// W. integral [pairs]: integral terms, m.
double add_closing(const Lattice& lattice, const Sewing& sewing, const Eigen::VectorXd& integral,
                   const Eigen::VectorXd& r, const Eigen::VectorXd& v, Eigen::VectorXd& F);

// The hinges across welded pairs and the links along them: their forces, N, and energies, J.
void add_bonds(const Lattice& lattice, const Sewing& sewing, const Eigen::VectorXd& r, Eigen::VectorXd& F);
struct BondEnergy {
  double bending = 0, stretch = 0;
};
BondEnergy bond_energy(const Lattice& lattice, const Sewing& sewing, const Eigen::VectorXd& r);

// The events at the beginning of an interval, at `time`, s: closing starts, and pairs that have met are
// welded, which changes y. True where pairs have been welded.
bool motion_sew(Motion& motion, double time, const Outside& outside, Eigen::VectorXd& y);

}  // namespace drape::reference
