// Links in rows: from their ends to their pulls.
//
// A straight law is one product, and a row of links one loop. A table must find the segment of each strain, a long
// way from strain to force; so a few links at a time take it in three short loops, in which the processor works
// on many of them at once.
#pragma once
#include <algorithm>

#include "forces/rows.h"
#include "forces/tension.h"

namespace drape {
namespace {

template <class L>
struct LinkLane {
  Vec<L> edge;  // m
  L inverse;    // 1/length, 1/m; 0 where there is no link
  L strain;
};

inline constexpr int kLinkBlock = 32;

// Room for a block of links.
struct LinkBlock {
  alignas(64) double x[kLinkBlock], y[kLinkBlock], z[kLinkBlock], inverse[kLinkBlock], strain[kLinkBlock],
      searched[kLinkBlock];
  alignas(64) int bin[kLinkBlock];
  const double* segment[kLinkBlock];
};

// pull(i, link, tension) for the links make(i) from i = 0 to n - 1.
template <class L, class Tension, class Make, class Pull>
DRAPE_INLINE void links_run(int n, Tension tension, Make make, Pull pull) {
  if constexpr (!Tension::kTable) {
    for (int i = 0; i < n; i += L::kWidth) pull(i, make(i), tension);
  } else {
    LinkBlock block;
    const Row edges{block.x, block.y, block.z};
    for (int begin = 0; begin < n; begin += kLinkBlock) {
      const int m = std::min(kLinkBlock, n - begin);
      for (int k = 0; k < m; k += L::kWidth) {
        const LinkLane<L> link = make(begin + k);
        const L x = Tension::kOdd ? abs(link.strain) : link.strain;
        vec_store(edges, k, link.edge);
        L::store(block.inverse + k, link.inverse);
        L::store(block.strain + k, link.strain);
        L::store(block.searched + k, x);
        bins_store(*tension.curve, x, block.bin + k);
      }
      for (int k = 0; k < m; ++k)
        block.segment[k] = segment_find(*tension.curve, block.bin[k], block.searched[k]);
      for (int k = 0; k < m; k += L::kWidth)
        pull(begin + k,
             LinkLane<L>{vec_load<L>(edges, k), L::load(block.inverse + k), L::load(block.strain + k)},
             SegmentTension<L, Tension::kOdd>{block.segment + k});
    }
  }
}

// The link between two nodes; none where the width w is 0.
template <class L>
DRAPE_INLINE LinkLane<L> link_between(Vec<L> from, Vec<L> to, L width, L inverse_rest) {
  const Vec<L> edge = to - from;
  const L length = sqrt(dot(edge, edge));
  return {edge, select(gt(width, L(0.0)), L(1.0) / length, L(0.0)), fma(length, inverse_rest, L(-1.0))};
}

}  // namespace
}  // namespace drape
