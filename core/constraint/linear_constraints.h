// Pins as linear constraints on nodes: sum_k w_k r_k = target. core/README.md, section 4.
//
// A row on a single node fixes it: the node is put back after each step. The other rows, less the nodes
// already fixed and made independent, are projected together:
//
//   y = (A M^-1 A^T)^-1 (A r - target),   r <- r - M^-1 A^T y,   v <- v - M^-1 A^T y / h
//
// Either way the momentum taken out is the impulse on the outside world. A target moves with the frames of
// pins:
//
//   target = sum_parts share p + R (start - share p_0)
//
// one part of share 1 but where nodes fixed by pins were taken out of a row; an impulse J on the row is then
// share J on each pin, with the moment R (start - share p_0) x J about it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "constraint/rigid_links.h"
#include "math/cholesky.h"
#include "scene/scene.h"

namespace drape::constraint {

// What a pin is before it moves.
struct PinBase {
  std::string name;
  Vec3 centre{0, 0, 0};  // p_0, m
  bool clamp = false;    // the frame may turn
  scene::Drive drive = scene::Drive::kNone;
};

// One constraint as the scene states it; nodes by index into the State's arrays.
struct ConstraintRow {
  int pin;                        // index into Scene::pins; -1: of a weld, whose target is 0
  std::vector<std::size_t> node;  // [k]
  std::vector<double> weight;     // [k] none of them 0, sum 1
  Vec3 target;                    // m, at the start
};

struct TargetPart {
  int pin;
  double share;
  Vec3 start;  // m
};

struct Target {
  int first = 0, count = 0;  // its parts
  Vec3 start{0, 0, 0};       // their sum at the start, m
  bool moves = false;        // a pin among them is driven
};

struct FixedNode {
  std::size_t node;
  Target target;
};

struct HeldRow {
  math::SparseRow on;  // two nodes or more, none of them fixed
  Target target;
};

// The rows' entries one after the other, as a step reads them.
struct RowTerm {
  std::uint32_t node;
  double weight, pull;  // pull: over the node's mass, 1/kg
};

// Rows that share nodes, if through others: they are met on their own.
struct RowPart {
  std::size_t begin, end;           // rows
  std::vector<RowTerm> term;        // theirs
  std::vector<std::size_t> last;    // [rows] where the terms of a row end
  std::vector<std::uint32_t> line;  // nodes over kRowUnit, sorted, each once
  math::CholeskyFactor factor;      // of A M^-1 A^T
};

struct Constraints {
  std::vector<PinBase> pins;  // as Scene::pins
  std::vector<TargetPart> parts;
  std::vector<FixedNode> fixed;
  std::vector<HeldRow> rows;                  // independent
  std::vector<RowPart> part;                  // of the rows, in their order
  std::vector<std::size_t> rows_with_target;  // the rows that have a target
  Rigid rigid;                                // links beside them
};

// Sorts rows into fixed nodes and independent rows. Rows of pins that contradict each other, now or once
// their pins are driven apart, are problems (place = pin name); a weld that says nothing new is left out.
Constraints constraints_make(const std::vector<ConstraintRow>& rows, const Array& inverse_mass,
                             std::vector<PinBase> pins, std::vector<Problem>& problems,
                             const std::vector<RigidLink>& links = {});

// Anew after a change of the masses.
void constraints_refactor(Constraints& constraints, const Array& inverse_mass);

}  // namespace drape::constraint
