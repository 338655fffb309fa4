// Pairs that touch, in groups of kRowUnit pairs without a common node: the pairs of a group respond at once,
// in lanes, and the groups one after the other. contact/self/response.h has the law.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/particle/contact_pass.h"
#include "contact/self/narrow_phase.h"

namespace drape::contact {

inline constexpr std::size_t kGroupPairs = math::kRowUnit;

// Lane i of every member belongs to pair i, all points or all crosses. A lane without a pair has no weights,
// and never touches. A sweep takes as long as it reads memory, so what the nodes have stays with them.
struct alignas(math::kLine) SelfGroup {
  using Lanes = double[kGroupPairs];
  int at[4][kGroupPairs];  // index in SelfNodes
  Lanes weight[4];         // W
  Lanes n[3];
  Lanes distance;          // m
  Lanes contact_distance;  // m; -kFar where pins hold all that has weight
  Lanes stiffness;         // N/m
  Lanes slide, limit;  // coefficients of friction: kinetic; of what stuck in the last step, the static one
  Lanes mass;          // kg: 1/K, K = sum W_k^2/m_k
  Lanes expected;      // m/s, the least w_n that the stop allows
  Lanes given, yield;  // of the damped w_n = (given + w_n without P) yield: m/s; 1
  Lanes normal, stored, stop;      // N s: P; the part that the penalty gives; of the stop
  Lanes friction[3];               // N s; before a pass: N, of the last step
  Lanes slides;                    // 1 or 0
  bool crosses, touches, presses;  // two edges; any is nearer than its contact distance; any has an impulse
};

// The nodes of all groups; one more, which stays, serves the lanes without a pair. A row of four numbers is a
// vector and one more: of v the free velocity (m/s, per what centred damping leaves) and the inverse of the
// inertia (1/kg, 0 where a pin holds the node). Of r it is the position (m), of old v_{n-1/2} (m/s), and 0.
struct SelfNodes {
  std::vector<model::NodeIndex> node;
  std::vector<char> fixed;  // a pin holds it
  Array pushed;             // [nodes + 1] 1/kg of its inertia where it is fixed, else 0
  Array r, old, v;          // [nodes + 1] rows of four
};

// Sets the vector of a row from the fields x, y, z at a node.
inline void row_set(Array& rows, std::size_t row, const double* const field[3], std::size_t node) {
  for (std::size_t c = 0; c < 3; ++c) rows[4 * row + c] = field[c][node];
}

// What the fabrics of a pair say.
struct SelfPairLaw {
  double stiffness;     // N/m, without the share
  double stick, slide;  // coefficients of friction, static and kinetic
};

struct SelfGroups {
  std::vector<SelfGroup> group;
  SelfNodes node;
  std::vector<std::uint32_t> slot;  // [pairs] kGroupPairs x group + lane
  // The pairs for which this was made: candidates of a search, by their numbers.
  std::shared_ptr<const model::SelfPairs> candidates;
  std::vector<std::uint32_t> made_for;
  std::vector<int> index;  // [nodes] scratch: in `node`, or -1
};

// Puts the pairs of a narrow phase into groups, with all that does not depend on velocities, and with the
// friction of the last step. Old velocities of the nodes become the present ones. `inertia_of_fit`: with the
// inverse mass scales.
void self_group(const System& system, const State& state, bool inertia_of_fit,
                const std::vector<SelfContactPair>& pairs, SelfGroups& all);

SelfPairLaw self_pair_law(const System& system, const SelfContactPair& t);

// What a kernel reads and writes.
struct SelfContactPass {
  SelfGroup *begin, *end;
  const double *pushed, *r, *old;  // as in SelfNodes
  double* v;
  ContactCoefficients c;
};
SelfContactPass self_pass(const ContactCoefficients& c, SelfGroups& all);

// The kernels: each goes once over all groups.
struct SelfContactKernel {
  SelfPointsKernel points;
  // Applies the penalties; then the friction of the last step, as far as they allow it. Returns the largest
  // change of a gap's velocity by a penalty, m/s.
  double (*begin)(const SelfContactPass&);
  // Updates damping, stop and friction of each pair, with the impulses of all others fixed. Returns the
  // largest change of a gap's velocity, m/s.
  double (*sweep)(const SelfContactPass&);
  // The energy (J, over ContactCoefficients::impulse) that damping, stops and friction have dissipated, by
  // the velocities `old` and `v`.
  double (*dissipated)(const SelfContactPass&);
  // Adds what the pairs give fixed nodes to `v`.
  void (*push_fixed)(const SelfContactPass&);
};

}  // namespace drape::contact
