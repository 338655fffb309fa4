// Pins as linear constraints on nodes: sum_k w_k r_k = target. core/README.md, section 4.
//
// A row on a single node fixes it: the node is put back after each step. The other rows, less the nodes
// already fixed and made independent, are projected together:
//
//   y = (A M^-1 A^T)^-1 (A r - target),   r <- r - M^-1 A^T y,   v <- v - M^-1 A^T y / h
//
// Either way the momentum taken out is the impulse on the outside world.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "system/array.h"

namespace drape {

// One constraint as the scene states it; nodes by index into the State's arrays.
struct ConstraintRow {
  int pin;                        // index into Scene::pins
  std::vector<std::size_t> node;  // [k]
  std::vector<double> weight;     // [k] none of them 0, sum 1
  Vec3 target;                    // m
};

struct FixedNode {
  std::size_t node;
  int pin;
  Vec3 target;
};

struct Constraints {
  std::vector<FixedNode> fixed;
  std::vector<ConstraintRow> rows;   // on two nodes or more, independent, free of fixed nodes
  std::vector<double> factor;        // [rows x rows] lower Cholesky factor of A M^-1 A^T, row-major
  std::vector<double> inverse_mass;  // [sum of node counts] of the rows' nodes, in order
};

// Sorts rows into fixed nodes and independent rows. Rows that contradict each other are problems (place = pin
// name).
Constraints constraints_make(std::vector<ConstraintRow> rows, const Array& inverse_mass,
                             const std::vector<PinSpec>& pins, std::vector<Problem>& problems);

// Anew after a change of the masses.
void constraints_refactor(Constraints& constraints, const Array& inverse_mass);

// Solves A M^-1 A^T y = b for the three components of b at once; b [rows x 3] is overwritten by y.
void constraints_solve(const Constraints& constraints, double* b);

}  // namespace drape
