// What a step errs in the energy of a cell's links. core/README.md, section 4, "Step".
//
// The kicks at both ends of a drift that takes the strain of a link from e0 to e1, by d, do the work
// d [p(e0) + p(e1)]/2 per width and length. The energy of the link grows by the integral of p, and the
// trapezoid rule errs by
//
//      d^2 [p'(e1) - p'(e0)]/12
//
// Where the slope changes little within a step, these errors cancel over time. Where it changes much, they do
// not: their sum feeds energy into the cloth. The stiffness p' n n^T of the link changes by at most
// |p'(e1) - p'(e0)| + p'(e1) |n1 - n0|, and omega^2 of its cell by 4/(rho b^2) times that (cell_bound.h).
#pragma once
#include <algorithm>

#include "dynamics/kernel/kernel.h"
#include "dynamics/step_size/cell_bound.h"
#include "simd/place_sums.h"

namespace drape::dynamics {
namespace {

// Of links: sum of d^2 |p'(e1) - p'(e0)|, largest change of stiffness; N/m.
template <class L>
struct LinkDefect {
  L sum, change;
};

// Of a link along `now`, which was `before`.
template <class L>
DRAPE_INLINE LinkDefect<L> link_defect(simd::Vec<L> before, simd::Vec<L> now, L inverse_rest,
                                       const math::Curve& curve) {
  const forces::CurveTension tension{&curve};
  const L l0 = sqrt(dot(before, before)), l1 = sqrt(dot(now, now));
  const L e0 = fma(l0, inverse_rest, L(-1.0)), e1 = fma(l1, inverse_rest, L(-1.0)), d = e1 - e0;
  const L slope = tension.slope(e1), change = abs(slope - tension.slope(e0));
  const simd::Vec<L> turn = now * (L(1.0) / l1) - before * (L(1.0) / l0);
  return {d * d * change, change + slope * sqrt(dot(turn, turn))};
}

template <class L>
DRAPE_INLINE LinkDefect<L> link_defects_join(const LinkDefect<L>& a, const LinkDefect<L>& b) {
  return {a.sum + b.sum, max(a.change, b.change)};
}

// Of the weft and warp links at the first corner of a cell, and of its diagonals.
template <class L>
DRAPE_INLINE LinkDefect<L> cell_defect(const CellCorners<L>& before, const CellCorners<L>& now,
                                       const model::Lattice& l) {
  const L inverse_rest = 1 / l.cell, inverse_diagonal = 1 / forces::shear_rest(l.cell);
  const LinkDefect<L> yarns =
      link_defects_join(link_defect(before.b - before.a, now.b - now.a, inverse_rest, l.law.weft),
                        link_defect(before.c - before.a, now.c - now.a, inverse_rest, l.law.warp));
  if (!l.law.bias.segments) return yarns;
  return link_defects_join(
      yarns,
      link_defects_join(link_defect(before.d - before.a, now.d - now.a, inverse_diagonal, l.law.bias),
                        link_defect(before.c - before.b, now.c - now.b, inverse_diagonal, l.law.bias)));
}

// Width times length of a link, over 12: of a link along a yarn b b, of a diagonal (b/sqrt(2)) sqrt(2) b.
DRAPE_INLINE double defect_unit(const model::Lattice& l) { return l.cell * l.cell / 12; }

// From the change of a slope to that of omega^2, m/(N s^2).
DRAPE_INLINE double defect_change(const model::Lattice& l) {
  return 4 / (l.mass_kept * l.law.areal_density * l.cell * l.cell);
}

template <class L>
StepDefect cells_defect(const System& system, const model::Lattice& l, const State& s, int j, double step) {
  const CellRow row = cell_row(system, l, s, j);
  simd::PlaceSums sums;
  alignas(math::kLine) double changes[math::kRowUnit] = {};
  for (int i = 0; i < l.stride; i += L::kWidth) {
    const LinkDefect<L> defect =
        cell_defect(corners_ahead<L>(row, i, -step), corners_ahead<L>(row, i, 0.0), l);
    const L weight = L::load(row.share + i);
    const auto present = gt(weight, L(0.0));
    sums.add(i, select(present, weight * defect.sum, L(0.0)));
    double* const change = changes + i % math::kRowUnit;
    L::store(change, max(select(present, defect.change, L(0.0)), L::load(change)));
  }
  StepDefect all;
  for (double one : sums.at) all.energy += defect_unit(l) * one;
  for (double one : changes) all.omega2 = std::max(all.omega2, defect_change(l) * one);
  return all;
}

}  // namespace
}  // namespace drape::dynamics
