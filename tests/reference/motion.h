// The cloth in motion: r'' = g + F(r)/m - c v under its pins, integrated by ARKODE's explicit ERKStep.
// Equations: core/README.md, section 4. One vector holds all that is integrated,
//     y = [r (3 N), v (3 N), J (3 pins)],
// J being the impulse that each pin has given to the outside world since the start.
#pragma once
#include <Eigen/Dense>
#include <memory>
#include <string>
#include <vector>

#include "reference/lattice.h"

namespace drape::reference {

struct Motion {
  Lattice lattice;
  Eigen::Vector3d gravity;           // m/s^2
  double damping = 0;                // 1/s
  std::vector<int> holder;           // [N] pin that fixes the particle; -1: free
  Eigen::VectorXd inverse_mass;      // [N] 1/kg; 0 where fixed
  Eigen::MatrixXd A;                 // [rows x N] the independent rows on several particles
  std::vector<int> row_pin;          // [rows]
  Eigen::LLT<Eigen::MatrixXd> gram;  // A M^-1 A^T
};
Motion motion_make(const Scene& scene);

// Turns the free rate x [3 N] (an acceleration or a velocity) into the one the pins allow; returns what each
// pin passes to the outside world [3 pins] (a force or an impulse).
Eigen::VectorXd constrain(const Motion& motion, Eigen::VectorXd& x);

// dy/dt; its last part is the force of each pin on the outside world.
Eigen::VectorXd motion_rate(const Motion& motion, const Eigen::VectorXd& y);

// The start: what velocity the pins do not allow they take up as a first impulse.
Eigen::VectorXd motion_start(const Motion& motion);

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
SolverHandle solver_open(const Motion& motion, const Eigen::VectorXd& y, const Accuracy& accuracy);
Eigen::VectorXd solver_advance(Solver& solver, double time);  // the state at that time
double solver_last_step(Solver& solver);                      // s; 0 before the first
long solver_step_count(Solver& solver);

}  // namespace drape::reference
