// The lattice pass: all forces of a lattice and, fused with it, either the step or their output.
#pragma once
#include "contact/particle/contact_pass.h"
#include "dynamics/kernel/workers.h"
#include "forces/hinge_batch.h"
#include "model/system.h"

namespace drape::dynamics {

// v <- keep v + kick (F/m + g),  r <- r + drift v;  F at the velocity v + lead (v - w)
struct StepCoefficients {
  double keep, kick, drift;
  Vec3 gravity;
  double extrapolation;
};

// Rows begin .. end - 1 of a lattice, which one thread moves. Rows of its neighbours, which move meanwhile,
// it reads from copies: two on either side.
struct RowBlock {
  int lattice = 0, begin = 0, end = 0;
  Array copies;  // [2 rows below, 2 above][3 or 9 coordinates][stride]
};

// x y z, and vx vy vz wx wy wz where forces depend on velocity.
inline int block_coordinates(const State& s) { return s.wx.empty() ? 3 : 9; }

inline constexpr int kScratchRows = 3 + 3 * 3 + 2 * 3;  // links; forces; velocities

// What a thread works in: its blocks, and scratch rows as long as the longest row of the system.
struct ThreadWorkspace {
  std::vector<RowBlock> blocks;
  Array rows;
};

// Room of all threads, and the forces beside the rows; made once.
struct Workspace {
  std::vector<ThreadWorkspace> threads;
  WorkersHandle workers;         // of more threads than one
  Array slot_x, slot_y, slot_z;  // [slots] N
};
Workspace workspace_make(const System& system, int threads);
int threads_wanted(const System& system);  // as many as the system asks for, where each gets enough to do
// Forgets what is no number: rows are read beyond what the pass before has written, where nothing weighs it.
void workspace_clear(Workspace& workspace);

// What a pass leads to: a state that it moves, or internal and air forces (N) [nodes].
struct PassTarget {
  State* moved;
  double *fx, *fy, *fz;
};

// One pass over a block of rows. What lies beside the rows is taken from the workspace. `rates`: with the
// forces that depend on velocity, for which a step keeps the old velocity in w.
using Pass = void (*)(const System&, const RowBlock&, const StepCoefficients&, const Workspace&,
                      double* scratch, const State&, const PassTarget&);

struct Kernel {
  const char* name;
  Pass plain, rates;
  // The largest omega^2 (1/s^2) of the step limit over the row of cells above row j of a lattice, at r +
  // ahead v (s).
  double (*omega2)(const System&, const model::Lattice&, const State&, int j, double ahead);
  contact::ContactKernel contact;
  forces::HingeKernel hinges;
};

// One step of all lattices.
void kernel_step(const Kernel& kernel, const System& system, const StepCoefficients& c, Workspace& workspace,
                 State& state);

// F (N) at t_n of all particles into fx, fy, fz [nodes].
void kernel_forces(const Kernel& kernel, const System& system, const State& state, Workspace& workspace,
                   double* fx, double* fy, double* fz);

// How far the velocity is led on to t_n: u_n = v + lead (v - w), v = v_{n-1/2}, w = v_{n-3/2}.
double velocity_extrapolation(const System& system, const State& state);

// The fastest kernel of this processor. The environment variable DRAPE_SIMD = portable | scalar | avx2 |
// avx512 picks one where build and processor have it; `scalar` is a slow yardstick with fused arithmetic.
const Kernel& kernel_pick();
const Kernel* kernel_named(const char* name);  // null: not in this build, or not on this processor

extern const Kernel kKernelPortable, kKernelScalar, kKernelAvx2, kKernelAvx512;

}  // namespace drape::dynamics
