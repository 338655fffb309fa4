// The equilibrium of a cloth with its pins at their present positions, by Newton's method. It is the same
// equilibrium that fit mode finds by relaxation, but accurate to rounding and in a few steps from a good
// first guess.
//
// The forces are those of the kernel. Z is a basis of the motions that held points and fixed nodes permit
// (null_space_basis.h), and K = -dF/dr:
//
//     Z^T (F(r) + m g) = 0      by      Z^T K Z dy = Z^T (F + m g),   dr = Z dy.
//
// A line search halves each step until it lowers the energy E - sum m g.r (Armijo 1966). Where Z^T K Z is not
// positive definite, it is modified. The unbalanced forces on held nodes are the forces of the cloth on its
// pins.
#pragma once
#include <memory>

#include "dynamics/advance.h"

namespace drape::laboratory {

struct Equilibrium {
  bool found = false;
  int steps = 0;
  double residual = 0;      // 1, sum of the unbalanced forces over the load, both by magnitude
  std::vector<Vec3> force;  // [pins] N, of the cloth on the pins
};

// The workspace of a search, reused for the next one from a nearby state.
struct EquilibriumSearch;
struct EquilibriumSearchCloser {
  void operator()(EquilibriumSearch* search) const;
};
using EquilibriumSearchHandle = std::unique_ptr<EquilibriumSearch, EquilibriumSearchCloser>;

// flat: the cloth stays in its plane z = const.
EquilibriumSearchHandle equilibrium_search_make(const System& system, bool flat);

// Moves the state from its present positions to the equilibrium. The load is the largest of the weight, the
// pins' forces and 1e-2 N.
Equilibrium equilibrium_find(EquilibriumSearch& search, const System& system, dynamics::Motion& motion,
                             State& state);

}  // namespace drape::laboratory
