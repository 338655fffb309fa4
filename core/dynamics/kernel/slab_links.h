// All links of slab j in one loop: those that begin at the nodes of row j.
//
//     row j+1   c o---o d      weft a-b, warp a-c, rising a-d, falling b-c
//                 | X |        Their forces are added to row j, and start the sums of row j + 1.
//     row j     a o---o b
#pragma once
#include "forces/damping.h"
#include "forces/link_rows.h"
#include "forces/shear.h"
#include "forces/stretch.h"
#include "model/system.h"

namespace drape::dynamics {
namespace {

enum Family { kWeft, kWarp, kRising, kFalling };

// Input of a slab: within its reach, rows j and j + 1 of positions and, with rates, of velocities; and data
// of the nodes of row j.
struct SlabRows {
  model::Columns reach;
  simd::ConstRow here, above, speed, speed_above;
  const double *share, *share_below, *hinge_warp, *hinge_weft;
};

// One coordinate of the edges of the links from node i on, of positions or velocities of row j and the row
// above. No link begins at the last node of the reach, so nothing beyond it is read.
template <class L, int kFamilies>
DRAPE_INLINE void slab_edges(const double* here, const double* above, int end, int i, L* edge) {
  const int beyond = simd::lane_after<L>(i, end);
  const L a = kept(L::load(here + i)), b = ahead(a, L::load(here + beyond)), c = kept(L::load(above + i));
  forces::stretch_edges(a, b, c, edge);
  if constexpr (kFamilies == 4)
    forces::shear_edges(a, b, c, ahead(c, L::load(above + beyond)), edge + kRising);
}

template <class Tension>
DRAPE_INLINE Tension tension_of(const math::Curve& curve) {
  if constexpr (Tension::kTable) return {&curve};
  else return {curve.segment[0].c1};
}

// The pipeline stages of the links of a slab (forces/link_rows.h).
template <class L, class Tension, int kFamilies, bool kDamped>
struct SlabStages {
  static constexpr bool kShear = kFamilies == 4;
  static constexpr int kRated = kDamped ? kFamilies : 1;
  struct Ends {
    L square[kFamilies], along[kRated];  // along: (u1 - u0).(r1 - r0), m^2/s
  };
  struct Lengths {
    forces::LinkLane<L> link[kFamilies];
    L along[kRated];
  };
  struct Pulls {
    L scale[kFamilies], inverse[2];
  };

  const SlabRows in;
  const double damping;
  const Tension weft, warp, bias;
  const L inverse_rest, inverse_diagonal, width, width_diagonal;  // widths of links of share 1
  L share_before = 0.0;

  DRAPE_INLINE SlabStages(const model::Lattice& l, const SlabRows& rows)
      : in(rows),
        damping(l.law.damping),
        weft(tension_of<Tension>(l.law.weft)),
        warp(tension_of<Tension>(l.law.warp)),
        bias(tension_of<Tension>(l.law.bias)),
        inverse_rest(1 / l.cell),
        inverse_diagonal(1 / forces::shear_rest(l.cell)),
        width(forces::stretch_width(l.cell)),
        width_diagonal(forces::shear_width(l.cell)) {}

  DRAPE_INLINE Tension tension(int q) const { return q == kWeft ? weft : q == kWarp ? warp : bias; }
  DRAPE_INLINE Ends ends(int i) {
    Ends to;
    for (int k = 2; k >= 0; --k) {
      L edge[kFamilies], speed[kFamilies];
      slab_edges<L, kFamilies>(simd::coordinate(in.here, k), simd::coordinate(in.above, k), in.reach.end, i,
                               edge);
      for (int q = 0; q < kFamilies; ++q)
        to.square[q] = fma(edge[q], edge[q], k == 2 ? L(forces::kTiny) : to.square[q]);
      if constexpr (kDamped) {
        slab_edges<L, kFamilies>(simd::coordinate(in.speed, k), simd::coordinate(in.speed_above, k),
                                 in.reach.end, i, speed);
        for (int q = 0; q < kFamilies; ++q)
          to.along[q] = k == 2 ? speed[q] * edge[q] : fma(speed[q], edge[q], to.along[q]);
      }
    }
    return to;
  }
  DRAPE_INLINE Lengths lengths(const Ends& from) const {
    Lengths to;
    forces::links_measure(from.square, inverse_rest, to.link);
    if constexpr (kShear) forces::links_measure(from.square + kRising, inverse_diagonal, to.link + kRising);
    for (int q = 0; q < kRated; ++q) to.along[q] = from.along[q];
    return to;
  }
  DRAPE_INLINE Pulls pulls(int i, const Lengths& from) {
    const L share = L::load(in.share + i);
    const L below = L::load(in.share_below + i), left = shifted(share_before, share);
    const L w[4] = {width * (below + share), width * (left + share), width_diagonal * share,
                    width_diagonal * share};
    share_before = share;
    Pulls to;
    for (int q = 0; q < kFamilies; ++q) {
      const forces::LinkLane<L>& link = from.link[q];
      // Nodes outside the outline stay behind a cloth that moves; the strains of their links would be far
      // beyond the tables.
      const L strain = Tension::kTable ? select(gt(w[q], L(0.0)), link.strain, L(0.0)) : link.strain;
      L tense;
      if constexpr (kDamped) {
        const L rate = from.along[q] * (link.inverse * (q < kRising ? inverse_rest : inverse_diagonal));
        tense = forces::damped_tension(tension(q), strain, rate, damping);
      } else {
        tense = tension(q)(strain);
      }
      to.scale[q] = link.inverse * (w[q] * tense);
    }
    for (int q : {kWeft, kWarp}) to.inverse[q] = from.link[q].inverse;
    return to;
  }
};

// `force` holds minus the sums of row j so far. The sink receives the complete sums, and `force_above` minus
// those of row j + 1. inverse_weft and inverse_warp receive 1/l of the links along the yarns, for hinges; or
// null.
template <class L, class Tension, int kFamilies, bool kDamped, class Sink>
DRAPE_INLINE void slab_links(const model::Lattice& l, const SlabRows& in, simd::PackedRow force,
                             simd::PackedRow force_above, double* inverse_weft, double* inverse_warp,
                             Sink sink) {
  using Stages = SlabStages<L, Tension, kFamilies, kDamped>;
  Stages stages(l, in);
  L right_before[3] = {0.0, 0.0, 0.0}, rising_before[3] = {0.0, 0.0, 0.0};

  // Forces at node a: weft, warp and rising. At b, one further: falling less weft. At c: warp and falling. At
  // d, one further: rising.
  const auto add = [&](int i, const typename Stages::Pulls& pulls) DRAPE_INLINE_LAMBDA {
    sink.begin(i);
    for (int k = 0; k < 3; ++k) {
      L edge[kFamilies], f[4];
      slab_edges<L, kFamilies>(simd::coordinate(in.here, k), simd::coordinate(in.above, k), in.reach.end, i,
                               edge);
      for (int q = 0; q < kFamilies; ++q) f[q] = edge[q] * pulls.scale[q];
      L here = f[kWeft] + f[kWarp], right = L(0.0) - f[kWeft], up = f[kWarp];
      if constexpr (kFamilies == 4) {
        here = here + f[kRising];
        right = f[kFalling] - f[kWeft];
        up = (up + f[kFalling]) + shifted(rising_before[k], f[kRising]);
        rising_before[k] = f[kRising];
      }
      sink.put(i, k, (here + shifted(right_before[k], right)) - L::load(force.at<L>(i, k)));
      L::store(force_above.at<L>(i, k), up);
      right_before[k] = right;
    }
    if (inverse_weft) {
      L::store(inverse_weft + i, pulls.inverse[kWeft]);
      L::store(inverse_warp + i, pulls.inverse[kWarp]);
    }
  };

  constexpr int kWidth = L::kWidth;
  typename Stages::Ends ends{};
  typename Stages::Pulls pulls{};
  typename Stages::Lengths lengths{};
  constexpr int kLate = Tension::kTable ? 3 * kWidth : 2 * kWidth;
  const int begin = in.reach.begin, end = in.reach.end;
  for (int i = begin; i < end + kLate; i += kWidth) {
    const typename Stages::Pulls ready = pulls;
    if constexpr (Tension::kTable) {
      if (i >= begin + 2 * kWidth && i < end + 2 * kWidth) pulls = stages.pulls(i - 2 * kWidth, lengths);
      if (i >= begin + kWidth && i < end + kWidth) lengths = stages.lengths(ends);
    } else {
      if (i >= begin + kWidth && i < end + kWidth) pulls = stages.pulls(i - kWidth, stages.lengths(ends));
    }
    if (i < end) ends = stages.ends(i);
    if (i >= begin + kLate) add(i - kLate, ready);
  }
}

}  // namespace
}  // namespace drape::dynamics
