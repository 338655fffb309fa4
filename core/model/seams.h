// What a system knows of its seams: pairs of particles on two outlines, each tied to the nodes of its cell.
// core/README.md, section 6.
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

// A sum over nodes, each once: of the points of a pair.
struct NodeTerm {
  std::uint32_t node;
  int slot;  // in Side
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

// Across a welded pair: p_a - x - p_b, each p a cell's edge inside its piece, x the middle of the pair.
struct SeamHinge {
  NodeSum arm[2];            // x - p_a, p_b - x
  double reach[2];           // m: their lengths at rest
  double yarn_shares[2][2];  // of side k: cos^4 between arm and warp, sin^4
  double width;              // m
  double stiffness = 0;      // N m; 0 where a side does not bend
};

// Along the seam, between the middles of two welded pairs that follow each other.
struct SeamLink {
  std::size_t pair[2];
  NodeSum edge;
};

struct Seam {
  std::size_t first = 0, count = 0;  // its pairs and hinges
  std::size_t link_first = 0, link_count = 0;
  int piece[2];
  double length[2], spacing[2];  // m: l and R of both sides
  bool closed = false;           // it comes back to its start
  int shorter = 0;               // side
  double rest = 0;               // m: of its links, the smaller R
  bool along_warp = false;       // their law: of the shorter side
  double link_width = 0;         // m: half a cell on either side
  double closed_at = 0;          // s
  double gap_tolerance = 0;      // m
  double speed = 0;              // m/s
  double pull_given = 0;         // w, 1/s; 0 = automatic
  double pull = 0;               // w, 1/s
  double tape = 0;               // N per strain
  bool close = false;            // pulling starts now
};

struct Seams {
  std::vector<Seam> seam;  // as Scene::seams
  std::vector<SeamPair> pair;
  std::vector<SeamHinge> hinge;  // [pairs]
  std::vector<SeamLink> link;
  double omega2_pull = 0, damping = 0;  // 1/s^2, 1/s: what the pulls add to omega^2 and d, at most
  double omega2_welded = 0;             // 1/s^2: what hinges and links add, at most
};

// Of a pair; part of the State.
enum class Sewn : char { kOpen, kPulled, kWelded };

}  // namespace drape::model
