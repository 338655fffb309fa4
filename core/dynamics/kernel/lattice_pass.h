// One pass over rows of a lattice, which computes each link once.
//
// Row j has weft links and weft hinges within the row, warp links and diagonals to rows j - 1 and j + 1, and
// warp hinges centred on rows j - 1, j, j + 1. So once the links of slab j (row j to row j + 1) are done, row
// j has all its forces but those of hinges. Once the hinges centred on row j are done, row j - 1 has all
// forces. Nothing reads its old positions any more, and it may move:
//
//     row j+1  . . . . .      slab j: weft links of j, warp links and diagonals j -> j+1
//     row j    o-o-o-o-o      hinges centred on row j use slabs j - 1 and j
//     row j-1  * * * * *      complete
//
// Forces that depend on velocity work on the same slabs, with the velocities of rows j and j + 1 extrapolated
// to t_n. Irregular elements have been computed before the pass. Twins move as one more row.
//
// Row buffers stay in the first-level cache; forces of three rows and links of two slabs roll. Until its own
// slab, the buffer of a row holds minus its sums, so that one subtraction adds both. A block that begins or
// ends within the lattice also computes the slabs beyond it that its own rows need, but moves its own rows
// only. Each row thus gets the same sums in the same order, whatever the blocks.
#pragma once
#include <algorithm>

#include "dynamics/kernel/row_move.h"
#include "dynamics/kernel/slab_links.h"
#include "forces/air.h"
#include "forces/bending.h"

namespace drape::dynamics {
namespace {

// The scratch rows of a thread by their use.
struct PassRows {
  double *weft, *warp[2];  // 1/l of links, for hinges
  simd::PackedRow force[3];
  simd::Row speed[2];  // velocities extrapolated to t_n
};

struct ScratchRows {
  double* next;
  int stride;
  DRAPE_INLINE double* one() {
    double* row = next;
    next += stride;
    return row;
  }
  DRAPE_INLINE simd::Row vector() {
    double *x = one(), *y = one();
    return {x, y, one()};
  }
};
DRAPE_INLINE PassRows pass_rows(double* scratch, int stride) {
  ScratchRows rows{scratch, stride};
  PassRows p;
  p.weft = rows.one();
  for (double*& row : p.warp) row = rows.one();
  for (simd::PackedRow& row : p.force) row = {rows.vector().x};
  for (simd::Row& row : p.speed) row = rows.vector();
  return p;
}

template <class L>
DRAPE_INLINE void row_clear(int n, simd::PackedRow r) {
  for (int i = 0; i < n; i += L::kWidth) simd::packed_store(r, i, simd::Vec<L>{L(0.0), L(0.0), L(0.0)});
}
// u = v + extrapolation (v - w)
template <class L>
DRAPE_INLINE void row_extrapolate(int n, double extrapolation, simd::ConstRow v, simd::ConstRow w,
                                  simd::Row out) {
  for (int i = 0; i < n; i += L::kWidth) {
    const simd::Vec<L> now = simd::vec_load<L>(v, i);
    simd::vec_store(out, i, now + (now - simd::vec_load<L>(w, i)) * L(extrapolation));
  }
}

// Adds the forces of irregular elements on row j: subtracts them from minus its sums so far.
DRAPE_INLINE void row_add_irregular(const System& system, const model::Lattice& l, const Workspace& w, int j,
                                    simd::PackedRow force) {
  if (l.row_slot.empty()) return;
  const std::size_t row = l.node(0, j);
  for (int k = l.row_slot[std::size_t(j)]; k < l.row_slot[std::size_t(j) + 1]; ++k) {
    const int i = int(system.irregular.node[std::size_t(k)] - row);
    double* at = force.p + i / math::kRowUnit * 3 * math::kRowUnit + i % math::kRowUnit;
    at[0] -= w.slot_x[std::size_t(k)];
    at[math::kRowUnit] -= w.slot_y[std::size_t(k)];
    at[2 * math::kRowUnit] -= w.slot_z[std::size_t(k)];
  }
}

// The input and output of a pass, shared by all its functions.
struct PassRun {
  const System& system;
  const model::Lattice& l;
  const RowBlock& block;
  const model::Scheme& c;
  const Workspace& workspace;
  const State& s;
  const PassTarget& to;
  PassRows p;

  DRAPE_INLINE bool mine(int j) const { return j >= block.begin && j < block.end; }
  DRAPE_INLINE std::size_t first(int j) const {
    return std::size_t(std::ptrdiff_t(l.first) + std::ptrdiff_t(j) * l.stride);
  }
  // Row j of three arrays. A row of a neighbour comes from coordinates k to k + 2 of the copies.
  DRAPE_INLINE simd::ConstRow row(const Array& x, const Array& y, const Array& z, int k, int j) const {
    if (mine(j) || j < 0 || j >= l.rows) return const_row(x, y, z, first(j));
    const int slot = j < block.begin ? j - block.begin + 2 : j - block.end + 2;
    const double* at = block.copies.data() + long(slot * block_coordinates(s) + k) * l.stride;
    return {at, at + l.stride, at + 2 * l.stride};
  }
  DRAPE_INLINE simd::ConstRow positions(int j) const { return row(s.x, s.y, s.z, 0, j); }
  DRAPE_INLINE bool moves_plainly(int j) const {
    return mine(j) && to.moved && to.moved->inverse_mass_scale.empty();
  }
  DRAPE_INLINE RowMove move(int j) const { return mine(j) ? row_move_of(system, to, first(j)) : RowMove{}; }
};

template <class L>
DRAPE_INLINE void speed_load(const PassRun& run, int j) {
  row_extrapolate<L>(run.l.stride, run.c.extrapolation, run.row(run.s.vx, run.s.vy, run.s.vz, 3, j),
                     run.row(run.s.wx, run.s.wy, run.s.wz, 6, j), run.p.speed[j % 2]);
}

template <class L, bool kRates>
DRAPE_INLINE void row_finish(const PassRun& run, int j) {
  AnySink<L, kRates> sink{MoveLanes<L>(run.c), run.move(j)};
  const model::Columns reach = run.l.reach[std::size_t(j)];
  for (int i = reach.begin; i < reach.end; i += L::kWidth)
    sink_put(sink, i, simd::packed_load<L>(run.p.force[j % 3], i));
}

// Computes the hinges centred on row j; then row j - 1 moves.
template <class L, bool kRates>
DRAPE_INLINE void slab_hinges(const PassRun& run, const SlabRows& in, int j) {
  const PassRows& p = run.p;
  const fabric::Law& law = run.l.law;
  const simd::ConstRow row_below = run.positions(j - 1);
  const double *inverse_below = p.warp[(j + 1) % 2], *inverse_above = p.warp[j % 2];
  const simd::PackedRow below = p.force[(j + 2) % 3], here = p.force[j % 3], above = p.force[(j + 1) % 3];
  AnySink<L, kRates> sink{MoveLanes<L>(run.c), run.move(j - 1)};
  const int begin = in.reach.begin, end = in.reach.end;
  const auto weft_link = [&](int i) DRAPE_INLINE_LAMBDA {
    const int beyond = simd::lane_after<L>(i, end);
    const simd::Vec<L> at = simd::vec_load<L>(in.here, i);
    return forces::hinge_link(at, ahead(at, simd::vec_load<L>(in.here, beyond)), L::load(p.weft + i));
  };
  const simd::Vec<L> none{L(0.0), L(0.0), L(0.0)};
  forces::WeftHinges<L> weft{weft_link(begin), none, none};
  for (int i = begin; i < end; i += L::kWidth) {
    const int next = simd::lane_after<L>(i, end);
    const simd::Vec<L> along =
        forces::bending_weft(weft_link(next), L(law.bending_weft) * L::loadu(in.hinge_weft + i + 1), weft);
    const simd::Vec<L> at = simd::vec_load<L>(in.here, i);
    const forces::HingeLink<L> a = forces::hinge_link(simd::vec_load<L>(row_below, i), at,
                                                      L::load(inverse_below + i)),
                               c = forces::hinge_link(at, simd::vec_load<L>(in.above, i),
                                                      L::load(inverse_above + i));
    const forces::HingeForces<L> across = forces::bending_hinge(
        a.unit, a.inverse, c.unit, c.inverse, L(law.bending_warp) * L::load(in.hinge_warp + i));
    simd::packed_store(here, i, simd::packed_load<L>(here, i) + (along - (across.first + across.last)));
    simd::packed_store(above, i, simd::packed_load<L>(above, i) - across.last);
    sink_put(sink, i, simd::packed_load<L>(below, i) + across.first);
  }
}

template <class L, bool kRates, class Tension, int kFamilies, bool kDamped, bool kHinges>
void pass_run(const PassRun& run) {
  const model::Lattice& l = run.l;
  const PassRows& p = run.p;
  const int n = l.stride, begin = run.block.begin, end = run.block.end;
  const bool air = kRates && model::system_has_air(run.system);
  const int from = std::max(0, begin - (kHinges ? 2 : 1)), to = std::min(l.rows, end + (kHinges ? 1 : 0));
  row_clear<L>(n, p.force[from % 3]);
  if constexpr (kHinges) {
    row_clear<L>(n, p.force[(from + 2) % 3]);
    for (int i = 0; i < n; i += L::kWidth) L::store(p.warp[(from + 1) % 2] + i, L(0.0));
  }
  if constexpr (kRates) speed_load<L>(run, from);
  for (int j = from; j < to; ++j) {
    const std::size_t o = run.first(j);
    if constexpr (kRates) speed_load<L>(run, j + 1);
    const double* share = run.system.share.data() + o;
    const SlabRows in{l.reach[std::size_t(j)],
                      run.positions(j),
                      run.positions(j + 1),
                      p.speed[j % 2],
                      p.speed[(j + 1) % 2],
                      share,
                      share - n,
                      run.system.hinge_warp.data() + o,
                      run.system.hinge_weft.data() + o};
    const simd::PackedRow force = p.force[j % 3], force_above = p.force[(j + 1) % 3];
    if (run.mine(j)) row_add_irregular(run.system, l, run.workspace, j, force);
    const bool moves_at_once = !kHinges && !kRates && run.moves_plainly(j);
    if (moves_at_once) {
      const RowMove m = run.move(j);
      slab_links<L, Tension, kFamilies, kDamped>(l, in, force, force_above, nullptr, nullptr,
                                                 MoveSink<L>{MoveLanes<L>(run.c), m.r, m.v, m.inverse_mass});
      continue;
    }
    double *weft = kHinges ? p.weft : nullptr, *warp = kHinges ? p.warp[j % 2] : nullptr;
    slab_links<L, Tension, kFamilies, kDamped>(l, in, force, force_above, weft, warp, StoreSink<L>{force});
    if (air)
      forces::air_cells<L>(in.reach, run.system.air, run.s.wind, in.here, in.above, in.speed, in.speed_above,
                           share, force, force_above);
    if constexpr (!kHinges) row_finish<L, kRates>(run, j);
    else if (j + 1 >= begin) slab_hinges<L, kRates>(run, in, j);
  }
  if (kHinges && end == l.rows) row_finish<L, kRates>(run, end - 1);
}

// The next three select the loop for the laws of a lattice.
template <class L, bool kRates, class Tension, int kFamilies, bool kDamped>
void pass_bent(const PassRun& run) {
  if (fabric::law_bends(run.l.law)) pass_run<L, kRates, Tension, kFamilies, kDamped, true>(run);
  else pass_run<L, kRates, Tension, kFamilies, kDamped, false>(run);
}
template <class L, bool kRates, class Tension, int kFamilies>
void pass_damped(const PassRun& run) {
  if constexpr (kRates) {
    if (run.l.law.damping > 0) return pass_bent<L, kRates, Tension, kFamilies, true>(run);
  }
  pass_bent<L, kRates, Tension, kFamilies, false>(run);
}
template <class L, bool kRates, class Tension>
void pass_sheared(const PassRun& run) {
  if (run.l.law.bias.segments > 0) pass_damped<L, kRates, Tension, 4>(run);
  else pass_damped<L, kRates, Tension, 2>(run);
}

template <class L, bool kRates>
void block_pass(const System& system, const RowBlock& block, const model::Scheme& c, const Workspace& w,
                double* scratch, const State& s, const PassTarget& to) {
  const model::Lattice& l = system.lattices[std::size_t(block.lattice)];
  const PassRun run{system, l, block, c, w, s, to, pass_rows(scratch, l.stride)};
  const fabric::Law& law = l.law;
  if (std::max({law.warp.segments, law.weft.segments, law.bias.segments}) <= 1)
    pass_sheared<L, kRates, forces::LineTension>(run);
  else pass_sheared<L, kRates, forces::CurveTension>(run);
  if (l.twins > 0 && block.end == l.rows) {
    const std::size_t k = std::size_t(l.twin_slot);
    AnySink<L, kRates> sink{MoveLanes<L>(c), row_move_of(system, to, l.twin_first)};
    for (int i = 0; i < l.twin_stride; i += L::kWidth)
      sink_put(sink, i, simd::vec_load<L>(const_row(w.slot_x, w.slot_y, w.slot_z, k), i));
  }
}

}  // namespace
}  // namespace drape::dynamics
