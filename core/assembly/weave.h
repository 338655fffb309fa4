// The links and hinges of a piece along its threads, and what of them lies beside the rows. core/README.md,
// sections 1, 3, 4.
#pragma once
#include "piece/support/support.h"
#include "model/system.h"

namespace drape {

// The slopes that a pin holds on one piece.
struct ClampSlopes {
  int pin;
  std::vector<HeldSlope> slopes;
};

// Sets the hinges of a lattice's nodes and adds to the lists beside its rows.
void threads_lay(System& system, int lattice, const Grid& grid, const std::vector<ClampSlopes>& clamps,
                 const State& start);

// Gives every node that the lists touch, and every twin, its slot: when all pieces are laid.
void side_number(System& system);

}  // namespace drape
