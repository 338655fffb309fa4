// The lattice pass: all forces of a lattice and, fused with it, either the step or their output.
#pragma once
#include "system/system.h"

namespace drape {

// v <- keep v + kick (F/m + g),  r <- r + drift v;  F at the velocity v + lead (v - w)
struct StepCoefficients {
  double keep, kick, drift;
  Vec3 gravity;
  double lead;
};

inline constexpr int kScratchRows =
    3 * 4 + 2 * 3 + 3 * 3 + 3 * 3;  // links; hinges; forces; velocities and air

// Scratch rows of one pass, large enough for the longest row of a system, and the forces beside the rows;
// made once.
struct Workspace {
  Array rows;
  int stride = 0;
  Array side_x, side_y, side_z;  // [slots] N
};
Workspace workspace_make(const System& system);

// One pass over a lattice. What lies beside its rows is taken from the workspace. `rates`: with the forces
// that depend on velocity, for which step keeps the old velocity in w.
struct Pass {
  // Advances positions and velocities of a lattice by one step.
  void (*step)(const System&, const Lattice&, const StepCoefficients&, Workspace&, State&);
  // Writes the internal and air forces F (N) of a lattice to fx, fy, fz [nodes].
  void (*forces)(const System&, const Lattice&, const State&, double lead, Workspace&, double* fx, double* fy,
                 double* fz);
};

struct Kernel {
  const char* name;
  Pass plain, rates;
  // The largest omega^2 (1/s^2) of the step limit over the row of cells above row j of a lattice, at r +
  // ahead v (s).
  double (*omega2)(const System&, const Lattice&, const State&, int j, double ahead);
};

// One step of all lattices.
void kernel_step(const Kernel& kernel, const System& system, const StepCoefficients& c, Workspace& workspace,
                 State& state);

// F (N) at t_n of all particles into fx, fy, fz [nodes].
void kernel_forces(const Kernel& kernel, const System& system, const State& state, Workspace& workspace,
                   double* fx, double* fy, double* fz);

// How far the velocity is led on to t_n: u_n = v + lead (v - w), v = v_{n-1/2}, w = v_{n-3/2}.
double velocity_lead(const System& system, const State& state);

// The fastest kernel of this processor. The environment variable DRAPE_SIMD = portable | scalar | avx2 |
// avx512 picks one where the processor has it; `scalar` is a slow yardstick with fused arithmetic.
const Kernel& kernel_pick();
const Kernel* kernel_named(const char* name);  // null: unknown, or not on this processor

extern const Kernel kKernelPortable, kKernelScalar, kKernelAvx2, kKernelAvx512;

}  // namespace drape
