// The links of a lattice one by one, for outputs: widths as core/README.md, section 1.
#pragma once
#include <cmath>

#include "system/system.h"

namespace drape {

struct Link {
  std::size_t from, to;  // nodes
  double width, rest;    // m
  const Curve* law;      // of the lattice: warp, weft or bias
};

inline double link_strain(const State& s, const Link& link) {
  const double x = s.x[link.to] - s.x[link.from], y = s.y[link.to] - s.y[link.from],
               z = s.z[link.to] - s.z[link.from];
  return std::sqrt(x * x + y * y + z * z) / link.rest - 1;
}

template <class Visit>
void each_link(const System& system, const Lattice& l, Visit visit) {
  const double b = l.cell, diagonal = std::sqrt(2.0) * b;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      const std::size_t n = l.node(i, j), up = n + std::size_t(l.stride);
      const double* here = &system.share[n];
      const double here0 = here[0], left = here[-1], below = here[-l.stride];
      if (below + here0 > 0) visit(Link{n, n + 1, b / 2 * (below + here0), b, &l.law.weft});
      if (left + here0 > 0) visit(Link{n, up, b / 2 * (left + here0), b, &l.law.warp});
      if (here0 > 0) {
        visit(Link{n, up + 1, b * b / diagonal * here0, diagonal, &l.law.bias});
        visit(Link{n + 1, up, b * b / diagonal * here0, diagonal, &l.law.bias});
      }
    }
}

}  // namespace drape
