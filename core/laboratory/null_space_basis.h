// A basis of the motions that constraint rows A r = t permit: the null space of A. Rows that share nodes form
// a block. Gaussian elimination with complete pivoting divides the nodes of a block into following and
// leading ones:
//
//     A = [A1 A2],   r_1 = A1^-1 (t - A2 r_2),   dr_1 = -A1^-1 A2 dr_2,
//
// with A1 square. Each pivot is the largest remaining entry, so A1^-1 A2 stays of the order of 1 even where
// rows are nearly dependent, like those of a jaw's corner and of a yarn next to it. In equilibrium the forces
// f of the nodes are f = A^T q with A1^T q = f_1.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "laboratory/stiffness.h"

namespace drape::laboratory {

struct NullSpaceBlock {
  std::vector<std::size_t> row;                 // [m] indices of the rows
  std::vector<std::size_t> following, leading;  // [m], [n - m] nodes
  Eigen::MatrixXd inverse;                      // [m x m] A1^-1
  Eigen::MatrixXd follow;                       // [m x n - m] -A1^-1 A2
};

struct NullSpaceBasis {
  std::vector<NullSpaceBlock> blocks;
  Unknowns all;                   // the unknowns of all particles
  Eigen::SparseMatrix<double> z;  // [all.count x free] dr = Z dy
};

// rows: linearly independent, on particles only. dimension: 2 or 3.
NullSpaceBasis null_space_basis_make(const System& system, const std::vector<math::SparseRow>& rows,
                                     int dimension);

}  // namespace drape::laboratory
