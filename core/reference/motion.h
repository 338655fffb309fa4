// The cloth in motion: r'' = g + F(r, v, t)/m - c v under its pins, integrated by ARKODE's explicit ERKStep.
// Equations: core/README.md, section 4. One vector holds all that is integrated,
//     y = [r (3 N), v (3 N), J (3 pins), L (3 pins), W, D, s (pairs of seams), t],
// J and L being impulse and angular impulse (about its present position) that each pin has given to the
// outside world since the start, W the energy given to the cloth by pins, wind and seams, D the dissipated
// one, and t the time since the beginning of the advance: with it in the state the equations are autonomous.
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
  std::vector<std::vector<double>> pulled_from;  // [Lattice::seams][pairs] s, since when
  double begun = 0;                              // s, the present advance
  Held held;
  Eigen::Vector3d gravity;  // m/s^2
  double damping = 0;       // 1/s
  Air air;
  Outside start;  // where the inputs are before the first advance
};
Motion motion_make(const Scene& scene);

// Where the parts of y begin.
struct Layout {
  Eigen::Index velocity, impulse, angular, given, taken, hold, time, size;
};
Layout layout_of(const Lattice& lattice);

// dy/dt within an advance: for J and L force and torque of each pin on the outside world.
Eigen::VectorXd motion_rate(const Motion& motion, const Course& course, const Eigen::VectorXd& y);

// The start: what velocity the pins at rest do not allow they take up as a first impulse.
Eigen::VectorXd motion_start(const Motion& motion);

// Puts y to the beginning of an advance: what is held goes to where its pins are, and takes up the jump of
// their velocities; impulses and work are booked.
void motion_begin(const Motion& motion, const Course& course, Eigen::VectorXd& y);

struct Energy {  // J
  double kinetic, stretch, shear, bending, gravity, contact;
  double total() const { return kinetic + stretch + shear + bending + gravity + contact; }
};
Energy motion_energy(const Motion& motion, const Turns& turns, const Eigen::VectorXd& y);
Turns turns_of(const Outside& outside);

// The forces left on particles at rest at r [3 N], constraints taken out, summed by size, and that over the
// larger of the total weight and the pins' forces. Equations: core/README.md, "Fit".
struct Residual {
  double force, ratio;  // N, 1
};
Residual residual(const Motion& motion, const Outside& outside, const Eigen::VectorXd& r);

struct Accuracy {
  double rtol = 1e-10;    // relative; absolute: rtol times one cell, 1 m/s, and total mass times 1 m/s
  int order = 8;          // 2 to 8; ARKODE's method for 7 is that of 8
  double fixed_step = 0;  // s; 0 = adaptive
};

struct Solver;
struct SolverClose {
  void operator()(Solver* solver) const;
};
using SolverHandle = std::unique_ptr<Solver, SolverClose>;

// All of these throw std::runtime_error with one sentence that names the time and ARKODE's flag. The motion
// must outlive the solver.
SolverHandle solver_open(Motion& motion, const Eigen::VectorXd& y, const Accuracy& accuracy);
// The state at that time, with the inputs on their way to `to`; one step ends exactly there.
Eigen::VectorXd solver_advance(Solver& solver, double time, const Outside& to);
Eigen::VectorXd solver_advance(Solver& solver, double time);  // with the inputs staying where they are
const Outside& solver_outside(const Solver& solver);          // where they are
double solver_last_step(Solver& solver);                      // s; 0 before the first
long solver_step_count(Solver& solver);

}  // namespace drape::reference
