// What a piece has beside the rows of its lattice: short lists of links, hinges and cells that the outline
// has split, and of the hinges at clamps. A scene without them pays nothing.
//
// Their forces are added up in *slots*, one for each node that they touch: first the twins of a lattice,
// padded to whole registers, then the nodes of its rows in order, so that the lattice pass can pick them up
// row by row.
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
  bool doubled;        // the rows have a link between the same nodes
};

struct IrregularHinge {
  std::size_t node[3];  // along the thread
  int slot[3];
  int lattice;
  bool warp;
  double share;  // kappa over B
};

struct IrregularCell {
  std::size_t node[4];  // corners a, b, c, d
  int slot[4];
  int lattice;
  double share;  // phi
};

// A hinge between the turned direction of a clamped link and the link: core/README.md, section 4.
struct ClampHinge {
  std::size_t node[2];  // held, free
  int slot[2];
  int lattice, pin;
  bool warp;
  double share;    // kappa_c over B
  Vec3 direction;  // D
  double excess;   // of the link's hinges over those of a link of the cloth, in the step limit
};

struct IrregularElements {
  std::vector<IrregularLink> links;
  std::vector<IrregularHinge> hinges;
  std::vector<IrregularCell> cells;
  std::vector<ClampHinge> clamps;
  std::vector<std::size_t> node;  // [slots]
};

// Where a pass may write the forces of Side: [slots] N.
struct SlotForces {
  double *x, *y, *z;
};

}  // namespace drape::model
