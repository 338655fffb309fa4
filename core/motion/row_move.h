// How a row moves once its forces are complete; or, for outputs, where they go.
#pragma once
#include "forces/rows.h"
#include "motion/kernel.h"

namespace drape {
namespace {

DRAPE_INLINE ConstRow const_row(const Array& x, const Array& y, const Array& z, std::size_t at) {
  return {x.data() + at, y.data() + at, z.data() + at};
}
DRAPE_INLINE Row row_of(Array& x, Array& y, Array& z, std::size_t at) {
  return {x.data() + at, y.data() + at, z.data() + at};
}

struct RowMove {
  Row r, v, w;                             // null: the row stays; w: room for the old v, or null
  const double *inverse_mass, *lightness;  // lightness: or null
  Row force;                               // where the force goes, or null
};

DRAPE_INLINE RowMove row_move_of(const System& system, const PassTarget& to, std::size_t o) {
  RowMove m{};
  if (State* s = to.moved) {
    m.r = row_of(s->x, s->y, s->z, o);
    m.v = row_of(s->vx, s->vy, s->vz, o);
    if (!s->wx.empty()) m.w = row_of(s->wx, s->wy, s->wz, o);
    m.inverse_mass = system.inverse_mass.data() + o;
    if (!s->lightness.empty()) m.lightness = s->lightness.data() + o;
  } else {
    m.force = {to.fx + o, to.fy + o, to.fz + o};
  }
  return m;
}

// v <- keep v + kick (F/m + g),  r <- r + drift v, coordinate k. A node without mass stays. In a fit, inertia
// is m/lightness.
template <class L, bool kRates>
DRAPE_INLINE void row_move(int i, int k, const StepCoefficients& c, const RowMove& m, L force) {
  double* r = coordinate(m.r, k);
  if (!r) {
    if (double* out = coordinate(m.force, k)) L::store(out + i, force);
    return;
  }
  double* v = coordinate(m.v, k);
  const L im = L::load(m.inverse_mass + i), v0 = L::load(v + i);
  const L kick = select(gt(im, L(0.0)), L(c.kick), L(0.0));
  L a = fma(force, im, L(c.gravity[std::size_t(k)]));
  if (m.lightness) a = a * L::load(m.lightness + i);
  const L v1 = fma(kick, a, L(c.keep) * v0);
  if constexpr (kRates) L::store(coordinate(m.w, k) + i, v0);
  L::store(v + i, v1);
  L::store(r + i, fma(L(c.drift), v1, L::load(r + i)));
}
template <class L, bool kRates>
DRAPE_INLINE void row_move(int i, const StepCoefficients& c, const RowMove& m, Vec<L> force) {
  for (int k = 0; k < 3; ++k) row_move<L, kRates>(i, k, c, m, coordinate(force, k));
}

}  // namespace
}  // namespace drape
