// What the pins hold: linear rows sum_k w_k r_k = target. Equations: core/README.md, section 4, "Pins".
#pragma once
#include "reference/frame.h"
#include "reference/lattice.h"

namespace drape::reference {

// What has become of each pair of each seam.
enum class Stage : char { kOpen, kPulled, kWelded };
using Sewing = std::vector<std::vector<Stage>>;  // [Lattice::seams][pairs]

struct Held {
  std::vector<int> holder;       // [N] index of the row that fixes the particle; -1: free
  Eigen::VectorXd inverse_mass;  // [N] 1/kg; 0 where fixed
  Eigen::MatrixXd A;             // [rows x N] the independent rows on several particles
  std::vector<int> row;          // [rows] their indices into Lattice::rows; -1: a weld, whose target is 0
  Eigen::LLT<Eigen::MatrixXd> gram{Eigen::MatrixXd(0, 0)};  // A M^-1 A^T
};
Held held_make(const Lattice& lattice, const Sewing& sewing);

// The targets of all rows [Lattice::rows] with their pins in these frames.
std::vector<Target> targets_of(const Lattice& lattice, const std::vector<Frame>& frames);

// What each pin passes to the outside world [3 pins]: forces or impulses, and their moments about its
// position.
struct Passed {
  Eigen::VectorXd force, torque;
};

// Turns the free rate x [3 N] (an acceleration or a velocity) into the one with the rows' `wanted` ones; the
// points that are held lie at `arm` from their pins.
Passed hold(const Lattice& lattice, const Held& held, const std::vector<Eigen::Vector3d>& wanted,
            const std::vector<Eigen::Vector3d>& arm, Eigen::VectorXd& x);

}  // namespace drape::reference
