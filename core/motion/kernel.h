// The lattice pass: all forces of a lattice and, fused with it, either the step or their output.
#pragma once
#include "system/system.h"

namespace drape {

// v <- keep v + kick (F/m + g),  r <- r + drift v
struct StepCoefficients {
  double keep, kick, drift;
  Vec3 gravity;
};

inline constexpr int kScratchRows = 3 * 7 + 4 * 3 + 3 * 3;  // links; diagonals and hinges; forces

// Scratch rows of one pass; made once, large enough for the longest row of a system.
struct Workspace {
  Array rows;
  int stride = 0;
};
Workspace workspace_make(const System& system);

struct Kernel {
  const char* name;
  // Advances positions and velocities of a lattice by one step.
  void (*step)(const System&, const Lattice&, const StepCoefficients&, Workspace&, State&);
  // Writes the internal forces F (N) of a lattice to fx, fy, fz [nodes].
  void (*forces)(const System&, const Lattice&, const State&, Workspace&, double* fx, double* fy, double* fz);
  // The largest omega^2 (1/s^2) of the step limit over the row of cells above row j of a lattice, at r +
  // ahead v (s).
  double (*omega2)(const System&, const Lattice&, const State&, int j, double ahead);
};

// The fastest kernel of this processor. The environment variable DRAPE_SIMD = portable | scalar | avx2 |
// avx512 picks one where the processor has it; `scalar` is a slow yardstick with fused arithmetic.
const Kernel& kernel_pick();
const Kernel* kernel_named(const char* name);  // null: unknown, or not on this processor

extern const Kernel kKernelPortable, kKernelScalar, kKernelAvx2, kKernelAvx512;

}  // namespace drape
