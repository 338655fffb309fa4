// The links and hinges of a piece along its threads, and what of them lies beside the rows. core/README.md,
// sections 1, 3, 4.
#pragma once
#include "model/system.h"
#include "piece/support/support.h"

namespace drape::assembly {

// The slopes that a pin holds on one piece.
struct ClampSlopes {
  int pin;
  std::vector<piece::HeldSlope> slopes;
};

// Sets the hinges of a lattice's nodes and adds to the lists beside its rows.
void weave_lay(System& system, int lattice, const piece::Grid& grid, const std::vector<ClampSlopes>& clamps,
               const State& start);

// Gives every node that the lists touch, and every twin, its slot: when all pieces are laid.
void slots_number(System& system);

}  // namespace drape::assembly
