// The weave of a piece: hinges along the yarns, and its irregular elements. core/README.md, sections 1, 3, 4.
#pragma once
#include "model/system.h"
#include "piece/support/support.h"

namespace drape::assembly {

// The slopes that a pin prescribes on one piece.
struct ClampSlopes {
  int pin;
  std::vector<piece::HeldSlope> slopes;
};

// Sets the hinges of a lattice's nodes and adds its irregular elements.
void weave_lay(System& system, int lattice, const piece::Grid& grid, const std::vector<ClampSlopes>& clamps,
               const State& start);

// Numbers the slots: every node of irregular elements and seams, and every twin, gets one. Must run after the
// weave of all pieces and the seams are laid.
void slots_number(System& system);

}  // namespace drape::assembly
