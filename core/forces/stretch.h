// Stretch: links along the yarns [P section 2, scaled by width; core/README.md, section 3].
//
//      c o            l = |r1 - r0|,  e = l/b - 1
//        |
//      a o---o b      E = w b P(e), P' = p;   pull on a = w p(e) (r1 - r0)/l = -dE/da, and its opposite on r1
#pragma once
#include "simd/vector_lanes.h"

namespace drape::forces {
namespace {

// One coordinate of the links that begin at node a: along the weft to b, along the warp to c.
template <class L>
DRAPE_INLINE void stretch_edges(L a, L b, L c, L* weft_warp) {
  weft_warp[0] = b - a;
  weft_warp[1] = c - a;
}

// Each whole cell next to a link adds half a cell to its width.
DRAPE_INLINE double stretch_width(double cell) { return cell / 2; }

}  // namespace
}  // namespace drape::forces
