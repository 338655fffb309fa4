// What becomes of a row once its forces are complete: it moves, or the forces are written.
#pragma once
#include "dynamics/kernel/kernel.h"
#include "simd/vector_lanes.h"

namespace drape::dynamics {
namespace {

DRAPE_INLINE simd::ConstRow const_row(const Array& x, const Array& y, const Array& z, std::size_t at) {
  return {x.data() + at, y.data() + at, z.data() + at};
}
DRAPE_INLINE simd::Row row_of(Array& x, Array& y, Array& z, std::size_t at) {
  return {x.data() + at, y.data() + at, z.data() + at};
}

struct RowMove {
  simd::Row r, v, w;                                // null: the row stays; w: receives the old v, or null
  const double *inverse_mass, *inverse_mass_scale;  // inverse_mass_scale: null for 1 everywhere
  simd::Row force;                                  // receives the force, or null
};

DRAPE_INLINE RowMove row_move_of(const System& system, const PassTarget& to, std::size_t o) {
  RowMove m{};
  if (State* s = to.moved) {
    m.r = row_of(s->x, s->y, s->z, o);
    m.v = row_of(s->vx, s->vy, s->vz, o);
    if (!s->wx.empty()) m.w = row_of(s->wx, s->wy, s->wz, o);
    m.inverse_mass = system.inverse_mass.data() + o;
    if (!s->inverse_mass_scale.empty()) m.inverse_mass_scale = s->inverse_mass_scale.data() + o;
  } else {
    m.force = {to.fx + o, to.fy + o, to.fz + o};
  }
  return m;
}

// v <- keep v + kick (F/m + g),  r <- r + drift v. A node without mass gets no kick.
template <class L>
struct MoveLanes {
  L keep, kick, drift, gravity[3];
  L inverse_mass, kick_here;  // at the nodes of begin()

  DRAPE_INLINE explicit MoveLanes(const model::Scheme& c)
      : keep(c.decay), kick(c.kick), drift(c.drift), gravity{c.gravity[0], c.gravity[1], c.gravity[2]} {}
  DRAPE_INLINE void begin(const double* inverse, int i) {
    inverse_mass = L::load(inverse + i);
    kick_here = select(gt(inverse_mass, L(0.0)), kick, L(0.0));
  }
  DRAPE_INLINE L acceleration(int k, L force) const { return fma(force, inverse_mass, gravity[k]); }
  DRAPE_INLINE void move(int i, L a, double* r, double* v) const {
    const L v1 = fma(kick_here, a, keep * L::load(v + i));
    L::store(v + i, v1);
    L::store(r + i, fma(drift, v1, L::load(r + i)));
  }
};

// Three sinks for the forces on a row, coordinate by coordinate at the nodes of begin(). MoveSink moves the
// row.
template <class L>
struct MoveSink {
  MoveLanes<L> lanes;
  simd::Row r, v;
  const double* inverse_mass;
  DRAPE_INLINE void begin(int i) { lanes.begin(inverse_mass, i); }
  DRAPE_INLINE void put(int i, int k, L force) const {
    lanes.move(i, lanes.acceleration(k, force), simd::coordinate(r, k), simd::coordinate(v, k));
  }
};

// StoreSink stores the forces.
template <class L>
struct StoreSink {
  simd::PackedRow force;
  DRAPE_INLINE void begin(int) {}
  DRAPE_INLINE void put(int i, int k, L f) const { L::store(force.at<L>(i, k), f); }
};

// AnySink does what the row needs: it moves it, writes the forces, or does nothing. In a fit the inertia is
// m/inverse_mass_scale.
template <class L, bool kRates>
struct AnySink {
  MoveLanes<L> lanes;
  RowMove m;
  DRAPE_INLINE void begin(int i) {
    if (m.r.x) lanes.begin(m.inverse_mass, i);
  }
  DRAPE_INLINE void put(int i, int k, L force) const {
    if (!m.r.x) {
      if (double* out = simd::coordinate(m.force, k)) L::store(out + i, force);
      return;
    }
    L a = lanes.acceleration(k, force);
    if (m.inverse_mass_scale) a = a * L::load(m.inverse_mass_scale + i);
    if constexpr (kRates) L::store(simd::coordinate(m.w, k) + i, L::load(simd::coordinate(m.v, k) + i));
    lanes.move(i, a, simd::coordinate(m.r, k), simd::coordinate(m.v, k));
  }
};

template <class Sink, class L>
DRAPE_INLINE void sink_put(Sink& sink, int i, simd::Vec<L> force) {
  sink.begin(i);
  for (int k = 0; k < 3; ++k) sink.put(i, k, simd::coordinate(force, k));
}

}  // namespace
}  // namespace drape::dynamics
