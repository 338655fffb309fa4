// Links in rows: from their ends to their pulls.
//
// A straight law is one product, and a row of links one loop. A table must find the segment of each strain, a
// long way from strain to force; so a few links at a time take it in three short loops, in which the
// processor works on many of them at once.
#pragma once
#include <algorithm>

#include "forces/rows.h"
#include "forces/tension.h"

namespace drape {
namespace {

template <class L>
struct LinkLane {
  Vec<L> edge;  // m
  L inverse;    // 1/length, 1/m
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

// pull(i, links, tension_of) for kFamilies of links, from i = 0 to n - 1: links[q] = make(i, q), which
// tension_of(q) reads the law for.
template <class L, int kFamilies, class Tension, class Make, class Pull>
DRAPE_INLINE void links_run(int n, Tension tension, Make make, Pull pull) {
  LinkLane<L> links[kFamilies];
  if constexpr (!Tension::kTable) {
    for (int i = 0; i < n; i += L::kWidth) {
      for (int q = 0; q < kFamilies; ++q) links[q] = make(i, q);
      pull(i, links, [&](int) DRAPE_INLINE_LAMBDA { return tension; });
    }
  } else {
    LinkBlock block[kFamilies];
    for (int begin = 0; begin < n; begin += kLinkBlock) {
      const int m = std::min(kLinkBlock, n - begin);
      for (LinkBlock& b : block) {
        for (int k = 0; k < m; k += L::kWidth) {
          const LinkLane<L> link = make(begin + k, int(&b - block));
          const L x = Tension::kOdd ? abs(link.strain) : link.strain;
          vec_store(Row{b.x, b.y, b.z}, k, link.edge);
          L::store(b.inverse + k, link.inverse);
          L::store(b.strain + k, link.strain);
          L::store(b.searched + k, x);
          bins_store(*tension.curve, x, b.bin + k);
        }
        for (int k = 0; k < m; ++k) b.segment[k] = segment_find(*tension.curve, b.bin[k], b.searched[k]);
      }
      for (int k = 0; k < m; k += L::kWidth) {
        for (int q = 0; q < kFamilies; ++q) {
          LinkBlock& b = block[q];
          links[q] = {vec_load<L>(Row{b.x, b.y, b.z}, k), L::load(b.inverse + k), L::load(b.strain + k)};
        }
        pull(begin + k, links, [&](int q) DRAPE_INLINE_LAMBDA {
          return SegmentTension<L, Tension::kOdd>{block[q].segment + k};
        });
      }
    }
  }
}

// The link between two nodes. Where both are in one place, as some that are left out by the outline, it has
// no direction: the root of kTiny (m^2), which adds nothing to any other length, keeps its numbers finite.
inline constexpr double kTiny = 1e-200;
template <class L>
DRAPE_INLINE LinkLane<L> link_between(Vec<L> from, Vec<L> to, L inverse_rest) {
  const Vec<L> edge = to - from;
  const L length = sqrt(fma(edge.x, edge.x, fma(edge.y, edge.y, fma(edge.z, edge.z, L(kTiny)))));
  return {edge, L(1.0) / length, fma(length, inverse_rest, L(-1.0))};
}

}  // namespace
}  // namespace drape
