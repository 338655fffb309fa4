// Right-looking elimination. Each step eliminates the row with the largest pivot, relative to the row's own
// initial diagonal. Rows that support an outline edge couple only to their neighbours along the edge.
// Eliminating one of them couples its two neighbours, so the factor stays as narrow as the matrix.
#include "math/cholesky.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace drape::math {
namespace {

using SymmetricRows =
    std::vector<std::map<int, double>>;  // [rows] all entries except those of eliminated rows

SymmetricRows gram_of(const std::vector<const SparseRow*>& rows, const Array& inverse_mass) {
  std::map<std::size_t, std::vector<std::pair<int, double>>> by_node;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t k = 0; k < rows[r]->node.size(); ++k)
      by_node[rows[r]->node[k]].push_back({int(r), rows[r]->weight[k]});
  SymmetricRows gram(rows.size());
  for (const auto& [node, entries] : by_node)
    for (const auto& [r, wr] : entries)
      for (const auto& [s, ws] : entries) gram[std::size_t(r)][s] += wr * ws * inverse_mass[node];
  return gram;
}

// Eliminates the row of a pivot from the other rows, updates their diagonals and appends the pivot's column.
void eliminate(SymmetricRows& gram, int pivot, std::vector<double>& diagonals, CholeskyFactor& f) {
  const std::map<int, double> row = std::move(gram[std::size_t(pivot)]);
  const double diagonal = std::sqrt(row.at(pivot));
  f.row.push_back(pivot);
  f.inverse.push_back(1 / diagonal);
  for (const auto& [i, value] : row) {
    if (i == pivot) continue;
    f.entry_row.push_back(i);
    f.entry.push_back(value / diagonal);
  }
  const std::size_t first = f.begin.back(), end = f.entry.size();
  f.begin.push_back(end);
  for (std::size_t a = first; a < end; ++a) {
    std::map<int, double>& others = gram[std::size_t(f.entry_row[a])];
    others.erase(pivot);
    for (std::size_t b = first; b < end; ++b) {
      double& value = others[f.entry_row[b]];
      value -= f.entry[a] * f.entry[b];
      if (a == b) diagonals[std::size_t(f.entry_row[a])] = value;
    }
  }
}

}  // namespace

CholeskyFactor cholesky_factorise(const std::vector<const SparseRow*>& rows, const Array& inverse_mass,
                                  double tolerance, std::size_t late, double late_tolerance) {
  SymmetricRows gram = gram_of(rows, inverse_mass);
  std::vector<double> scale(rows.size()), diagonals(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    diagonals[r] = gram[r].at(int(r));
    scale[r] = 1 / diagonals[r];
  }
  CholeskyFactor f;
  f.begin.push_back(0);
  std::vector<char> done(rows.size(), 0);
  late = std::min(late, rows.size());
  for (const auto& [from, to, min_pivot] :
       {std::tuple{std::size_t(0), late, tolerance}, {late, rows.size(), late_tolerance}})
    for (std::size_t step = from; step < to; ++step) {
      int best = -1;
      double largest = min_pivot;
      for (std::size_t r = from; r < to; ++r) {
        if (done[r]) continue;
        const double pivot = diagonals[r] * scale[r];
        if (pivot > largest) largest = pivot, best = int(r);
      }
      if (best < 0) break;
      done[std::size_t(best)] = 1;
      eliminate(gram, best, diagonals, f);
    }
  return f;
}

namespace {

template <int kWidth>
void solve(const CholeskyFactor& f, double* b) {
  const std::size_t rank = f.row.size();
  for (std::size_t k = 0; k < rank; ++k) {
    double* y = b + kWidth * f.row[k];
    for (int c = 0; c < kWidth; ++c) y[c] *= f.inverse[k];
    for (std::size_t e = f.begin[k]; e < f.begin[k + 1]; ++e)
      for (int c = 0; c < kWidth; ++c) b[kWidth * f.entry_row[e] + c] -= f.entry[e] * y[c];
  }
  for (std::size_t k = rank; k-- > 0;) {
    double* y = b + kWidth * f.row[k];
    for (std::size_t e = f.begin[k]; e < f.begin[k + 1]; ++e)
      for (int c = 0; c < kWidth; ++c) y[c] -= f.entry[e] * b[kWidth * f.entry_row[e] + c];
    for (int c = 0; c < kWidth; ++c) y[c] *= f.inverse[k];
  }
}

}  // namespace

void cholesky_solve(const CholeskyFactor& f, double* b) { solve<3>(f, b); }
void cholesky_solve_scalar(const CholeskyFactor& f, double* b) { solve<1>(f, b); }

}  // namespace drape::math
