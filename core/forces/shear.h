// Shear: the diagonals of a cell [P section 2, scaled by width; core/README.md, section 3].
//
//      c o---o d        rising a-d, falling b-c:   l = |d - a|,  e = l/(sqrt(2) b) - 1
//        | X |
//      a o---o b        E = w sqrt(2) b G(e), G' = g, w = b phi/sqrt(2);  pull on a = w g(e) (d - a)/l
#pragma once
#include "forces/damping.h"
#include "forces/rows.h"

namespace drape {
namespace {

template <class L, class Tension, class Pull>
DRAPE_INLINE void shear_diagonals(int n, ConstRow from, ConstRow to, WidthRow width, double diagonal,
                                  Tension tension, Pull pull, Row out) {
  const L inverse_rest = 1 / diagonal;
  for (int i = 0; i < n; i += L::kWidth) {
    const Vec<L> edge = vec_load<L>(to, i) - vec_load<L>(from, i);
    const L length = sqrt(dot(edge, edge));
    const L w = width_load<L>(width, i);
    const L inverse = select(gt(w, L(0.0)), L(1.0) / length, L(0.0));
    const L e = fma(length, inverse_rest, L(-1.0));
    vec_store(out, i, edge * (inverse * (w * pull(tension, e, edge, inverse, i))));
  }
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
