// The two structs of the model: System is constant after assembly, State is what the motion changes.
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
#include "model/energy_guard.h"
#include "model/irregular_elements.h"
#include "model/seams.h"
#include "model/self_contact.h"
#include "piece/grid/grid.h"

namespace drape::model {

// Columns from begin to end - 1; multiples of kRowUnit.
struct Columns {
  int begin, end;
};

// One piece as rows of nodes in the common arrays. Node (i,j) is at first + j stride + i. A guard row below
// and above the rows, and at least one node at the end of each row, are unused: they have share 0 and mass 0
// and never move. So are kRowUnit nodes at either end of the arrays. Twins are further particles at rest
// positions that the outline splits. They follow the guard row above, padded to whole registers.
struct Lattice {
  int columns = 0, rows = 0;   // numbers of nodes along weft, warp
  int stride = 0;              // multiple of kRowUnit
  std::size_t first = 0;       // multiple of kRowUnit
  int twins = 0;               // number of twins
  std::size_t twin_first = 0;  // multiple of kRowUnit
  int twin_stride = 0;         // multiple of kRowUnit
  int twin_slot = 0;           // slot of the first twin; multiple of kRowUnit
  std::vector<int>
      row_slot;  // [rows + 1] slots of the nodes of row j: row_slot[j] .. row_slot[j+1] - 1; or empty
  std::vector<Columns> reach;                  // [rows] columns where rows j - 1, j, j + 1 have particles
  double cell = 0;                             // m, cell size b
  double mass_kept = 1;                        // 1, lower bound of a node's mass over that of its cells' area
  std::vector<std::array<int, 2>> twin_place;  // [twins] column and row
  int piece = 0, fabric = 0;
  fabric::Law law;
  ContactLaw contact_law;

  std::size_t node(int i, int j) const { return first + std::size_t(j) * stride + i; }
  std::size_t node_of(int grid_node) const {  // from the numbering of piece::Grid
    const int k = grid_node - columns * rows;
    return k >= 0 ? twin_first + std::size_t(k) : node(grid_node % columns, grid_node / columns);
  }
  std::size_t end() const { return twin_first + std::size_t(twin_stride); }  // one past its last node
  bool owns(std::size_t n) const { return n >= first && n < end(); }
  std::array<int, 2> place_of(std::size_t n) const {  // column and row
    if (n >= twin_first) return twin_place[n - twin_first];
    return {int((n - first) % std::size_t(stride)), int((n - first) / std::size_t(stride))};
  }
};

inline constexpr Mat3 kIdentityRotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// The air around the cloth. The wind is part of State.
struct Air {
  double density = 0;                 // kg/m^3
  double normal = 0, tangential = 0;  // 1, drag coefficients C_n, C_t; both 0: no air
};

// A point of the cloth: position = sum over k of weight[k] times the position of node[k].
struct Probe {
  std::size_t node[4];
  double weight[4];
};

struct System {
  scene::Integrator integrator = scene::Integrator::kLeapfrog;
  const Composition* composition = nullptr;  // method of an order above 2; null for order 2
  double communication = 1e-3;               // q, s
  double step_given = 0;                     // s, step of the scene; 0 = automatic
  double step_max = 0;                       // s, upper bound of the step
  double damping = 0;                        // c, 1/s
  Vec3 gravity{0, 0, 0};                     // m/s^2
  Air air;
  int threads = 1;      // upper bound of the number of threads that share a step
  bool energy = false;  // the energy balance is computed
  bool fit = false;     // mode "fit"
  fabric::LawOptions options;
  std::size_t nodes = 0;  // length of every array of nodes here and in State, unused nodes included
  Array share;            // [nodes] 1, phi of the cell up and right of the node; 0 where the cell has a twin
  Array hinge_warp;       // [nodes] 1, kappa over B of the hinge at the node along the warp
  Array hinge_weft;       // [nodes] 1, likewise along the weft
  Array area;             // [nodes] m^2
  Array mass;             // [nodes] kg
  Array inverse_mass;     // [nodes] 1/kg; 0 where there is no particle
  std::vector<Lattice> lattices;
  IrregularElements irregular;
  Seams seams;
  std::vector<std::size_t> particle;  // [particles] their nodes: pieces in order, row by row
  std::vector<constraint::ConstraintRow> pin_rows;
  std::vector<constraint::RigidLink> links;  // of the particles of seams, with outline = "paper"
  constraint::Constraints constraints;       // of the pins, with the masses at assembly
  std::vector<Probe> probes;                 // in the order of Scene::probes
  std::vector<Body> bodies;                  // in the order of Scene::bodies
  EdgeElements edge_elements;                // empty where no body has sharp features
  SelfMesh self;                             // empty without self contact
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

// True where forces depend on velocity beyond the damping -m c v.
inline bool system_has_rates(const System& system) {
  bool rates = system_has_air(system);
  for (const Lattice& l : system.lattices) rates = rates || l.law.damping > 0;
  return rates;
}

// The state of the relaxation in fit mode. core/README.md, section 4.
struct RelaxationState {
  double damping = 0;                      // c, 1/s
  int intervals_to_convergence_check = 0;  // communication intervals until the next convergence check
  double residual = 1;                     // 1, sum of the unbalanced forces over the load
  double load = 0;                         // N, weight or pins' forces
  double max_force = 0;       // N, largest sum of unbalanced and pins' forces since the last change
  bool at_rest = false;       // the equilibrium is reached
  bool sewing = false;        // seams are still to close: gravity and friction are off
  double settling = 0;        // s, upper bound of the time for which friction stays off
  std::int64_t measured = 0;  // step at which the present measurement of the damping began
  int measure_every = 0;      // minimum number of steps of that measurement; 0: nothing is stored
  Array place[3], force[3];   // [nodes] m, N, positions at that step, and the forces there
};

struct State {
  Array x, y, z;     // [nodes] m, at t_n
  Array vx, vy, vz;  // [nodes] m/s, at t_{n-1/2} (paper scheme: at t_n; above order 2: of the last drift)

  // Only in systems with forces that depend on velocity (system_has_rates):
  Array wx, wy, wz;    // [nodes] m/s, at t_{n-3/2}
  double h_older = 0;  // s, the step before h_old; 0 at the first step

  std::vector<Sewn> sewn;  // [pairs of seams]
  Array gap_rate;          // [pairs x 3] m/s, rates of the gaps at t_{n-3/2}; empty without seams
  Array closing_integral;  // [pairs] m, integral term s of the closing force
  Array closing_time;      // [pairs] s, how long the pair has been closing

  std::vector<BodyContact> body;  // [bodies]
  SelfState self;

  Array inverse_mass_scale;  // [nodes] 1, mass over inertia, at most 1; only in fit mode
  RelaxationState relaxation;

  Vec3 wind{0, 0, 0};                         // m/s, at t_n
  std::vector<Mat3> pin_rotation;             // [pins] R at t_n
  std::vector<math::RigidMotion> pin_motion;  // [pins] at t_n

  double dissipated = 0, input = 0;  // J, only with system.energy: without the last half step
  double drive_work = 0;             // J, of pins and closing seams on the cloth; without the last half step
  double energy_start = 0;           // J, kinetic and potential energy at the start

  // Time = origin + tick q. A communication step that is not a multiple of q moves the origin.
  double origin = 0;                        // s
  std::int64_t tick = 0;                    // whole communication intervals since origin
  std::int64_t steps = 0;                   // number of steps since the start
  std::int64_t steps_per_interval = 0;      // steps in an interval of q; 0 = not chosen yet
  std::int64_t intervals_since_change = 0;  // whole intervals since that number last changed
  double h_old = 0;                         // s, the last step; 0 at the start

  int steps_to_limit_check = 0;  // steps until the next check of the step limit
  int limit_check_period = 1;    // number of steps that the next check covers
  double omega2 = 0;             // 1/s^2, found by the last check
  // Running means: of the energy defect of a step over its h^3 (J/s^3), and of the kinetic energy, J.
  double mean_defect = 0, mean_kinetic = 0;
  double flutter = 0;  // 1/s^3, the largest change of omega^2 of a cell in a step over h
  double max_contact_step =
      std::numeric_limits<double>::infinity();  // s, bound by near bodies, at the last check
  // The largest of all checks since the number of steps last changed.
  double max_omega2 = 0, max_drift = 0, max_flutter = 0;

  EnergyGuard guard;

  double advance_length = 0;    // s, of the last advance; 0 = none yet
  bool advance_begins = false;  // the next step is the first of an advance
  // [pins] N s and N m s on the outside world in the last advance, without its last half step.
  std::vector<math::Wrench> pin_impulse;
};

inline double state_time(const State& s, double communication) {
  return s.origin + double(s.tick) * communication;
}

// The step in the next interval, s.
inline double step_next(const System& system, const State& s) {
  return system.communication / double(s.steps_per_interval > 1 ? s.steps_per_interval : 1);
}

// The inertia of a particle, kg: its mass, in fit mode divided by the inverse mass scale.
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
