// The motion of the cloth with its pins, r'' = g + F(r, v, t)/m - c v, integrated by ARKODE's explicit
// ERKStep. Equations: core/README.md, section 4. One vector contains all integrated variables:
//
//     y = [r (3 N), v (3 N), J (3 pins), L (3 pins), W, D, s (pairs of seams), t]
//
// J and L are the impulse and the angular impulse (about its present position) of each pin on the outside
// world since the start. W is the energy input to the cloth by pins, wind and seams, D the dissipated energy,
// s the integral terms of the closing forces. t is the time since the beginning of the advance: as a state,
// it makes the equations autonomous.
#pragma once
#include <Eigen/Dense>
#include <memory>

#include "reference/contact.h"
#include "reference/course.h"
#include "reference/forces.h"
#include "reference/held.h"
#include "reference/lattice.h"
#include "reference/resistance.h"

namespace drape::reference {

struct Motion {
  Lattice lattice;
  Sewing sewing;
  Contact contact;
  std::vector<std::vector<double>> closing_since;  // [Lattice::seams][pairs] s, when closing started
  double begun = 0;                                // s, begin of the present advance
  Held held;
  Eigen::Vector3d gravity;  // m/s^2
  double damping = 0;       // 1/s
  Air air;
  Outside start;  // the inputs before the first advance
};
Motion motion_make(const Scene& scene);

// The first index of each part of y: v, J, L, W, D, s, t, and the size.
struct Layout {
  Eigen::Index velocity, impulse, angular, input, dissipated, integral, time, size;
};
Layout layout_of(const Lattice& lattice);

// dy/dt within an advance. The rates of J and L are force and torque of each pin on the outside world.
Eigen::VectorXd motion_rate(const Motion& motion, const Course& course, const Eigen::VectorXd& y);

// y at the start. Velocity that the pins at rest do not permit becomes a first impulse on the pins.
Eigen::VectorXd motion_start(const Motion& motion);

// Prepares y for the beginning of an advance: held points move to their pins' positions and take their
// velocities, which may jump. Impulses and work are added to y.
void motion_begin(const Motion& motion, const Course& course, Eigen::VectorXd& y);

struct Energy {  // J
  double kinetic, stretch, shear, bending, gravity, contact;
  double total() const { return kinetic + stretch + shear + bending + gravity + contact; }
};
Energy motion_energy(const Motion& motion, const Turns& turns, const Eigen::VectorXd& y);
Turns turns_of(const Outside& outside);

// The unbalanced forces on particles at rest at r [3 N] m, constraint forces excluded: the sum of their
// magnitudes, and its ratio to the larger of the total weight and the pins' forces. Equations:
// core/README.md, "Fit".
struct Residual {
  double force, ratio;  // N, 1
};
Residual residual(const Motion& motion, const Outside& outside, const Eigen::VectorXd& r);

struct Accuracy {
  double rtol = 1e-10;    // relative; absolute: rtol times one cell, 1 m/s, and total mass times 1 m/s
  int order = 8;          // 2 to 8; for 7 ARKODE uses the method of order 8
  double fixed_step = 0;  // s; 0 = adaptive
};

struct Solver;
struct SolverClose {
  void operator()(Solver* solver) const;
};
using SolverHandle = std::unique_ptr<Solver, SolverClose>;

// These functions throw std::runtime_error with one sentence that names the time and ARKODE's flag. The
// motion must outlive the solver.
SolverHandle solver_open(Motion& motion, const Eigen::VectorXd& y, const Accuracy& accuracy);
// Advances to `time`, s, while the inputs move to `to`, and returns y there. The last step ends exactly at
// `time`.
Eigen::VectorXd solver_advance(Solver& solver, double time, const Outside& to);
Eigen::VectorXd solver_advance(Solver& solver, double time);  // with constant inputs
const Outside& solver_outside(const Solver& solver);          // the present inputs
double solver_last_step(Solver& solver);                      // s; 0 before the first step
long solver_step_count(Solver& solver);

}  // namespace drape::reference
