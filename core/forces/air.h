// Air on cells (core/README.md, section 3).
//
//      c o---o d      d1 = d - a,  d2 = c - b,  c = d1 x d2;  area phi |c|/2, normal n = c/|c|
//        | X |
//      a o---o b      u = mean velocity of the corners - wind,  u_n = u.n,  u_t = u - u_n n
//
//   F = -(rho/2) (phi |c|/2) (C_n |u_n| u_n n + C_t |u_t| u_t), a quarter to each corner:
//
//   F/4 = -(rho/16) phi [C_n |u_n| u_n c + C_t |u_t| |c| u_t]
#pragma once
#include "model/system.h"
#include "simd/vector_lanes.h"

namespace drape::forces {
namespace {

// The force on one corner of a cell, N. `speed`: mean velocity of the corners, m/s.
template <class L>
DRAPE_INLINE simd::Vec<L> air_quarter(const model::Air& air, const Vec3& wind, simd::Vec<L> d1,
                                      simd::Vec<L> d2, simd::Vec<L> speed, L share) {
  const simd::Vec<L> c = cross(d1, d2), u = speed - simd::Vec<L>{L(wind[0]), L(wind[1]), L(wind[2])};
  const L size = sqrt(dot(c, c));
  const L inverse = select(gt(size, L(0.0)), L(1.0) / size, L(0.0));
  const simd::Vec<L> normal = c * inverse;
  const L un = dot(u, normal);
  const simd::Vec<L> ut = u - normal * un;
  const L scale = L(-air.density / 16) * share;
  return c * (scale * L(air.normal) * (abs(un) * un)) +
         ut * (scale * L(air.tangential) * (sqrt(dot(ut, ut)) * size));
}

// Cells between two rows of nodes, with the positions r and velocities u of both. Node i is a corner of cells
// i - 1 and i. The accumulator of the row above holds the negative sum, so that row subtracts.
template <class L>
// NOLINTNEXTLINE(readability-function-size): a kernel, whose parts share their registers
DRAPE_INLINE void air_cells(model::Columns reach, const model::Air& air, const Vec3& wind, simd::ConstRow r,
                            simd::ConstRow r_above, simd::ConstRow u, simd::ConstRow u_above,
                            const double* share, simd::PackedRow force, simd::PackedRow force_above) {
  simd::Vec<L> before{L(0.0), L(0.0), L(0.0)};
  for (int i = reach.begin; i < reach.end; i += L::kWidth) {
    const int beyond = simd::lane_after<L>(i, reach.end);
    const auto right = [&](simd::ConstRow row) DRAPE_INLINE_LAMBDA {
      return ahead(simd::vec_load<L>(row, i), simd::vec_load<L>(row, beyond));
    };
    const simd::Vec<L> d1 = right(r_above) - simd::vec_load<L>(r, i),
                       d2 = simd::vec_load<L>(r_above, i) - right(r);
    const simd::Vec<L> speed =
        ((simd::vec_load<L>(u, i) + right(u)) + (simd::vec_load<L>(u_above, i) + right(u_above))) * L(0.25);
    const simd::Vec<L> quarter = air_quarter(air, wind, d1, d2, speed, L::load(share + i));
    const simd::Vec<L> both = shifted(before, quarter) + quarter;
    simd::packed_store(force, i, simd::packed_load<L>(force, i) + both);
    simd::packed_store(force_above, i, simd::packed_load<L>(force_above, i) - both);
    before = quarter;
  }
}

}  // namespace
}  // namespace drape::forces
