// An upper bound of omega^2 of a cell with its share of the mass (Irons): core/README.md, section 4.
//
//      c o--top--o d         {4 (1 + cosine) max(k - t, 0) + 8 t + 8 max(k_d, t_d) + beta} / (rho b^2)
//        |  \ /  |
//      left X right          A link has the stiffness k along itself and t across: (k - t) n n^T + t I. The
//        |  / \  |           cell has halves of four links and two whole diagonals between four quarter
//        masses.
//      a o-bottom-o b        Warp and weft that are not normal share (1 + cosine) of their stiffness along a
//      line.
#pragma once
#include "dynamics/kernel/kernel.h"
#include "forces/shear.h"
#include "forces/tension.h"
#include "simd/vector_lanes.h"

namespace drape::dynamics {
namespace {

// What the links of one direction add to the bound of a cell.
template <class L>
struct LinkBound {
  L along;     // max(k - t, 0), N/m
  L across;    // t = max(0, b p/l), N/m
  L shortest;  // m
};

template <class L, class Tension>
DRAPE_INLINE LinkBound<L> link_bound(L length, L inverse_rest, Tension tension) {
  const L e = fma(length, inverse_rest, L(-1.0));
  const L across = max(tension(e) / (length * inverse_rest), L(0.0));
  return {max(tension.slope(e) - across, L(0.0)), across, length};
}

template <class L>
DRAPE_INLINE LinkBound<L> link_bound_max(LinkBound<L> a, LinkBound<L> b) {
  return {max(a.along, b.along), max(a.across, b.across), min(a.shortest, b.shortest)};
}

// rho b^2 omega^2 of the four edges of a cell and their hinges: everything but its diagonals, N/m.
template <class L>
DRAPE_INLINE L edges_bound(simd::Vec<L> a, simd::Vec<L> b, simd::Vec<L> c, simd::Vec<L> d,
                           const model::Lattice& l) {
  const simd::Vec<L> bottom = b - a, top = d - c, left = c - a, right = d - b;
  const L lb = sqrt(dot(bottom, bottom)), lt = sqrt(dot(top, top)), ll = sqrt(dot(left, left)),
          lr = sqrt(dot(right, right));
  const L inverse_rest = 1 / l.cell;
  const forces::CurveTension warp{&l.law.warp}, weft{&l.law.weft};
  const auto f = link_bound_max(link_bound(lb, inverse_rest, weft), link_bound(lt, inverse_rest, weft));
  const auto w = link_bound_max(link_bound(ll, inverse_rest, warp), link_bound(lr, inverse_rest, warp));
  const L cosine = max(max(abs(dot(bottom, left) / (lb * ll)), abs(dot(bottom, right) / (lb * lr))),
                       max(abs(dot(top, left) / (lt * ll)), abs(dot(top, right) / (lt * lr))));
  const L beta = L(16 * l.law.bending_warp) / (w.shortest * w.shortest) +
                 L(16 * l.law.bending_weft) / (f.shortest * f.shortest);
  return L(4.0) * (L(1.0) + cosine) * max(w.along, f.along) + L(8.0) * max(w.across, f.across) + beta;
}

// 8 max(k_d, t_d) with k_d = g'/2 and t_d = b g/(sqrt(2) l) = g/(2 l/l0), N/m
template <class L>
DRAPE_INLINE L diagonal_bound(simd::Vec<L> from, simd::Vec<L> to, L inverse_rest, const math::Curve& curve) {
  const simd::Vec<L> edge = to - from;
  const L ratio = sqrt(dot(edge, edge)) * inverse_rest;
  const forces::CurveTension bias{&curve};
  const L e = ratio - L(1.0);
  return L(4.0) * max(bias.slope(e), max(bias(e) / ratio, L(0.0)));
}

// The corners a, b, c, d of cells.
template <class L>
struct CellCorners {
  simd::Vec<L> a, b, c, d;
};

// rho b^2 omega^2 of a cell, N/m.
template <class L>
DRAPE_INLINE L cell_bound(const CellCorners<L>& at, const model::Lattice& l) {
  const L edges = edges_bound(at.a, at.b, at.c, at.d, l);
  if (!l.law.bias.segments) return edges;
  const L inverse_diagonal = 1 / forces::shear_rest(l.cell);
  return edges + max(diagonal_bound(at.a, at.d, inverse_diagonal, l.law.bias),
                     diagonal_bound(at.b, at.c, inverse_diagonal, l.law.bias));
}

// The row of cells above row j of a lattice: their shares, and the nodes of row j.
struct CellRow {
  const double* share;
  simd::ConstRow r, v;
  int stride;
};
inline CellRow cell_row(const System& system, const model::Lattice& l, const State& s, int j) {
  const std::size_t first = l.node(0, j);
  return {system.share.data() + first,
          {s.x.data() + first, s.y.data() + first, s.z.data() + first},
          {s.vx.data() + first, s.vy.data() + first, s.vz.data() + first},
          l.stride};
}

// r + ahead v
template <class L>
DRAPE_INLINE simd::Vec<L> corner_ahead(const CellRow& row, long i, L ahead) {
  const simd::Vec<L> at = simd::vec_load<L>(row.r, i), speed = simd::vec_load<L>(row.v, i);
  return {fma(ahead, speed.x, at.x), fma(ahead, speed.y, at.y), fma(ahead, speed.z, at.z)};
}
template <class L>
DRAPE_INLINE CellCorners<L> corners_ahead(const CellRow& row, long i, L ahead) {
  const long up = i + row.stride;
  return {corner_ahead<L>(row, i, ahead), corner_ahead<L>(row, i + 1, ahead), corner_ahead<L>(row, up, ahead),
          corner_ahead<L>(row, up + 1, ahead)};
}

template <class L>
double cells_omega2(const System& system, const model::Lattice& l, const State& s, int j, double ahead) {
  const CellRow row = cell_row(system, l, s, j);
  alignas(math::kLine) double worst[L::kWidth] = {};
  for (int i = 0; i < l.stride; i += L::kWidth) {
    const L bound = cell_bound(corners_ahead<L>(row, i, ahead), l);
    const L present = select(gt(L::load(row.share + i), L(0.0)), bound, L(0.0));
    L::store(worst, max(present, L::load(worst)));
  }
  double largest = 0;
  for (double w : worst) largest = w > largest ? w : largest;
  return largest / (l.law.areal_density * l.cell * l.cell);
}

}  // namespace
}  // namespace drape::dynamics
