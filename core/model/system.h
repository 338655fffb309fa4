// The two structs that carry everything: System, constant after assembly, and State, what the motion changes.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "constraint/linear_constraints.h"
#include "fabric/material_law.h"
#include "math/aligned_array.h"
#include "math/rigid_motion.h"
#include "model/composition.h"
#include "model/contact.h"
#include "model/edge_contact.h"
#include "model/irregular_elements.h"
#include "model/seams.h"
#include "model/self_contact.h"
#include "piece/grid/grid.h"

namespace drape::model {

// Columns from begin to end - 1; multiples of kRowUnit.
struct Columns {
  int begin, end;
};

// One piece as rows of nodes in the common arrays. Node (i,j) is at first + j stride + i; a guard row on
// either side and at least one unused node at the end of each row have share 0 and mass 0, and never move. So
// have kRowUnit nodes at either end of the arrays. Twins follow the guard row above, padded to whole
// registers.
struct Lattice {
  int columns = 0, rows = 0;   // nodes along weft, warp
  int stride = 0;              // multiple of kRowUnit
  std::size_t first = 0;       // multiple of kRowUnit
  int twins = 0;               // nodes of their own at places that the outline splits
  std::size_t twin_first = 0;  // multiple of kRowUnit
  int twin_stride = 0;         // multiple of kRowUnit
  int twin_slot = 0;           // of the first twin in Side; multiple of kRowUnit
  std::vector<int>
      row_slot;  // [rows + 1] slots of the nodes of row j in Side: row_slot[j] .. row_slot[j+1]; or empty
  std::vector<Columns> reach;                  // [rows] where rows j - 1, j, j + 1 have particles
  double cell = 0;                             // b, m
  double mass_kept = 1;                        // the least share of its cells' area that a node carries
  std::vector<std::array<int, 2>> twin_place;  // [twins] column and row
  int piece = 0, fabric = 0;
  fabric::Law law;
  ContactLaw contact_law;

  std::size_t node(int i, int j) const { return first + std::size_t(j) * stride + i; }
  std::size_t node_of(int grid_node) const {  // of Grid's numbering
    const int k = grid_node - columns * rows;
    return k >= 0 ? twin_first + std::size_t(k) : node(grid_node % columns, grid_node / columns);
  }
  std::size_t end() const { return twin_first + std::size_t(twin_stride); }  // behind its last node
  bool owns(std::size_t n) const { return n >= first && n < end(); }
  std::array<int, 2> place_of(std::size_t n) const {  // column and row
    if (n >= twin_first) return twin_place[n - twin_first];
    return {int((n - first) % std::size_t(stride)), int((n - first) / std::size_t(stride))};
  }
};

inline constexpr Mat3 kIdentityRotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// Of the environment; the wind is a part of the State.
struct Air {
  double density = 0;                 // kg/m^3
  double normal = 0, tangential = 0;  // C_n, C_t; both 0: no air
};

struct Probe {
  std::size_t node[4];
  double weight[4];
};

struct System {
  scene::Integrator integrator = scene::Integrator::kLeapfrog;
  const Composition* composition = nullptr;  // of the orders above 2
  double communication = 1e-3;               // q, s
  double step_given = 0;                     // s; 0 = automatic
  double step_max = 0;                       // s
  double damping = 0;                        // c, 1/s
  Vec3 gravity{0, 0, 0};                     // m/s^2
  Air air;
  int threads = 1;      // that share a step, at most
  bool energy = false;  // the balance is kept
  bool fit = false;     // mode "fit"
  fabric::LawOptions options;
  std::size_t nodes = 0;  // length of every array below and in State, unused nodes included
  Array share;            // [nodes] phi of the cell up and right of the node; 0 where that has a twin
  Array hinge_warp;       // [nodes] kappa over B of the hinge across the node along the warp
  Array hinge_weft;       // [nodes] likewise along the weft
  Array area;             // [nodes] m^2
  Array mass;             // [nodes] kg
  Array inverse_mass;     // [nodes] 1/kg; 0 where there is no particle
  std::vector<Lattice> lattices;
  IrregularElements irregular;
  Seams seams;
  std::vector<std::size_t> particle;  // [particles] their nodes: pieces in order, row by row
  std::vector<constraint::ConstraintRow> pin_rows;
  std::vector<constraint::RigidLink> links;  // of the particles of seams with outline = "paper"
  constraint::Constraints constraints;       // of the pins, at the masses of the assembly
  std::vector<Probe> probes;                 // as Scene::probes
  std::vector<Body> bodies;                  // as Scene::bodies
  EdgeElements edge_elements;                // empty where no body has a ridge
  SelfMesh self;                             // of cloth that touches itself
};

// The lattice that owns a node.
inline const Lattice& system_lattice_of(const System& system, std::size_t n) {
  const Lattice* l = system.lattices.data();
  while (!l->owns(n)) ++l;
  return *l;
}

inline bool system_has_air(const System& system) {
  return system.air.normal > 0 || system.air.tangential > 0;
}

// True where forces depend on velocity otherwise than by -m c v.
inline bool system_has_rates(const System& system) {
  bool rates = system_has_air(system);
  for (const Lattice& l : system.lattices) rates = rates || l.law.damping > 0;
  return rates;
}

// How a fit stands. core/README.md, section 4.
struct RelaxationState {
  double damping = 0;                      // c, 1/s
  int intervals_to_convergence_check = 0;  // intervals until the forces left are looked at
  double residual = 1;                     // their sum over the load
  double load = 0;                         // N, weight or pins' forces
  double max_force = 0;  // N, forces left and pins' forces, the most since something last changed
  bool at_rest = false;
  bool sewing = false;        // seams are to be closed: weight and friction wait
  double settling = 0;        // s, for which friction waits yet at most
  std::int64_t measured = 0;  // step from which the damping is measured next
  int measure_every = 0;      // steps of that measure, at least; 0: nothing is kept
  Array place[3], force[3];   // [nodes] m, N, where particles were then, and the forces there
};

struct State {
  Array x, y, z;     // [nodes] m, at t_n
  Array vx, vy, vz;  // [nodes] m/s, at t_{n-1/2} (paper scheme: at t_n; above order 2: of the last drift)

  // Only in systems with forces that depend on velocity (system_has_rates):
  Array wx, wy, wz;    // [nodes] m/s, at t_{n-3/2}
  double h_older = 0;  // s, the step before h_old; 0 at the first

  std::vector<Sewn> sewn;  // [pairs of seams]
  Array gap_rate;          // [pairs x 3] m/s, of the gaps at t_{n-3/2}; empty without seams
  Array closing_integral;  // [pairs] m, s of the pull
  Array closing_time;      // [pairs] s

  std::vector<BodyContact> body;  // [bodies]
  SelfState self;

  Array inverse_mass_scale;  // [nodes] mass over inertia, at most 1; only in a fit
  RelaxationState relaxation;

  Vec3 wind{0, 0, 0};                         // m/s, at t_n
  std::vector<Mat3> pin_rotation;             // [pins] R at t_n
  std::vector<math::RigidMotion> pin_motion;  // [pins] at t_n

  double dissipated = 0, input = 0;  // J, with system.energy: but for the last half step
  double energy_start = 0;           // J, kinetic and potential

  // Time = origin + tick q. A communication step that is no multiple of q moves the origin.
  double origin = 0;                        // s
  std::int64_t tick = 0;                    // whole communication intervals since origin
  std::int64_t steps = 0;                   // since the start
  std::int64_t steps_per_interval = 0;      // steps in an interval of q; 0 = not chosen yet
  std::int64_t intervals_since_change = 0;  // whole intervals since that number last changed
  double h_old = 0;                         // s, the step that led here; 0 at the start

  int steps_to_limit_check = 0;  // steps until the step limit is looked at again
  int limit_check_period = 1;    // steps that the next look looks ahead
  double omega2 = 0;             // 1/s^2, what the last look found
  double max_contact_step = std::numeric_limits<double>::infinity();  // s, of bodies near, at the last look
  double max_omega2 = 0;  // 1/s^2, the most that any look found since the number of steps last changed

  double advance_length = 0;    // s, of the last advance; 0 = none yet
  bool advance_begins = false;  // the next step is the first of an advance
  // [pins] N s and N m s on the outside world in the last advance, but for its last half step.
  std::vector<math::Wrench> pin_impulse;
};

inline double state_time(const State& s, double communication) {
  return s.origin + double(s.tick) * communication;
}

// The step of the next interval, s.
inline double step_next(const System& system, const State& s) {
  return system.communication / double(s.steps_per_interval > 1 ? s.steps_per_interval : 1);
}

// Of a particle, kg; in a fit the enlarged one.
inline double inertia_of(const System& system, const State& s, std::size_t n) {
  return system.mass[n] / (s.inverse_mass_scale.empty() ? 1 : s.inverse_mass_scale[n]);
}

inline void state_resize(State& s, std::size_t nodes, std::size_t pins) {
  for (Array* a : {&s.x, &s.y, &s.z, &s.vx, &s.vy, &s.vz}) a->assign(nodes, 0.0);
  s.pin_impulse.assign(pins, math::Wrench{});
  s.pin_motion.assign(pins, math::RigidMotion{});
  s.pin_rotation.assign(pins, kIdentityRotation);
}

}  // namespace drape::model

namespace drape {
using model::State;
using model::System;
}  // namespace drape
