// Stretch: links along the threads [P section 2, scaled by width; core/README.md, section 3].
//
//      r0 o-----------o r1      l = |r1 - r0|,  e = l/b - 1
//
//   E = w b P(e), P' = p;   pull on r0 = w p(e) (r1 - r0)/l = -dE/dr0, and its opposite on r1.
#pragma once
#include "forces/damping.h"

namespace drape {
namespace {

// Links from row `from` to row `to`. Directions and 1/l are kept for the hinges. `pull`: Elastic or Damped.
template <class L, class Tension, class Pull>
DRAPE_INLINE void stretch_links(int n, ConstRow from, ConstRow to, WidthRow width, double cell,
                                Tension tension, Pull pull, LinkRow out) {
  const L inverse_rest = 1 / cell;
  links_run<L>(
      n, tension,
      [&](int i) DRAPE_INLINE_LAMBDA {
        return link_between(vec_load<L>(from, i), vec_load<L>(to, i), width_load<L>(width, i), inverse_rest);
      },
      [&](int i, const LinkLane<L>& link, auto tension_at) DRAPE_INLINE_LAMBDA {
        const Vec<L> unit = link.edge * link.inverse;
        vec_store(out.unit, i, unit);
        L::store(out.inverse + i, link.inverse);
        vec_store(out.pull, i, unit * (width_load<L>(width, i) * pull(tension_at, link, i)));
      });
}

// Weft links lie in one row: node i is the first end of link i and the second of link i - 1.
template <class L>
DRAPE_INLINE void stretch_weft_add(int n, ConstRow pull, Row force) {
  for (int i = 0; i < n; i += L::kWidth) vec_add(force, i, vec_load<L>(pull, i) - vec_load<L>(pull, i - 1));
}

// Warp links join two rows.
template <class L>
DRAPE_INLINE void stretch_warp_add(int n, ConstRow pull, Row force, Row force_above) {
  for (int i = 0; i < n; i += L::kWidth) {
    const Vec<L> f = vec_load<L>(pull, i);
    vec_add(force, i, f);
    vec_store(force_above, i, vec_load<L>(force_above, i) - f);
  }
}

}  // namespace
}  // namespace drape
