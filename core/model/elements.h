// Visits the links, hinges and cells of a lattice one by one, irregular elements included. For outputs, the
// energy balance and messages. Widths: core/README.md, section 1.
#pragma once
#include <cmath>
#include <numbers>

#include "model/system.h"

namespace drape::model {

struct Link {
  std::size_t from, to;  // nodes
  double width, rest;    // m
  YarnDirection along;
  bool doubled;  // irregular part of a link that the rows hold too, and that has been visited there
};

inline const math::Curve& law_curve(const fabric::Law& law, YarnDirection along) {
  return along == YarnDirection::kWarp ? law.warp : along == YarnDirection::kWeft ? law.weft : law.bias;
}
inline double law_bending(const fabric::Law& law, bool warp) {
  return warp ? law.bending_warp : law.bending_weft;
}

// l/l_0 - 1
inline double link_strain(const State& s, const Link& link) {
  const double x = s.x[link.to] - s.x[link.from], y = s.y[link.to] - s.y[link.from],
               z = s.z[link.to] - s.z[link.from];
  return std::sqrt(x * x + y * y + z * z) / link.rest - 1;
}

template <class Visit>
void irregular_links_visit(const System& system, const Lattice& l, Visit visit) {
  for (const IrregularLink& s : system.irregular.links)
    if (s.lattice == l.piece) visit(Link{s.node[0], s.node[1], s.width, s.rest, s.along, s.doubled});
}

template <class Visit>
void links_visit(const System& system, const Lattice& l, Visit visit) {
  const double b = l.cell, diagonal = std::numbers::sqrt2 * b;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      const std::size_t n = l.node(i, j), up = n + std::size_t(l.stride);
      const double* here = &system.share[n];
      const double here0 = here[0], left = here[-1], below = here[-l.stride];
      if (below + here0 > 0) visit(Link{n, n + 1, b / 2 * (below + here0), b, YarnDirection::kWeft, false});
      if (left + here0 > 0) visit(Link{n, up, b / 2 * (left + here0), b, YarnDirection::kWarp, false});
      if (here0 > 0) {
        visit(Link{n, up + 1, b * b / diagonal * here0, diagonal, YarnDirection::kBias, false});
        visit(Link{n + 1, up, b * b / diagonal * here0, diagonal, YarnDirection::kBias, false});
      }
    }
  irregular_links_visit(system, l, visit);
}

// visit(n0, n1, n2, warp, share): three nodes along the yarn, and the stiffness kappa = B share.
template <class Visit>
void irregular_hinges_visit(const System& system, const Lattice& l, Visit visit) {
  for (const IrregularHinge& s : system.irregular.hinges)
    if (s.lattice == l.piece) visit(s.node[0], s.node[1], s.node[2], s.warp, s.share);
}

template <class Visit>
void hinges_visit(const System& system, const Lattice& l, Visit visit) {
  const auto row = std::size_t(l.stride);
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      const std::size_t n = l.node(i, j);
      if (system.hinge_weft[n] > 0) visit(n - 1, n, n + 1, false, system.hinge_weft[n]);
      if (system.hinge_warp[n] > 0) visit(n - row, n, n + row, true, system.hinge_warp[n]);
    }
  irregular_hinges_visit(system, l, visit);
}

// visit(corner, share): corners a, b, c, d as size_t[4], and the share phi of the cell that is cloth.
template <class Visit>
void cells_visit(const System& system, const Lattice& l, Visit visit) {
  const auto row = std::size_t(l.stride);
  for (int j = 0; j + 1 < l.rows; ++j)
    for (int i = 0; i + 1 < l.columns; ++i) {
      const std::size_t n = l.node(i, j), corner[4] = {n, n + 1, n + row, n + row + 1};
      if (system.share[n] > 0) visit(corner, system.share[n]);
    }
  for (const IrregularCell& s : system.irregular.cells)
    if (s.lattice == l.piece) visit(s.node, s.share);
}

}  // namespace drape::model
