// Rigid links beside the rows: |r_b - r_a| = L. core/README.md, section 4, "Rigid links".
//
//        a o----------o b     d = r_b - r_a,   C = (|d|^2 - L^2)/(2 L),   J = dC/dr = (-d/L, d/L)
//
// They are satisfied together with the rows A r = t (SHAKE, Ryckaert, Ciccotti, Berendsen 1977, with a matrix
// instead of one link after another), J at the beginning of the step:
//
//   [ A M^-1 A^T    A M^-1 J^T          ] [y]   [A r - t]
//   [ J M^-1 A^T    J M^-1 J^T + e D    ] [z] = [C(r)   ],    r <- r - M^-1 (A^T y + J^T z),     again until
//   C is small
//
// D is the diagonal of J M^-1 J^T. Links may say the same as others, or what others do not allow (in a plane
// a truss of more than 2 n - 3 links): e D leaves such a part of C where it is instead of dividing by
// nothing. A displacement beyond what links ask is at most 1/(2 sqrt e) of what they do; what one sweep
// leaves of a link that is free to follow is e.
#pragma once
#include "math/cholesky.h"

namespace drape::constraint {

struct HeldRow;
struct FixedNode;

struct RigidLink {
  std::size_t node[2];  // a, b
  int order;            // links of neighbours have numbers near each other
  double length;        // L, m
};

// Scalar rows: x, y, z of each held row, then the links. What is constant of them.
struct Rigid {
  std::vector<RigidLink> link;
  std::size_t held = 0;             // scalar rows of held rows
  std::vector<std::size_t> begin;   // [scalar rows + 1] into the entries
  std::vector<std::size_t> node;    // [entries]
  std::vector<int> axis;            // [entries]
  std::vector<char> fixed;          // [entries] the node is held on its own: nothing moves it
  Array weight;                     // [entries] of held rows; 0 in links
  math::CholeskyFactor shape;       // of the matrix, eliminated in the order of the links; without numbers
  std::vector<std::size_t> column;  // [scalar rows] their place in that order

  // The matrix: slot k < rank is the diagonal of column k, the others the entries below, in order.
  struct Term {
    std::size_t slot, left, right;  // += weight[left] weight[right]/m
  };
  std::vector<Term> terms;
  std::vector<std::size_t> update;  // slots that take products of a column's entries, in the order they come
};

Rigid rigid_make(const std::vector<HeldRow>& rows, const std::vector<FixedNode>& fixed,
                 const std::vector<RigidLink>& links);

// Its numbers at a state.
struct RigidNow {
  Array weight;                 // [entries]
  Array slot;                   // of the matrix
  math::CholeskyFactor factor;  // as Rigid::shape
  bool ready = false;           // the factor is that of the weights
  Array rate;                   // [links] m/s or m/s^2 that links are to have along themselves
  Array y;                      // [scalar rows] sum of what sweeps took
  Array b;                      // [scalar rows] the right hand side
};
RigidNow rigid_now(const Rigid& rigid);

// Directions J at positions; the factor when it is needed.
void rigid_aim(const Rigid& rigid, const double* x, const double* y, const double* z, RigidNow& now);
void rigid_factor(const Rigid& rigid, const Array& inverse_mass, RigidNow& now);

// C of a link, m.
double rigid_excess(const RigidLink& link, const double* x, const double* y, const double* z);

// (J f) of a link, from the weights.
double rigid_along(const Rigid& rigid, const RigidNow& now, std::size_t link, const double* x,
                   const double* y, const double* z);

// Solves for now.b, adds it to now.y, and takes s M^-1 (A^T y + J^T z) out of each field.
struct RigidField {
  double *x, *y, *z;
  double scale;  // s
};
void rigid_correct(const Rigid& rigid, const Array& inverse_mass, RigidNow& now, const RigidField* field,
                   int fields);

}  // namespace drape::constraint
