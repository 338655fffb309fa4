// The lattice pass computes all forces of a lattice. Fused with it is either the step or the output of the
// forces.
#pragma once
#include "contact/particle/contact_pass.h"
#include "contact/self/groups.h"
#include "dynamics/kernel/workers.h"
#include "forces/hinge_batch.h"
#include "model/field.h"
#include "model/scheme.h"
#include "model/system.h"

namespace drape::dynamics {

// Rows begin .. end - 1 of a lattice, which one CPU thread moves. The thread reads the rows of its
// neighbours, which move at the same time, from copies: two on either side.
struct RowBlock {
  int lattice = 0, begin = 0, end = 0;
  Array copies;  // [2 rows below, 2 above][3 or 9 coordinates][stride]
};

// Coordinates in a copy: x y z, and vx vy vz wx wy wz where forces depend on velocity.
inline int block_coordinates(const State& s) { return s.wx.empty() ? 3 : 9; }

inline constexpr int kScratchRows = 3 + 3 * 3 + 2 * 3;  // links; forces; velocities

// Workspace of one CPU thread: its blocks, and scratch rows as long as the longest row of the system.
struct ThreadWorkspace {
  std::vector<RowBlock> blocks;
  Array rows;
};

// Workspace of all CPU threads, and the forces of irregular elements; made once.
struct Workspace {
  std::vector<ThreadWorkspace> threads;
  WorkersHandle workers;         // null with one thread
  Array slot_x, slot_y, slot_z;  // [slots] N
};
Workspace workspace_make(const System& system, int threads);
int threads_wanted(const System& system);  // system.threads, or fewer, so that each has enough work
// Clears the scratch rows after a run that has left the finite numbers. A pass also reads scratch that the
// pass before has not written; it has weight 0 there, but 0 times NaN is NaN.
void workspace_clear(Workspace& workspace);

// The output of a pass: a state that it moves, or internal and air forces.
struct PassTarget {
  State* moved;          // null: write forces
  double *fx, *fy, *fz;  // [nodes] N
};

// One pass over a block of rows. The workspace holds the forces of irregular elements. `rates` includes the
// forces that depend on velocity; for these a step keeps the old velocity in w.
using LatticePass = void (*)(const System&, const RowBlock&, const model::Scheme&, const Workspace&,
                             double* scratch, const State&, const PassTarget&);

// What a step errs in energy (J), summed over links, and the largest change of omega^2 of a cell in it,
// 1/s^2.
struct StepDefect {
  double energy = 0, omega2 = 0;
};

// J, of the links that begin at the nodes of a row and of the hinges that are centred on it.
struct RowEnergy {
  double stretch = 0, shear = 0, bending = 0;
};

struct Kernel {
  const char* name;
  LatticePass plain, rates;
  // The largest omega^2 (1/s^2) of the step limit over the row of cells above row j of a lattice, at the
  // positions r + ahead v. `ahead`: s.
  double (*omega2)(const System&, const model::Lattice&, const State&, int j, double ahead);
  // Of the links of that row of cells in the last step, of `step` s.
  StepDefect (*defect)(const System&, const model::Lattice&, const State&, int j, double step);
  // The elastic energy of row j of a lattice, without irregular elements.
  RowEnergy (*energy)(const System&, const model::Lattice&, const State&, int j);
  contact::ContactKernel contact;
  contact::SelfContactKernel self_contact;
  forces::HingeKernel hinges;
};

// One step of all lattices; without constraints and contact.
void kernel_step(const Kernel& kernel, const System& system, const model::Scheme& c, Workspace& workspace,
                 State& state);

// Writes F (N) of all particles at t_n to `force` [nodes].
void kernel_forces(const Kernel& kernel, const System& system, const State& state, Workspace& workspace,
                   model::Field force);

// The coefficient e that extrapolates the velocity to t_n: u_n = v + e (v - w), v = v_{n-1/2}, w = v_{n-3/2}.
double velocity_extrapolation(const System& system, const State& state);

// The fastest kernel of this processor. The environment variable DRAPE_SIMD = portable | scalar | avx2 |
// avx512 selects one that build and processor have. `scalar` is a slow reference with fused arithmetic.
const Kernel& kernel_pick();
const Kernel* kernel_named(const char* name);  // null: unknown, or not supported here

extern const Kernel kKernelPortable, kKernelScalar, kKernelAvx2, kKernelAvx512;

}  // namespace drape::dynamics
