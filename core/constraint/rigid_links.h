// Rigid links, in addition to the linear rows: |r_b - r_a| = L. core/README.md, section 4, "Rigid links".
//
//        a o----------o b     d = r_b - r_a,   C = (|d|^2 - L^2)/(2 L),   J = dC/dr = (-d/L, d/L)
//
// Links and rows A r = t are satisfied together, by the SHAKE iteration (Ryckaert, Ciccotti, Berendsen 1977)
// with one matrix for all links instead of one link after another. J is taken at the beginning of the step:
//
//   [ A M^-1 A^T    A M^-1 J^T          ] [y]   [A r - t]
//   [ J M^-1 A^T    J M^-1 J^T + e D    ] [z] = [C(r)   ],      r <- r - M^-1 (A^T y + J^T z),
//
// repeated until C is small. D is the diagonal of J M^-1 J^T. Links may be redundant or contradict each
// other, as in a plane truss of n nodes with more than 2 n - 3 links. The term e D regularises the matrix: it
// leaves the contradictory part of C unchanged instead of dividing by zero. Displacements beyond those that
// the links require are at most 1/(2 sqrt e) of these. One sweep leaves the fraction e of the error of a link
// that can move freely.
#pragma once
#include "math/cholesky.h"

namespace drape::constraint {

struct HeldRow;
struct FixedNode;

struct RigidLink {
  std::size_t node[2];  // a, b
  int order;            // elimination order; neighbouring links have close numbers
  double length;        // L, m
};

// The constant data of the system. Its scalar rows are x, y and z of each linear row, then the links.
struct Rigid {
  std::vector<RigidLink> link;
  std::size_t held = 0;             // number of scalar rows that belong to linear rows
  std::vector<std::size_t> begin;   // [scalar rows + 1] start of the entries of each row
  std::vector<std::size_t> node;    // [entries]
  std::vector<int> axis;            // [entries]
  std::vector<char> fixed;          // [entries] 1 where the node is fixed by a constraint of its own
  Array weight;                     // [entries] weights of linear rows; 0 in links
  math::CholeskyFactor shape;       // sparsity pattern of the factor; columns in elimination order
  std::vector<std::size_t> column;  // [scalar rows] their column in that order

  // The matrix. Slot k < rank is the diagonal of column k; the other slots are the entries below, in order.
  struct Term {
    std::size_t slot, left, right;  // slot += weight[left] weight[right]/m
  };
  std::vector<Term> terms;
  std::vector<std::size_t> update;  // slots updated by products of entries, in order of elimination
};

Rigid rigid_make(const std::vector<HeldRow>& rows, const std::vector<FixedNode>& fixed,
                 const std::vector<RigidLink>& links);

// The values of the system at one state.
struct RigidNow {
  Array weight;                 // [entries]
  Array slot;                   // values of the matrix
  math::CholeskyFactor factor;  // with the pattern Rigid::shape
  bool ready = false;           // the factor belongs to the present weights
  Array rate;                   // [links] m/s or m/s^2, target rate along each link
  Array y;                      // [scalar rows] sum of the multipliers of all sweeps
  Array b;                      // [scalar rows] right-hand side
};
RigidNow rigid_now(const Rigid& rigid);

// Sets the directions J at the positions x, y, z [nodes] (m) and marks the factor as outdated.
void rigid_aim(const Rigid& rigid, const double* x, const double* y, const double* z, RigidNow& now);

// Computes the factor, unless it is up to date.
void rigid_factor(const Rigid& rigid, const Array& inverse_mass, RigidNow& now);

// C of a link, m.
double rigid_excess(const RigidLink& link, const double* x, const double* y, const double* z);

// The component (J f) of a link, for a field f = (x, y, z) [nodes].
double rigid_along(const Rigid& rigid, const RigidNow& now, std::size_t link, const double* x,
                   const double* y, const double* z);

// Solves for the right-hand side now.b, whose solution replaces it and is added to now.y. Subtracts
// s M^-1 (A^T y + J^T z) from each field.
struct RigidField {
  double *x, *y, *z;
  double scale;  // s
};
void rigid_correct(const Rigid& rigid, const Array& inverse_mass, RigidNow& now, const RigidField* field,
                   int fields);

}  // namespace drape::constraint
