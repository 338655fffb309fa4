// Pivoted Cholesky factor of a sparse Gram matrix, A D A^T of a few entries a row: what a solve costs is what
// the factor holds.
#pragma once
#include <cstddef>
#include <vector>

#include "math/aligned_array.h"

namespace drape::math {

// A linear form of nodal values.
struct SparseRow {
  std::vector<std::size_t> node;  // [k]
  std::vector<double> weight;     // [k]
};

// P G P^T = L L^T; column k of L belongs to the row of the k-th pivot.
struct CholeskyFactor {
  std::vector<int> row;            // [rank] pivots, largest first
  std::vector<double> inverse;     // [rank] 1/L_kk
  std::vector<std::size_t> begin;  // [rank + 1] into the entries below the diagonal
  std::vector<int> entry_row;      // [entries] theirs
  std::vector<double> entry;       // [entries]
};

// Rows are independent where their pivot exceeds `tolerance` times their own diagonal; the others have no
// column. Rows from `late` on come after all others, and must exceed `late_tolerance`.
CholeskyFactor cholesky_factorise(const std::vector<const SparseRow*>& rows, const Array& inverse_mass,
                                  double tolerance, std::size_t late = std::size_t(-1),
                                  double late_tolerance = 0);

// Solves G y = b for three components at once; b [rows x 3] is overwritten by y, whose dependent rows become
// 0.
void cholesky_solve(const CholeskyFactor& factor, double* b);
void cholesky_solve_scalar(const CholeskyFactor& factor, double* b);  // of one component; b [rows]

}  // namespace drape::math
