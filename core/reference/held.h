// The constraints of pins and welds: linear rows sum_k w_k r_k = target. Equations: core/README.md, section
// 4, "Pins".
#pragma once
#include "reference/frame.h"
#include "reference/lattice.h"

namespace drape::reference {

// The stage of each pair of each seam.
enum class Stage : char { kOpen, kPulled, kWelded };
using Sewing = std::vector<std::vector<Stage>>;  // [Lattice::seams][pairs]

struct Held {
  std::vector<int> holder;       // [N] index of the row that fixes the particle; -1: free
  Eigen::VectorXd inverse_mass;  // [N] 1/kg; 0 where fixed
  Eigen::MatrixXd A;             // [rows x N] linearly independent rows on several particles
  std::vector<int> row;          // [rows] their indices in Lattice::rows; -1: a weld, whose target is 0
  Eigen::LLT<Eigen::MatrixXd> gram{Eigen::MatrixXd(0, 0)};  // A M^-1 A^T
};
Held held_make(const Lattice& lattice, const Sewing& sewing);

// The targets of all rows [Lattice::rows], with the pins in these frames.
std::vector<Target> targets_of(const Lattice& lattice, const std::vector<Frame>& frames);

// The load of each pin on the outside world [3 pins]: forces or impulses, and their moments about the pin's
// position.
struct Passed {
  Eigen::VectorXd force, torque;
};

// Projects the free values x [3 N] (accelerations, velocities or positions) so that each row has its value in
// `expected` [Lattice::rows]. arm [Lattice::rows] m: from the pin to the held point.
Passed constraints_project(const Lattice& lattice, const Held& held,
                           const std::vector<Eigen::Vector3d>& expected,
                           const std::vector<Eigen::Vector3d>& arm, Eigen::VectorXd& x);

}  // namespace drape::reference
