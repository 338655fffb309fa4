// Pivoted Cholesky factor of a sparse Gram matrix G = A D A^T, where each row of A has a few entries. A solve
// costs in proportion to the number of entries of the factor.
#pragma once
#include <cstddef>
#include <vector>

#include "math/aligned_array.h"

namespace drape::math {

// A row of A: a linear form of nodal values.
struct SparseRow {
  std::vector<std::size_t> node;  // [k]
  std::vector<double> weight;     // [k]
};

// P G P^T = L L^T. Column k of L belongs to the row of the k-th pivot.
struct CholeskyFactor {
  std::vector<int> row;            // [rank] rows of the pivots, largest first
  std::vector<double> inverse;     // [rank] 1/L_kk
  std::vector<std::size_t> begin;  // [rank + 1] into the entries below the diagonal
  std::vector<int> entry_row;      // [entries] rows of the entries
  std::vector<double> entry;       // [entries]
};

// Factorises G with D = diag(inverse_mass), indexed by node. A row is independent where its pivot exceeds
// `tolerance` times its own diagonal. Dependent rows get no column. Rows with an index of at least `late` are
// eliminated after all others, and their pivots must exceed `late_tolerance`.
CholeskyFactor cholesky_factorise(const std::vector<const SparseRow*>& rows, const Array& inverse_mass,
                                  double tolerance, std::size_t late = std::size_t(-1),
                                  double late_tolerance = 0);

// Solves G y = b for three components at once; y overwrites b [rows x 3]. The components of dependent rows
// become 0.
void cholesky_solve(const CholeskyFactor& factor, double* b);
void cholesky_solve_scalar(const CholeskyFactor& factor, double* b);  // one component; b [rows]

}  // namespace drape::math
