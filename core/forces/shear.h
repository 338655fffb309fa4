// Shear: the diagonals of a cell [P section 2, scaled by width; core/README.md, section 3].
//
//      c o---o d        rising a-d, falling b-c:   l = |d - a|,  e = l/(sqrt(2) b) - 1
//        | X |
//      a o---o b        E = w sqrt(2) b G(e), G' = g, w = b phi/sqrt(2);  pull on a = w g(e) (d - a)/l
#pragma once
#include "forces/damping.h"

namespace drape {
namespace {

template <class L, class Tension, class Pull>
DRAPE_INLINE void shear_diagonals(int n, ConstRow from, ConstRow to, WidthRow width, double diagonal,
                                  Tension tension, Pull pull, Row out) {
  const L inverse_rest = 1 / diagonal;
  links_run<L>(
      n, tension,
      [&](int i) DRAPE_INLINE_LAMBDA {
        return link_between(vec_load<L>(from, i), vec_load<L>(to, i), width_load<L>(width, i), inverse_rest);
      },
      [&](int i, const LinkLane<L>& link, auto tension_at) DRAPE_INLINE_LAMBDA {
        vec_store(out, i, link.edge * (link.inverse * (width_load<L>(width, i) * pull(tension_at, link, i))));
      });
}

// Diagonal i of a row of cells: rising from node i to node i + 1 above, falling from node i + 1 to node i
// above.
template <class L>
DRAPE_INLINE void shear_add(int n, ConstRow rising, ConstRow falling, Row force, Row force_above) {
  for (int i = 0; i < n; i += L::kWidth) {
    vec_add(force, i, vec_load<L>(rising, i) + vec_load<L>(falling, i - 1));
    vec_store(force_above, i,
              vec_load<L>(force_above, i) - (vec_load<L>(rising, i - 1) + vec_load<L>(falling, i)));
  }
}

}  // namespace
}  // namespace drape
