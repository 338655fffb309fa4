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
// Forces that depend on velocity work on the same slabs, with the velocities of rows j and j + 1 led on to
// t_n. What lies beside the rows has been computed before the pass; the sink gets twins as one more row.
//
// Row buffers live in first-level cache; forces of three rows and links of two slabs roll.
#pragma once
#include <type_traits>

#include "forces/air.h"
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
  Row first, last, force[3];
  Row speed[2], quarter;  // velocities led on to t_n; air on a corner of each cell
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
  return row;
}
DRAPE_INLINE PassRows pass_rows(const Workspace& w) {
  PassRows p;
  int k = 0;
  p.weft = scratch_links(w, k);
  for (LinkRow& row : p.warp) row = scratch_links(w, k);
  for (Row* row : {&p.first, &p.last}) *row = scratch_vector(w, k);
  for (Row& row : p.force) row = scratch_vector(w, k);
  for (Row* row : {&p.speed[0], &p.speed[1], &p.quarter}) *row = scratch_vector(w, k);
  return p;
}

template <class L>
DRAPE_INLINE void row_clear(int n, Row r) {
  for (int i = 0; i < n; i += L::kWidth) vec_store(r, i, Vec<L>{L(0.0), L(0.0), L(0.0)});
}

// What a slab reads: rows j and j + 1 of positions and, with rates, of velocities; and what belongs to the
// nodes of row j.
struct SlabRows {
  ConstRow here, above, speed, speed_above;
  const double *share, *hinge_warp, *hinge_weft;
};

// Runs body(tension, damped) with the reader of a curve, and whether its links are damped.
template <bool kRates, class Body>
DRAPE_INLINE void with_law(const Curve& curve, const Law& law, Body body) {
  with_tension(curve, [&](auto tension) DRAPE_INLINE_LAMBDA {
    if constexpr (kRates) {
      if (law.damping > 0) return body(tension, std::true_type());
    }
    body(tension, std::false_type());
  });
}

// What links between two rows of moving nodes pull with.
template <bool kDamped>
DRAPE_INLINE auto pull_of(const Law& law, double rest, ConstRow speed, ConstRow speed_to) {
  if constexpr (kDamped) return Damped{speed, speed_to, law.damping, 1 / rest};
  else return Elastic{};
}

template <class L, bool kRates>
DRAPE_INLINE void slab_shear(const Lattice& l, const SlabRows& in, Row force, Row force_above) {
  const double diagonal = __builtin_sqrt(2.0) * l.cell;
  const double width = l.cell * l.cell / diagonal;
  with_law<kRates>(l.law.bias, l.law, [&](auto tension, auto damped) DRAPE_INLINE_LAMBDA {
    const DiagonalRows speed = diagonals_of(in.speed, in.speed_above);
    const decltype(pull_of<damped()>(l.law, diagonal, speed.from[0], speed.to[0])) pull[2]{
        pull_of<damped()>(l.law, diagonal, speed.from[0], speed.to[0]),
        pull_of<damped()>(l.law, diagonal, speed.from[1], speed.to[1])};
    shear_cells<L>(l.stride, diagonals_of(in.here, in.above), width, in.share, diagonal, tension, pull, force,
                   force_above);
  });
}

// All links of slab j and the hinges centred on row j; forces go to rows j - 1, j, j + 1.
template <class L, bool kRates>
void slab(const Lattice& l, const SlabRows& in, int j, const PassRows& p) {
  const int n = l.stride;
  const double b = l.cell, *share = in.share, *below = share - n;
  const Law& law = l.law;
  const Row force_below = p.force[(j + 2) % 3], force = p.force[j % 3], force_above = p.force[(j + 1) % 3];
  const LinkRow &warp = p.warp[j % 2], &warp_below = p.warp[(j + 1) % 2];

  if (law.weft.segments || law.bending_weft > 0)
    with_law<kRates>(law.weft, law, [&](auto tension, auto damped) DRAPE_INLINE_LAMBDA {
      stretch_weft<L>(n, in.here, {b / 2, below, share}, b, tension,
                      pull_of<damped()>(law, b, in.speed, in.speed.at(1)),
                      law.bending_weft > 0 ? &p.weft : nullptr, force);
    });
  if (law.warp.segments || law.bending_warp > 0)
    with_law<kRates>(law.warp, law, [&](auto tension, auto damped) DRAPE_INLINE_LAMBDA {
      stretch_warp<L>(n, in.here, in.above, {b / 2, share - 1, share}, b, tension,
                      pull_of<damped()>(law, b, in.speed, in.speed_above),
                      law.bending_warp > 0 ? &warp : nullptr, force, force_above);
    });
  else row_clear<L>(n, force_above);
  if (law.bias.segments) slab_shear<L, kRates>(l, in, force, force_above);
  if (law.bending_weft > 0)
    bending_weft_add<L>(n, p.weft, in.hinge_weft, law.bending_weft, p.first, p.last, force);
  if (law.bending_warp > 0 && j > 0)
    bending_warp_add<L>(n, warp_below, warp, in.hinge_warp, law.bending_warp, force_below, force,
                        force_above);
}

// u = v + lead (v - w)
template <class L>
DRAPE_INLINE void row_lead(int n, double lead, ConstRow v, ConstRow w, Row out) {
  for (int i = 0; i < n; i += L::kWidth) {
    const Vec<L> now = vec_load<L>(v, i);
    vec_store(out, i, now + (now - vec_load<L>(w, i)) * L(lead));
  }
}

DRAPE_INLINE ConstRow const_row(const Array& x, const Array& y, const Array& z, std::size_t at) {
  return {x.data() + at, y.data() + at, z.data() + at};
}
DRAPE_INLINE Row row_of(Array& x, Array& y, Array& z, std::size_t at) {
  return {x.data() + at, y.data() + at, z.data() + at};
}

// What the lists beside the rows add to row j, before it moves.
DRAPE_INLINE void row_add_side(const System& system, const Lattice& l, const Workspace& w, int j, Row force) {
  if (l.row_slot.empty()) return;
  const std::size_t row = l.node(0, j);
  for (int k = l.row_slot[std::size_t(j)]; k < l.row_slot[std::size_t(j) + 1]; ++k) {
    const std::size_t i = system.side.node[std::size_t(k)] - row;
    force.x[i] += w.side_x[std::size_t(k)];
    force.y[i] += w.side_y[std::size_t(k)];
    force.z[i] += w.side_z[std::size_t(k)];
  }
}

template <class L, bool kRates, class Sink>
void lattice_pass(const System& system, const Lattice& l, const State& s, double lead, Workspace& workspace,
                  Sink sink) {
  const PassRows p = pass_rows(workspace);
  const bool air = kRates && system_has_air(system);
  const auto speed_load = [&](int j) {
    const std::size_t o = l.first + std::size_t(j) * l.stride;
    row_lead<L>(l.stride, lead, const_row(s.vx, s.vy, s.vz, o), const_row(s.wx, s.wy, s.wz, o),
                p.speed[j % 2]);
  };
  const auto hand_over = [&](int j) {
    row_add_side(system, l, workspace, j, p.force[j % 3]);
    sink(l.first + std::size_t(j) * l.stride, l.stride, p.force[j % 3]);
  };
  row_clear<L>(l.stride, p.force[0]);
  if constexpr (kRates) speed_load(0);
  for (int j = 0; j < l.rows; ++j) {
    const std::size_t o = l.first + std::size_t(j) * l.stride;
    if constexpr (kRates) speed_load(j + 1);
    const ConstRow here = const_row(s.x, s.y, s.z, o);
    const SlabRows in{here,
                      here.at(l.stride),
                      p.speed[j % 2],
                      p.speed[(j + 1) % 2],
                      system.share.data() + o,
                      system.hinge_warp.data() + o,
                      system.hinge_weft.data() + o};
    slab<L, kRates>(l, in, j, p);
    if (kRates && air) {
      air_cells<L>(l.stride, system.air, s.wind, in.here, in.above, in.speed, in.speed_above, in.share,
                   p.quarter);
      air_add<L>(l.stride, p.quarter, p.force[j % 3], p.force[(j + 1) % 3]);
    }
    if (j > 0) hand_over(j - 1);
  }
  hand_over(l.rows - 1);
  if (l.twins > 0) {
    const auto k = std::size_t(l.twin_slot);
    sink(l.twin_first, l.twin_stride, row_of(workspace.side_x, workspace.side_y, workspace.side_z, k));
  }
}

// v <- keep v + kick (F/m + g),  r <- r + drift v. A node without mass stays. In a fit, inertia is
// m/lightness.
template <class L, bool kLight>
DRAPE_INLINE void row_move(int n, const StepCoefficients& c, const double* inverse_mass,
                           const double* lightness, ConstRow force, Row r, Row v) {
  const L keep = c.keep, kick = c.kick, drift = c.drift;
  const Vec<L> gravity{L(c.gravity[0]), L(c.gravity[1]), L(c.gravity[2])};
  for (int i = 0; i < n; i += L::kWidth) {
    const L im = L::load(inverse_mass + i);
    const L kick_here = select(gt(im, L(0.0)), kick, L(0.0));
    const Vec<L> f = vec_load<L>(force, i), v0 = vec_load<L>(v, i), r0 = vec_load<L>(r, i);
    Vec<L> a{fma(f.x, im, gravity.x), fma(f.y, im, gravity.y), fma(f.z, im, gravity.z)};
    if constexpr (kLight) a = a * L::load(lightness + i);
    const Vec<L> v1{fma(kick_here, a.x, keep * v0.x), fma(kick_here, a.y, keep * v0.y),
                    fma(kick_here, a.z, keep * v0.z)};
    vec_store(v, i, v1);
    vec_store(r, i, Vec<L>{fma(drift, v1.x, r0.x), fma(drift, v1.y, r0.y), fma(drift, v1.z, r0.z)});
  }
}

template <class L, bool kRates>
void lattice_step(const System& system, const Lattice& l, const StepCoefficients& c, Workspace& workspace,
                  State& s) {
  lattice_pass<L, kRates>(system, l, s, c.lead, workspace, [&](std::size_t o, int n, ConstRow force) {
    const Row v = row_of(s.vx, s.vy, s.vz, o);
    if constexpr (kRates) {
      const Row w = row_of(s.wx, s.wy, s.wz, o);
      for (int i = 0; i < n; i += L::kWidth) vec_store(w, i, vec_load<L>(v, i));
    }
    const double* inverse_mass = system.inverse_mass.data() + o;
    const Row r = row_of(s.x, s.y, s.z, o);
    if (s.lightness.empty()) row_move<L, false>(n, c, inverse_mass, nullptr, force, r, v);
    else row_move<L, true>(n, c, inverse_mass, s.lightness.data() + o, force, r, v);
  });
}

template <class L, bool kRates>
void lattice_forces(const System& system, const Lattice& l, const State& s, double lead, Workspace& workspace,
                    double* fx, double* fy, double* fz) {
  lattice_pass<L, kRates>(system, l, s, lead, workspace, [&](std::size_t o, int n, ConstRow force) {
    for (int i = 0; i < n; i += L::kWidth) vec_store(Row{fx + o, fy + o, fz + o}, i, vec_load<L>(force, i));
  });
}

template <class L, bool kRates>
constexpr Pass pass_of() {
  return {lattice_step<L, kRates>, lattice_forces<L, kRates>};
}

}  // namespace
}  // namespace drape
