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

// r + ahead v
template <class L>
DRAPE_INLINE simd::Vec<L> corner_ahead(simd::ConstRow r, simd::ConstRow v, long i, L ahead) {
  const simd::Vec<L> at = simd::vec_load<L>(r, i), speed = simd::vec_load<L>(v, i);
  return {fma(ahead, speed.x, at.x), fma(ahead, speed.y, at.y), fma(ahead, speed.z, at.z)};
}

template <class L>
double cells_omega2(const System& system, const model::Lattice& l, const State& s, int j, double ahead) {
  const std::size_t first = l.node(0, j);
  const double* share = system.share.data() + first;
  const simd::ConstRow r{s.x.data() + first, s.y.data() + first, s.z.data() + first};
  const simd::ConstRow v{s.vx.data() + first, s.vy.data() + first, s.vz.data() + first};
  const L inverse_diagonal = 1 / (__builtin_sqrt(2.0) * l.cell);
  alignas(math::kLine) double worst[L::kWidth] = {};
  for (int i = 0; i < l.stride; i += L::kWidth) {
    const long up = i + l.stride;
    const auto a = corner_ahead<L>(r, v, i, ahead), b = corner_ahead<L>(r, v, i + 1, ahead),
               c = corner_ahead<L>(r, v, up, ahead), d = corner_ahead<L>(r, v, up + 1, ahead);
    L bound = edges_bound(a, b, c, d, l);
    if (l.law.bias.segments)
      bound = bound + max(diagonal_bound(a, d, inverse_diagonal, l.law.bias),
                          diagonal_bound(b, c, inverse_diagonal, l.law.bias));
    const L present = select(gt(L::load(share + i), L(0.0)), bound, L(0.0));
    L::store(worst, max(present, L::load(worst)));
  }
  double largest = 0;
  for (double w : worst) largest = w > largest ? w : largest;
  return largest / (l.law.areal_density * l.cell * l.cell);
}

}  // namespace
}  // namespace drape::dynamics
