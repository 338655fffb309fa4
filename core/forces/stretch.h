// Stretch: links along the threads [P section 2, scaled by width; core/README.md, section 3].
//
//      r0 o-----------o r1      l = |r1 - r0|,  e = l/b - 1
//
//   E = w b P(e), P' = p;   pull on r0 = w p(e) (r1 - r0)/l = -dE/dr0, and its opposite on r1.
#pragma once
#include "forces/damping.h"

namespace drape {
namespace {

// Links from row `from` to row `to`: add(i, f), in the order of i, with what link i pulls with on its first
// end. `pull`: Elastic or Damped. Directions and 1/l are kept for hinges, where `out` has room.
template <class L, class Tension, class Pull, class Add>
DRAPE_INLINE void stretch_links(int n, ConstRow from, ConstRow to, WidthRow width, double cell,
                                Tension tension, Pull pull, const LinkRow* out, Add add) {
  const L inverse_rest = 1 / cell;
  links_run<L, 1>(
      n, tension,
      [&](int i, int) DRAPE_INLINE_LAMBDA {
        return link_between(vec_load<L>(from, i), vec_load<L>(to, i), inverse_rest);
      },
      [&](int i, const LinkLane<L>* links, auto tension_of) DRAPE_INLINE_LAMBDA {
        const LinkLane<L>& link = links[0];
        if (out) {
          vec_store(out->unit, i, link.edge * link.inverse);
          L::store(out->inverse + i, link.inverse);
        }
        add(i, link.edge * (link.inverse * (width_load<L>(width, i) * pull(tension_of(0), link, i))));
      });
}

// Weft links lie in one row: node i is the first end of link i and the second of link i - 1.
template <class L, class Tension, class Pull>
DRAPE_INLINE void stretch_weft(int n, ConstRow row, WidthRow width, double cell, Tension tension, Pull pull,
                               const LinkRow* out, Row force) {
  Vec<L> before{L(0.0), L(0.0), L(0.0)};
  stretch_links<L>(n, row, row.at(1), width, cell, tension, pull, out,
                   [&](int i, Vec<L> f) DRAPE_INLINE_LAMBDA {
                     vec_add(force, i, f - shifted(before, f));
                     before = f;
                   });
}

// Warp links join two rows, and are the first that pull at the row above.
template <class L, class Tension, class Pull>
DRAPE_INLINE void stretch_warp(int n, ConstRow row, ConstRow above, WidthRow width, double cell,
                               Tension tension, Pull pull, const LinkRow* out, Row force, Row force_above) {
  stretch_links<L>(n, row, above, width, cell, tension, pull, out, [&](int i, Vec<L> f) DRAPE_INLINE_LAMBDA {
    vec_add(force, i, f);
    vec_store(force_above, i, Vec<L>{L(0.0), L(0.0), L(0.0)} - f);
  });
}

}  // namespace
}  // namespace drape
