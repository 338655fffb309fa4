#include "laboratory/null_space_basis.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace drape::laboratory {
namespace {

// Groups the rows that share nodes, in the order of each group's first row.
std::vector<std::vector<std::size_t>> rows_gather(const System& system,
                                                  const std::vector<math::SparseRow>& rows) {
  std::vector<std::size_t> first(system.nodes, rows.size()), root(rows.size());
  std::iota(root.begin(), root.end(), std::size_t(0));
  const auto root_of = [&](std::size_t r) {
    while (root[r] != r) r = root[r];
    return r;
  };
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t n : rows[r].node) {
      if (first[n] == rows.size()) first[n] = r;
      const std::size_t a = root_of(first[n]), b = root_of(r);
      root[std::max(a, b)] = std::min(a, b);
    }
  std::vector<std::vector<std::size_t>> sets(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) sets[root_of(r)].push_back(r);
  sets.erase(std::remove_if(sets.begin(), sets.end(), [](const auto& set) { return set.empty(); }),
             sets.end());
  return sets;
}

NullSpaceBlock block_make(const std::vector<math::SparseRow>& rows, const std::vector<std::size_t>& set) {
  NullSpaceBlock block;
  block.row = set;
  std::vector<std::size_t> nodes;
  for (std::size_t r : set) nodes.insert(nodes.end(), rows[r].node.begin(), rows[r].node.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const Eigen::Index m = Eigen::Index(set.size()), n = Eigen::Index(nodes.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m, n);
  for (Eigen::Index i = 0; i < m; ++i) {
    const math::SparseRow& row = rows[set[std::size_t(i)]];
    for (std::size_t k = 0; k < row.node.size(); ++k)
      a(i, std::lower_bound(nodes.begin(), nodes.end(), row.node[k]) - nodes.begin()) += row.weight[k];
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
  const Eigen::MatrixXd sorted = a * lu.permutationQ();
  for (Eigen::Index j = 0; j < n; ++j)
    (j < m ? block.following : block.leading).push_back(nodes[std::size_t(lu.permutationQ().indices()[j])]);
  block.inverse = sorted.leftCols(m).inverse();
  block.follow = -block.inverse * sorted.rightCols(n - m);
  return block;
}

}  // namespace

NullSpaceBasis null_space_basis_make(const System& system, const std::vector<math::SparseRow>& rows,
                                     int dimension) {
  NullSpaceBasis basis;
  basis.all = unknowns_make(system, dimension);
  std::vector<char> follows(system.nodes, 0);
  for (const std::vector<std::size_t>& set : rows_gather(system, rows)) {
    basis.blocks.push_back(block_make(rows, set));
    for (std::size_t n : basis.blocks.back().following) follows[n] = 1;
  }
  std::vector<Eigen::Index> free(system.nodes, -1);
  Eigen::Index count = 0;
  Triplets z;
  for (std::size_t n : system.particle) {
    if (follows[n]) continue;
    free[n] = count;
    count += dimension;
    for (int k = 0; k < dimension; ++k) z.emplace_back(basis.all.first[n] + k, free[n] + k, 1.0);
  }
  for (const NullSpaceBlock& block : basis.blocks)
    for (std::size_t i = 0; i < block.following.size(); ++i)
      for (std::size_t j = 0; j < block.leading.size(); ++j)
        for (int k = 0; k < dimension; ++k)
          z.emplace_back(basis.all.first[block.following[i]] + k, free[block.leading[j]] + k,
                         block.follow(Eigen::Index(i), Eigen::Index(j)));
  basis.z.resize(basis.all.count, count);
  basis.z.setFromTriplets(z.begin(), z.end());
  return basis;
}

}  // namespace drape::laboratory
