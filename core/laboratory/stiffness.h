// The tangent stiffness of a cloth: K = -dF/dr of the forces of links, hinges and clamps, as triplets.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "model/system.h"

namespace drape::laboratory {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Unknowns of a node: `dimension` consecutive ones from first[node] on; -1 where the node is no particle.
struct Unknowns {
  int dimension = 3;                // 2: the cloth stays in the plane z = const
  std::vector<Eigen::Index> first;  // [nodes]
  Eigen::Index count = 0;
};
Unknowns unknowns_make(const System& system, int dimension);

// kBlunt leaves out what compressed links take from K across themselves and falling laws along, so that it is
// not negative in flat cloth.
enum class Stiffness { kTangent, kBlunt };

// Adds K, N/m. Forces that depend on velocity have no part in it.
void stiffness_add(const System& system, const State& state, Stiffness which, const Unknowns& unknowns,
                   Triplets& to);

}  // namespace drape::laboratory
