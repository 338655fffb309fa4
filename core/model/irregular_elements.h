// Irregular elements: links, hinges and cells that the outline has split, and hinges at clamps. They are
// short lists next to the regular rows of a lattice. A scene without them has no cost from them.
//
// Their forces are summed in *slots*, one for each node that an irregular element or a seam uses. The slots
// of a lattice begin with its twins, padded to whole registers; the nodes of its rows follow in order. So the
// pass over the lattice reads the sums row by row.
#pragma once
#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace drape::model {

enum class YarnDirection { kWarp, kWeft, kBias };

struct IrregularLink {
  std::size_t node[2];
  int slot[2];
  int lattice;
  YarnDirection along;
  double width, rest;  // m
  bool doubled;        // the rows hold a link between the same nodes
};

struct IrregularHinge {
  std::size_t node[3];  // along the yarn
  int slot[3];
  int lattice;
  bool warp;
  double share;  // 1, kappa over B
};

struct IrregularCell {
  std::size_t node[4];  // corners a, b, c, d
  int slot[4];
  int lattice;
  double share;  // 1, phi
};

// A hinge between the direction that a clamp prescribes for a link, and the link: core/README.md, section 4.
struct ClampHinge {
  std::size_t node[2];  // held, free
  int slot[2];
  int lattice, pin;
  bool warp;
  double share;    // 1, kappa_c over B
  Vec3 direction;  // 1, unit vector D of the link at the start; now R D with the pin's rotation R
  double excess;   // 1, for the step limit: weight of the link's hinges beyond that of a regular link
};

struct IrregularElements {
  std::vector<IrregularLink> links;
  std::vector<IrregularHinge> hinges;
  std::vector<IrregularCell> cells;
  std::vector<ClampHinge> clamps;
  std::vector<std::size_t> node;  // [slots] the node of each slot
};

// Where a pass adds the forces of irregular elements and seams: [slots] N.
struct SlotForces {
  double *x, *y, *z;
};

}  // namespace drape::model
