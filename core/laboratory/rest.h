// The rest of a cloth at the present places of its pins, by Newton's method: what fit mode looks for by
// motion, to the last digits and in a few steps where a good first guess is at hand.
//
// The forces are the kernel's. With A r = t the rows of all pins (held points, fixed nodes included), the
// method of multipliers (Hestenes 1969, Powell 1969) makes
//
//     F(r) + m g - A^T q = 0,   A r = t       by     (K + s A^T A) dr = F + m g - A^T [q + s (A r - t)],
//                                                    q <- q + s (A r - t)     after each step,
//
// K = -dF/dr. Its error falls by about K/s a step beside Newton's own square. q are the forces of the cloth
// on its pins. A step is cut until it lowers the energy E - sum m g.r + sum q.(A r - t) + s/2 |A r - t|^2
// (Armijo 1966); where K is not positive, it is made so.
#pragma once
#include <memory>

#include "motion/leapfrog.h"

namespace drape {

struct RestFound {
  bool found = false;
  int steps = 0;
  double residual = 0;      // forces left on particles over the load, both summed by size
  std::vector<Vec3> force;  // [pins] N, of the cloth on them
};

// What a search keeps for the next one, of a state near by.
struct RestSearch;
struct RestSearchCloser {
  void operator()(RestSearch* search) const;
};
using RestSearchHandle = std::unique_ptr<RestSearch, RestSearchCloser>;

// `flat`: the cloth stays in its plane z = const.
RestSearchHandle rest_search_make(const System& system, bool flat);

// Moves the state from its present places to the rest. The load is the larger of the weight and the pins'
// forces.
RestFound rest_find(RestSearch& search, const System& system, Motion& motion, State& state);

}  // namespace drape
