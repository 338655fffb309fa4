// The motions that held rows A r = t leave to a cloth. Rows that share nodes make a block; a Gaussian
// elimination with complete pivoting finds the nodes that follow the others,
//
//     A = [A1 A2],   r_1 = A1^-1 (t - A2 r_2),   dr_1 = -A1^-1 A2 dr_2,
//
// A1 square. The pivots are the largest entries left, so that A1^-1 A2 stays of the order of 1 where rows
// nearly say the same, as those of a jaw's corner and of a thread beside it.
// The forces f that nodes at rest exert are f = A^T q with A1^T q = f_1.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "laboratory/stiffness.h"

namespace drape::laboratory {

struct NullSpaceBlock {
  std::vector<std::size_t> row;                 // [m]
  std::vector<std::size_t> following, leading;  // [m], [n - m] nodes
  Eigen::MatrixXd inverse;                      // [m x m] A1^-1
  Eigen::MatrixXd follow;                       // [m x n - m] -A1^-1 A2
};

struct NullSpaceBasis {
  std::vector<NullSpaceBlock> blocks;
  Unknowns all;                   // of every particle
  Eigen::SparseMatrix<double> z;  // [all.count x free] dr = Z dy
};

// `rows` are independent, and act on particles.
NullSpaceBasis null_space_basis_make(const System& system, const std::vector<math::SparseRow>& rows,
                                     int dimension);

}  // namespace drape::laboratory
