// The rest of a cloth at the present places of its pins, by Newton's method: what fit mode looks for by
// motion, to the last digits and in a few steps where a good first guess is at hand.
//
// The forces are the kernel's. Z are the motions that held points and fixed nodes leave (held_basis.h), K =
// -dF/dr:
//
//     Z^T (F(r) + m g) = 0      by      Z^T K Z dy = Z^T (F + m g),   dr = Z dy.
//
// A step is cut until it lowers the energy E - sum m g.r (Armijo 1966); where Z^T K Z is not positive, it is
// made so. What is left over on held nodes are the forces of the cloth on its pins.
#pragma once
#include <memory>

#include "dynamics/advance.h"

namespace drape::laboratory {

struct Equilibrium {
  bool found = false;
  int steps = 0;
  double residual = 0;      // forces left on particles over the load, both summed by size
  std::vector<Vec3> force;  // [pins] N, of the cloth on them
};

// What a search keeps for the next one, of a state near by.
struct EquilibriumSearch;
struct EquilibriumSearchCloser {
  void operator()(EquilibriumSearch* search) const;
};
using EquilibriumSearchHandle = std::unique_ptr<EquilibriumSearch, EquilibriumSearchCloser>;

// `flat`: the cloth stays in its plane z = const.
EquilibriumSearchHandle equilibrium_search_make(const System& system, bool flat);

// Moves the state from its present places to the rest. The load is the largest of the weight, the pins'
// forces and 1e-2 N.
Equilibrium equilibrium_find(EquilibriumSearch& search, const System& system, dynamics::Motion& motion,
                             State& state);

}  // namespace drape::laboratory
