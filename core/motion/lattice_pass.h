// One pass over the rows of a lattice, each link once.
//
// Row j takes part in: weft links and weft hinges within the row, warp links and diagonals to rows j - 1 and
// j + 1, warp hinges centred on rows j - 1, j, j + 1. So when the links of slab j (row j to row j + 1) and
// the hinges of row j are done, row j - 1 has all its forces; nobody reads its old place again, and it may
// move:
//
//     row j+1  . . . . .      slab j: weft links of j, warp links and diagonals j -> j+1
//     row j    o-o-o-o-o      hinges centred on row j use slabs j - 1 and j
//     row j-1  * * * * *      complete: handed to the sink
//
// Row buffers live in first-level cache; forces of three rows and links of two slabs roll.
#pragma once
#include "forces/bending.h"
#include "forces/shear.h"
#include "forces/stretch.h"
#include "forces/tension.h"
#include "motion/kernel.h"

namespace drape {
namespace {

// The scratch rows of a workspace by their use. Each is preceded and followed by a register of zeros.
struct PassRows {
  LinkRow weft, warp[2];
  Row rising, falling, first, last, force[3];
};

DRAPE_INLINE double* scratch_row(const Workspace& w, int k) {
  return const_cast<double*>(w.rows.data()) + kRowUnit + long(k) * (w.stride + kRowUnit);
}
DRAPE_INLINE Row scratch_vector(const Workspace& w, int& k) {
  k += 3;
  return {scratch_row(w, k - 3), scratch_row(w, k - 2), scratch_row(w, k - 1)};
}
DRAPE_INLINE LinkRow scratch_links(const Workspace& w, int& k) {
  LinkRow row;
  row.unit = scratch_vector(w, k);
  row.inverse = scratch_row(w, k++);
  row.pull = scratch_vector(w, k);
  return row;
}
DRAPE_INLINE PassRows pass_rows(const Workspace& w) {
  PassRows p;
  int k = 0;
  p.weft = scratch_links(w, k);
  for (LinkRow& row : p.warp) row = scratch_links(w, k);
  for (Row* row : {&p.rising, &p.falling, &p.first, &p.last}) *row = scratch_vector(w, k);
  for (Row& row : p.force) row = scratch_vector(w, k);
  return p;
}

template <class L>
DRAPE_INLINE void row_clear(int n, Row r) {
  for (int i = 0; i < n; i += L::kWidth) vec_store(r, i, Vec<L>{L(0.0), L(0.0), L(0.0)});
}

// All links of slab j and the hinges centred on row j; forces go to rows j - 1, j, j + 1.
template <class L>
void slab(const Lattice& l, ConstRow here, const double* share, int j, const PassRows& p) {
  const int n = l.stride;
  const double b = l.cell;
  const Law& law = l.law;
  const double* below = share - n;
  const Row force_below = p.force[(j + 2) % 3], force = p.force[j % 3], force_above = p.force[(j + 1) % 3];
  const LinkRow &warp = p.warp[j % 2], &warp_below = p.warp[(j + 1) % 2];
  row_clear<L>(n, force_above);

  if (law.weft.segments || law.bending_weft > 0) {
    with_tension(law.weft, [&](auto tension) {
      stretch_links<L>(n, here, here.at(1), {b / 2, below, share}, b, tension, p.weft);
    });
    stretch_weft_add<L>(n, p.weft.pull, force);
  }
  if (law.warp.segments || law.bending_warp > 0) {
    with_tension(law.warp, [&](auto tension) {
      stretch_links<L>(n, here, here.at(n), {b / 2, share - 1, share}, b, tension, warp);
    });
    stretch_warp_add<L>(n, warp.pull, force, force_above);
  }
  if (law.bias.segments) {
    const double diagonal = __builtin_sqrt(2.0) * b;
    const WidthRow width{b * b / (2 * diagonal), share, share};
    with_tension(law.bias, [&](auto tension) {
      shear_diagonals<L>(n, here, here.at(n + 1), width, diagonal, tension, p.rising);
      shear_diagonals<L>(n, here.at(1), here.at(n), width, diagonal, tension, p.falling);
    });
    shear_add<L>(n, p.rising, p.falling, force, force_above);
  }
  if (law.bending_weft > 0)
    bending_weft_add<L>(n, p.weft, {below, share}, law.bending_weft, p.first, p.last, force);
  if (law.bending_warp > 0 && j > 0)
    bending_warp_add<L>(n, warp_below, warp, {below, share}, law.bending_warp, force_below, force,
                        force_above);
}

template <class L, class Sink>
void lattice_pass(const System& system, const Lattice& l, ConstRow first, Workspace& workspace, Sink sink) {
  const PassRows p = pass_rows(workspace);
  const double* share = system.share.data() + l.first;
  row_clear<L>(l.stride, p.force[0]);
  for (int j = 0; j < l.rows; ++j) {
    slab<L>(l, first.at(long(j) * l.stride), share + long(j) * l.stride, j, p);
    if (j > 0) sink(j - 1, p.force[(j + 2) % 3]);
  }
  sink(l.rows - 1, p.force[(l.rows - 1) % 3]);
}

// v <- keep v + kick (F/m + g),  r <- r + drift v. A node without mass stays.
template <class L>
DRAPE_INLINE void row_move(int n, const StepCoefficients& c, const double* inverse_mass, ConstRow force,
                           Row r, Row v) {
  const L keep = c.keep, kick = c.kick, drift = c.drift;
  const Vec<L> gravity{L(c.gravity[0]), L(c.gravity[1]), L(c.gravity[2])};
  for (int i = 0; i < n; i += L::kWidth) {
    const L im = L::load(inverse_mass + i);
    const auto present = gt(im, L(0.0));
    const Vec<L> f = vec_load<L>(force, i), v0 = vec_load<L>(v, i), r0 = vec_load<L>(r, i);
    const Vec<L> a{fma(f.x, im, gravity.x), fma(f.y, im, gravity.y), fma(f.z, im, gravity.z)};
    const Vec<L> v1{select(present, fma(kick, a.x, keep * v0.x), L(0.0)),
                    select(present, fma(kick, a.y, keep * v0.y), L(0.0)),
                    select(present, fma(kick, a.z, keep * v0.z), L(0.0))};
    vec_store(v, i, v1);
    vec_store(r, i, Vec<L>{fma(drift, v1.x, r0.x), fma(drift, v1.y, r0.y), fma(drift, v1.z, r0.z)});
  }
}

template <class L>
void kernel_step(const System& system, const Lattice& l, const StepCoefficients& c, Workspace& workspace,
                 State& s) {
  const Row r{s.x.data() + l.first, s.y.data() + l.first, s.z.data() + l.first};
  const Row v{s.vx.data() + l.first, s.vy.data() + l.first, s.vz.data() + l.first};
  const double* inverse_mass = system.inverse_mass.data() + l.first;
  lattice_pass<L>(system, l, r, workspace, [&](int j, ConstRow force) {
    const long o = long(j) * l.stride;
    row_move<L>(l.stride, c, inverse_mass + o, force, {r.x + o, r.y + o, r.z + o},
                {v.x + o, v.y + o, v.z + o});
  });
}

template <class L>
void kernel_forces(const System& system, const Lattice& l, const State& s, Workspace& workspace, double* fx,
                   double* fy, double* fz) {
  const ConstRow r{s.x.data() + l.first, s.y.data() + l.first, s.z.data() + l.first};
  lattice_pass<L>(system, l, r, workspace, [&](int j, ConstRow force) {
    const std::size_t o = l.first + std::size_t(j) * l.stride;
    for (int i = 0; i < l.stride; i += L::kWidth)
      vec_store(Row{fx + o, fy + o, fz + o}, i, vec_load<L>(force, i));
  });
}

}  // namespace
}  // namespace drape
