// Shear: the diagonals of a cell [P section 2, scaled by width; core/README.md, section 3].
//
//      c o---o d        rising a-d, falling b-c:   l = |d - a|,  e = l/(sqrt(2) b) - 1
//        | X |
//      a o---o b        E = w sqrt(2) b G(e), G' = g, w = b phi/sqrt(2);  pull on a = w g(e) (d - a)/l
#pragma once
#include "simd/vector_lanes.h"

namespace drape::forces {
namespace {

DRAPE_INLINE double shear_rest(double cell) { return __builtin_sqrt(2.0) * cell; }

template <class L>
DRAPE_INLINE void shear_edges(L a, L b, L c, L d, L* rising_falling) {
  rising_falling[0] = d - a;
  rising_falling[1] = c - b;
}

DRAPE_INLINE double shear_width(double cell) { return cell * cell / shear_rest(cell); }

}  // namespace
}  // namespace drape::forces
