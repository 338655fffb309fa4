// Seams: pairs of particles on two outlines. Each particle is a point of a cell and moves with the cell's
// nodes. core/README.md, section 6.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape::model {

// r = sum_k weight[k] r(node[k])
struct SeamPoint {
  std::size_t node[4];
  double weight[4];
};

// A weighted sum over nodes that contains each node once, built from the points of a pair.
struct NodeTerm {
  std::uint32_t node;
  int slot;  // of IrregularElements
  double weight;
};
struct NodeSum {
  int count = 0;
  NodeTerm term[16];
  NodeTerm* begin() { return term; }
  NodeTerm* end() { return term + count; }
  const NodeTerm* begin() const { return term; }
  const NodeTerm* end() const { return term + count; }
};

struct SeamPair {
  SeamPoint side[2];
  NodeSum gap;  // r_b - r_a
};

// A hinge p_a - x - p_b across a welded pair. p_a and p_b are points one cell size inside either piece, x is
// the middle of the pair.
struct SeamHinge {
  NodeSum arm[2];            // x - p_a, p_b - x
  double reach[2];           // m, rest lengths of the arms
  double yarn_shares[2][2];  // 1, [side][cos^4, sin^4] of the angle between arm and warp
  double width;              // m
  double stiffness = 0;      // N m; 0 where a side has no bending rigidity
};

// A link along the seam, between the middles of two consecutive welded pairs.
struct SeamLink {
  std::size_t pair[2];
  NodeSum edge;
};

struct Seam {
  std::size_t first = 0, count = 0;            // its pairs and hinges in Seams
  std::size_t link_first = 0, link_count = 0;  // its links in Seams
  int piece[2];
  double length[2], spacing[2];  // m, length l and pair spacing R of both sides
  bool closed = false;           // it is a ring: its end is its start
  int shorter = 0;               // 0 or 1, the shorter side
  double rest = 0;               // m, rest length of its links, the smaller R
  bool along_warp = false;   // the links follow the shorter side's law along the warp; else along the weft
  double link_width = 0;     // m, half a cell on either side
  double closed_at = 0;      // s, time at which closing starts; infinite: only by `close`
  double gap_tolerance = 0;  // m, gap within which a pair is welded
  double speed = 0;          // m/s, closing speed
  double pull_given = 0;     // w of the scene, 1/s; 0 = automatic
  double pull = 0;           // w, 1/s
  double tape = 0;           // N per strain, stiffness of a tape
  bool close = false;        // closing starts now, whatever closed_at
};

struct Seams {
  std::vector<Seam> seam;  // as Scene::seams
  std::vector<SeamPair> pair;
  std::vector<SeamHinge> hinge;  // [pairs]
  std::vector<SeamLink> link;
  double omega2_pull = 0, damping = 0;  // 1/s^2, 1/s, bounds of what the closing forces add to omega^2 and d
  double omega2_welded = 0;             // 1/s^2, bound of what hinges and links add to omega^2
};

// The state of a pair. Part of State.
enum class Sewn : char { kOpen, kPulled, kWelded };

}  // namespace drape::model
