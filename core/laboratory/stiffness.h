// The tangent stiffness of a cloth, K = -dF/dr, of the forces of links, hinges and clamps, as triplets.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "model/system.h"

namespace drape::laboratory {

using Triplets = std::vector<Eigen::Triplet<double>>;

// The unknowns of a node are `dimension` consecutive ones from first[node]; -1 where the node is not a
// particle.
struct Unknowns {
  int dimension = 3;                // 2: the cloth stays in the plane z = const
  std::vector<Eigen::Index> first;  // [nodes]
  Eigen::Index count = 0;
};
Unknowns unknowns_make(const System& system, int dimension);

// kNonNegative omits the negative parts of K: those of compressed links across, and of falling laws along the
// link. So K is positive semidefinite in flat cloth.
enum class Stiffness { kTangent, kNonNegative };

// Adds the entries of K, N/m. Forces that depend on velocity are not part of K.
void stiffness_add(const System& system, const State& state, Stiffness which, const Unknowns& unknowns,
                   Triplets& to);

}  // namespace drape::laboratory
