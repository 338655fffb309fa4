// The elastic energy of the links that begin at the nodes of a row, and of the hinges centred on it.
//
//     row j+1   c o---o d      weft a-b, warp a-c, rising a-d, falling b-c: width times length times the
//                 | X |        integral of the curve up to the strain
//     row j     a o---o b      hinges: kappa theta^2/2 from theta = psi sin theta
#pragma once
#include "dynamics/step_size/cell_bound.h"
#include "forces/bending.h"
#include "forces/stretch.h"
#include "simd/place_sums.h"

namespace drape::dynamics {
namespace {

// Per width and length of a link, N/m. 0 where there is no link: nodes outside the outline stay behind.
template <class L>
DRAPE_INLINE L link_energy(simd::Vec<L> edge, L inverse_rest, const math::Curve& curve, L width) {
  const L strain = fma(sqrt(dot(edge, edge)), inverse_rest, L(-1.0));
  const auto present = gt(width, L(0.0));
  return select(present, forces::CurveTension{&curve}.energy(select(present, strain, L(0.0))), L(0.0));
}

// kappa theta^2/2 of the hinge between two edges.
template <class L>
DRAPE_INLINE L hinge_energy(simd::Vec<L> a, simd::Vec<L> c, L kappa) {
  const simd::Vec<L> u = a * (L(1.0) / sqrt(dot(a, a))), v = c * (L(1.0) / sqrt(dot(c, c)));
  const auto present = gt(kappa, L(0.0));
  const simd::Vec<L> n = cross(u, v);
  const L cosine = select(present, dot(u, v), L(1.0)), sine2 = select(present, dot(n, n), L(0.0));
  return kappa * forces::bending_energy(cosine, sine2);
}

template <class L>
RowEnergy row_energy(const System& system, const model::Lattice& l, const State& s, int j) {
  const CellRow row = cell_row(system, l, s, j);
  const double *const hinge_warp = system.hinge_warp.data() + l.node(0, j), *const hinge_weft =
                                                                                system.hinge_weft.data() +
                                                                                l.node(0, j);
  const fabric::Law& law = l.law;
  const L inverse_rest = 1 / l.cell, inverse_diagonal = 1 / forces::shear_rest(l.cell);
  const L half_width = forces::stretch_width(l.cell), shear_width = forces::shear_width(l.cell);
  const bool bends = fabric::law_bends(law);
  simd::PlaceSums stretch, shear, bending;
  for (int i = 0; i < l.stride; i += L::kWidth) {
    const long up = i + row.stride;
    const simd::Vec<L> a = simd::vec_load<L>(row.r, i), b = simd::vec_load<L>(row.r, i + 1),
                       c = simd::vec_load<L>(row.r, up);
    const L share = L::load(row.share + i);
    const L weft = half_width * (L::load(row.share + i - row.stride) + share),
            warp = half_width * (L::loadu(row.share + i - 1) + share);
    stretch.add(i, weft * link_energy(b - a, inverse_rest, law.weft, weft) +
                       warp * link_energy(c - a, inverse_rest, law.warp, warp));
    if (law.bias.segments) {
      const simd::Vec<L> d = simd::vec_load<L>(row.r, up + 1);
      shear.add(i, shear_width * share *
                       (link_energy(d - a, inverse_diagonal, law.bias, share) +
                        link_energy(c - b, inverse_diagonal, law.bias, share)));
    }
    if (!bends) continue;
    const simd::Vec<L> left = simd::vec_load<L>(row.r, i - 1),
                       below = simd::vec_load<L>(row.r, i - row.stride);
    bending.add(i, hinge_energy(a - left, b - a, L(law.bending_weft) * L::load(hinge_weft + i)) +
                       hinge_energy(a - below, c - a, L(law.bending_warp) * L::load(hinge_warp + i)));
  }
  return {l.cell * stretch.total(), forces::shear_rest(l.cell) * shear.total(), bending.total()};
}

}  // namespace
}  // namespace drape::dynamics
