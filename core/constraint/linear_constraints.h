// Pins and welds as linear constraints on nodes: sum_k w_k r_k = target. core/README.md, section 4.
//
// Each constraint is a row of A. A row on a single node fixes that node, which is set to its target after
// each step. Fixed nodes are eliminated from the other rows, and dependent rows are removed. The remaining
// rows are projected together:
//
//   y = (A M^-1 A^T)^-1 (A r - target),   r <- r - M^-1 A^T y,   v <- v - M^-1 A^T y / h
//
// In both cases the momentum removed is the impulse on the outside world. A target moves with its pins:
//
//   target = sum_parts share p + R (start - share p_0)
//
// where p is the position and R the rotation of a pin, and p_0 its initial position. A target has one part of
// share 1, unless nodes fixed by pins were eliminated from its row. An impulse J on the row gives each pin
// the impulse share J and the moment R (start - share p_0) x J about it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "constraint/rigid_links.h"
#include "math/cholesky.h"
#include "scene/scene.h"

namespace drape::constraint {

// The constant data of a pin.
struct PinBase {
  std::string name;
  Vec3 centre{0, 0, 0};  // p_0, m
  bool clamp = false;    // the pin may rotate
  scene::Drive drive = scene::Drive::kNone;
};

// One constraint as the scene gives it. Nodes are indices into the arrays of State.
struct ConstraintRow {
  int pin;                        // index into Scene::pins; -1: a weld, whose target is 0
  std::vector<std::size_t> node;  // [k]
  std::vector<double> weight;     // [k] none of them 0, sum 1
  Vec3 target;                    // m, initial value
};

struct TargetPart {
  int pin;
  double share;
  Vec3 start;  // m
};

struct Target {
  int first = 0, count = 0;  // its range in Constraints::parts
  Vec3 start{0, 0, 0};       // sum of the initial values of the parts, m
  bool moves = false;        // one of its pins is driven
};

struct FixedNode {
  std::size_t node;
  Target target;
};

struct HeldRow {
  math::SparseRow on;  // at least two nodes, none of them fixed
  Target target;
};

// One entry of a row, stored contiguously for the time step.
struct RowTerm {
  std::uint32_t node;
  double weight, pull;  // pull: weight over the mass of the node, 1/kg
};

// A set of rows that are connected by shared nodes. Each set is projected independently of the others.
struct RowPart {
  std::size_t begin, end;           // range in Constraints::rows
  std::vector<RowTerm> term;        // the entries of the rows
  std::vector<std::size_t> last;    // [rows] index in `term` of the end of each row
  std::vector<std::uint32_t> line;  // node / kRowUnit of all nodes, sorted, each once
  math::CholeskyFactor factor;      // of A M^-1 A^T
};

struct Constraints {
  std::vector<PinBase> pins;  // in the order of Scene::pins
  std::vector<TargetPart> parts;
  std::vector<FixedNode> fixed;
  std::vector<HeldRow> rows;                  // independent
  std::vector<RowPart> part;                  // the rows are sorted by these parts
  std::vector<std::size_t> rows_with_target;  // numbers of the rows with a target that is not 0
  Rigid rigid;                                // rigid links, projected together with the rows
};

// Divides the constraints into fixed nodes and independent rows. Pins that contradict each other, at the
// start or once driven apart, are reported as problems with place "pin.<name>". A redundant weld is dropped.
Constraints constraints_make(const std::vector<ConstraintRow>& rows, const Array& inverse_mass,
                             std::vector<PinBase> pins, std::vector<Problem>& problems,
                             const std::vector<RigidLink>& links = {});

// Factorises the rows again after a change of the masses.
void constraints_refactor(Constraints& constraints, const Array& inverse_mass);

}  // namespace drape::constraint
