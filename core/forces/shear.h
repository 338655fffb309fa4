// Shear: the diagonals of a cell [P section 2, scaled by width; core/README.md, section 3].
//
//      c o---o d        rising a-d, falling b-c:   l = |d - a|,  e = l/(sqrt(2) b) - 1
//        | X |
//      a o---o b        E = w sqrt(2) b G(e), G' = g, w = b phi/sqrt(2);  pull on a = w g(e) (d - a)/l
#pragma once
#include "forces/damping.h"

namespace drape {
namespace {

// The two ends of the diagonals of a row of cells: rising from node i to node i + 1 above, falling from node
// i + 1 to node i above.
struct DiagonalRows {
  ConstRow from[2], to[2];
};
DRAPE_INLINE DiagonalRows diagonals_of(ConstRow row, ConstRow above) {
  return {{row, row.at(1)}, {above.at(1), above}};
}

// Diagonals are `width` (m) times the share of their cell wide. `pull`: two Elastic or Damped, of the rising
// and the falling ones.
template <class L, class Tension, class Pull>
DRAPE_INLINE void shear_cells(int n, const DiagonalRows& rows, double width, const double* share,
                              double diagonal, Tension tension, const Pull (&pull)[2], Row force,
                              Row force_above) {
  const L inverse_rest = 1 / diagonal;
  Vec<L> before[2]{{L(0.0), L(0.0), L(0.0)}, {L(0.0), L(0.0), L(0.0)}};
  links_run<L, 2>(
      n, tension,
      [&](int i, int q) DRAPE_INLINE_LAMBDA {
        return link_between(vec_load<L>(rows.from[q], i), vec_load<L>(rows.to[q], i), inverse_rest);
      },
      [&](int i, const LinkLane<L>* links, auto tension_of) DRAPE_INLINE_LAMBDA {
        const L w = L(width) * L::load(share + i);
        Vec<L> f[2];
        for (int q = 0; q < 2; ++q)
          f[q] = links[q].edge * (links[q].inverse * (w * pull[q](tension_of(q), links[q], i)));
        vec_add(force, i, f[0] + shifted(before[1], f[1]));
        vec_store(force_above, i, vec_load<L>(force_above, i) - (shifted(before[0], f[0]) + f[1]));
        before[0] = f[0];
        before[1] = f[1];
      });
}

}  // namespace
}  // namespace drape
