// What a system knows of its seams: pairs of particles on two outlines, each tied to the nodes of its cell.
// core/README.md, section 5.
#pragma once
#include <cstddef>
#include <vector>

namespace drape {

// r = sum_k weight[k] r(node[k])
struct SeamPoint {
  std::size_t node[4];
  double weight[4];
};

struct SeamPair {
  SeamPoint side[2];
  // Their gap r_b - r_a = sum_k weight[k] r(node[k]), each node once.
  int count = 0;
  std::size_t node[8];
  int slot[8];  // in Side
  double weight[8];
};

struct Seam {
  int first = 0, count = 0;      // its pairs
  double length[2], spacing[2];  // m: l and R of both sides
  double closed_at = 0;          // s
  double gap_tolerance = 0;      // m
  double speed = 0;              // m/s
  double pull_given = 0;         // w, 1/s; 0 = automatic
  double pull = 0;               // w, 1/s
  bool close = false;            // pulling starts now
};

struct Seams {
  std::vector<Seam> seam;  // as Scene::seams
  std::vector<SeamPair> pair;
  double omega2 = 0;   // 1/s^2, of the pull, at most
  double damping = 0;  // 1/s, d of the pull, at most
};

// Of a pair; part of the State.
enum class Sewn : char { kOpen, kPulled, kWelded };

}  // namespace drape
