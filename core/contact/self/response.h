// Response of self-contact: the contact law of bodies (contact/particle/response.h) on pairs, whose impulses
// are equal and opposite. With K = sum W_k^2/m_k and the depth e = contact distance - d,
//
//   normal     P = [k phi(e) dt - 2 zeta sqrt(k/K) phi'(e) w_n dt]+,   the damping centred
//   stop       d_{n+1} >= kSelfMin x contact distance: removes the approach that is left
//   friction   J on the tangential w, |J| <= mu P (Coulomb); a pair that sticks has no tangential w at all
//
// First come all penalties. Then damping, stops and friction act in turn, group by group, until nothing
// changes (projected Gauss-Seidel; Jourdan, Alart, Jean 1998). Friction is warm-started with that of the last
// step, so that cloth at rest does not creep.
#pragma once
#include "contact/particle/law_lanes.h"
#include "contact/self/closest_lanes.h"
#include "contact/self/groups.h"
#include "simd/vector_lanes.h"

namespace drape::contact {
namespace {

constexpr double kSelfDamping = 1;                // zeta
constexpr double kThin = 1e-12;                   // of the trace cubed: nodes on one line have no rotation
constexpr double kSelfMin = 1 - kContactDeepest;  // of the contact distance: the smallest distance allowed

// u_k p_k, D and I^-1 of lanes.
template <class L>
struct SelfLevers {
  simd::Vec<L> p[4], arm;
  L xx, xy, xz, yy, yz, zz;

  DRAPE_INLINE simd::Vec<L> turned(const simd::Vec<L>& a) const {
    return {fma(xx, a.x, fma(xy, a.y, xz * a.z)), fma(xy, a.x, fma(yy, a.y, yz * a.z)),
            fma(xz, a.x, fma(yz, a.y, zz * a.z))};
  }
};

// The pairs i .. i + L::kWidth - 1 of a group.
template <class L>
struct SelfLanes {
  using Vec = simd::Vec<L>;

  SelfGroup& g;
  const SelfContactPass& pass;
  std::size_t i;
  Vec v[4];      // m/s, and
  L inverse[4];  // 1/kg: not yet loaded

  DRAPE_INLINE SelfLanes(SelfGroup& group, const SelfContactPass& of, std::size_t lane)
      : g(group), pass(of), i(lane) {}
  DRAPE_INLINE L get(const SelfGroup::Lanes& of) const { return L::load(of + i); }
  DRAPE_INLINE void set(SelfGroup::Lanes& of, L to) const { L::store(of + i, to); }
  DRAPE_INLINE Vec get3(const SelfGroup::Lanes (&of)[3]) const {
    return {get(of[0]), get(of[1]), get(of[2])};
  }
  DRAPE_INLINE void set3(SelfGroup::Lanes (&of)[3], const Vec& to) const {
    set(of[0], to.x), set(of[1], to.y), set(of[2], to.z);
  }
  DRAPE_INLINE Vec gathered(const double* of, int k) const {
    Vec to;
    L unused;
    L::gather4(of, g.at[k] + i, to.x, to.y, to.z, unused);
    return to;
  }
  DRAPE_INLINE void velocities_load() {
    for (int k = 0; k < 4; ++k) L::gather4(pass.v, g.at[k] + i, v[k].x, v[k].y, v[k].z, inverse[k]);
  }
  DRAPE_INLINE void velocities_store() const {
    for (int k = 0; k < 4; ++k) L::scatter4(pass.v, g.at[k] + i, v[k].x, v[k].y, v[k].z, inverse[k]);
  }
  // A vector of node k times u_k, which is 0 of a particle and 1 of all other nodes.
  DRAPE_INLINE Vec turning(int k, const Vec& of) const { return k == 0 ? of * L(g.crosses ? 1.0 : 0.0) : of; }
  // sum W_k of vectors of the nodes
  DRAPE_INLINE Vec weighted(const Vec* of) const {
    Vec w = of[0] * get(g.weight[0]);
    for (int k = 1; k < 4; ++k) w = w + of[k] * get(g.weight[k]);
    return w;
  }
  DRAPE_INLINE SelfLevers<L> levers() const {
    SelfLevers<L> l;
    for (int k = 0; k < 4; ++k) l.p[k] = gathered(pass.r, k);
    l.arm = weighted(l.p);
    Vec mean = turning(0, l.p[0]);
    for (int k = 1; k < 4; ++k) mean = mean + l.p[k];
    mean = mean * L(g.crosses ? 1.0 / 4 : 1.0 / 3);
    L xx(0.0), xy(0.0), xz(0.0), yy(0.0), yz(0.0), zz(0.0);
    for (int k = 0; k < 4; ++k) {
      const Vec p = l.p[k] = turning(k, l.p[k] - mean);
      xx = xx + fma(p.y, p.y, p.z * p.z), xy = xy - p.x * p.y;
      yy = yy + fma(p.x, p.x, p.z * p.z), xz = xz - p.x * p.z;
      zz = zz + fma(p.x, p.x, p.y * p.y), yz = yz - p.y * p.z;
    }
    const L a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
    const L det = fma(xx, a, fma(xy, b, xz * c)), trace = xx + yy + zz;
    const auto spans = gt(det, L(kThin) * trace * trace * trace);
    const L over = select(spans, L(1.0) / select(spans, det, L(1.0)), L(0.0));
    l.xx = over * a, l.xy = over * b, l.xz = over * c;
    l.yy = over * (xx * zz - xz * xz), l.yz = over * (xy * xz - xx * yz), l.zz = over * (xx * yy - xy * xy);
    return l;
  }
  // The tangential w, of the gap's velocity.
  DRAPE_INLINE Vec slip(const SelfLevers<L>& l, const Vec& gap_velocity) const {
    Vec momentum = cross(l.p[0], v[0]);
    for (int k = 1; k < 4; ++k) momentum = momentum + cross(l.p[k], v[k]);
    const Vec w = gap_velocity - cross(l.turned(momentum), l.arm), n = get3(g.n);
    return w - n * dot(w, n);
  }
  DRAPE_INLINE void push_along(const Vec& n, L impulse) {
    for (int k = 0; k < 4; ++k) v[k] = v[k] + n * (impulse * get(g.weight[k]) * inverse[k]);
  }
  DRAPE_INLINE void push_across(const SelfLevers<L>& l, const Vec& j) {
    const Vec t = l.turned(cross(l.arm, j));
    for (int k = 0; k < 4; ++k) v[k] = v[k] + (j * get(g.weight[k]) - cross(t, l.p[k])) * inverse[k];
  }
  // Bounds J by Coulomb friction; `slides` notes where it does.
  DRAPE_INLINE Vec friction_bounded(const Vec& j) const {
    const L pressed = get(g.normal) + get(g.stop), size2 = dot(j, j), one(1.0);
    const L limit = get(g.limit) * pressed;
    const auto slides = gt(size2, limit * limit);
    set(g.slides, select(slides, one, L(0.0)));
    if (!any(slides)) return j;
    return j * select(slides, get(g.slide) * pressed / sqrt(max(size2, L(1e-300))), one);
  }
};

// Calls a function of lanes on all lanes of a group.
template <class L, class Act>
DRAPE_INLINE void lanes_visit(SelfGroup& g, const SelfContactPass& pass, Act act) {
  for (std::size_t i = 0; i < kGroupPairs; i += L::kWidth) {
    SelfLanes<L> of(g, pass, i);
    act(of);
  }
}

// Sets what the sweeps need besides the penalty, for lanes on which nothing acts yet.
template <class L>
DRAPE_INLINE void lanes_begin(SelfLanes<L>& of) {
  SelfGroup& g = of.g;
  const ContactCoefficients& c = of.pass.c;
  const L zero(0.0), one(1.0);
  L over = zero;
  of.velocities_load();
  for (int k = 0; k < 4; ++k) over = fma(of.get(g.weight[k]) * of.get(g.weight[k]), of.inverse[k], over);
  const auto free = gt(over, zero);
  const L contact_distance = select(free, of.get(g.contact_distance), L(-model::kFar));
  const L clearance = of.get(g.distance) - L(kSelfMin) * contact_distance;
  of.set(g.mass, one / select(free, over, one));
  of.set(g.contact_distance, contact_distance);
  of.set(g.expected, stop_velocity(clearance, L(c.stop_rate), L(c.push_rate)));
  for (SelfGroup::Lanes* result : {&g.normal, &g.stored, &g.stop, &g.slides, &g.given}) of.set(*result, zero);
  of.set(g.yield, one);
}

// Applies the penalties of lanes; returns the change of w_n.
template <class L>
DRAPE_INLINE L normal_begin(SelfLanes<L>& of) {
  SelfGroup& g = of.g;
  const ContactCoefficients& c = of.pass.c;
  const L contact_distance = of.get(g.contact_distance), depth = contact_distance - of.get(g.distance);
  const auto touches = gt(depth, L(0.0));
  if (!any(touches)) return L(0.0);
  g.touches = g.presses = true;
  const L blend = L(kSelfBlend) * max(contact_distance, L(1e-300));
  const RampLanes<L> ramp(blend, depth, min(max(depth / blend, L(0.0)), L(1.0)));
  const L over = L(1.0) / of.get(g.mass), stiffness = of.get(g.stiffness);
  const L stored = select(touches, L(c.kick) * stiffness * ramp.phi, L(0.0));
  const L resist = L(2 * kSelfDamping) * sqrt(stiffness * over) * ramp.slope;
  const simd::Vec<L> n = of.get3(g.n);
  simd::Vec<L> old[4];
  for (int k = 0; k < 4; ++k) old[k] = of.gathered(of.pass.old, k);
  of.set(g.given, over * stored - resist * L(c.old_time) * dot(n, of.weighted(old)));
  of.set(g.yield, L(1.0) / fma(resist, L(c.new_time), L(1.0)));
  of.set(g.stored, stored);
  of.set(g.normal, stored);
  of.push_along(n, stored);
  of.velocities_store();
  return over * stored;
}

template <class L>
double self_begin_lanes(const SelfContactPass& pass) {
  L largest(0.0);
  for (SelfGroup* g = pass.begin; g != pass.end; ++g) {
    g->touches = g->presses = false;
    lanes_visit<L>(*g, pass, [&](SelfLanes<L>& of) {
      lanes_begin(of);
      largest = max(largest, normal_begin(of));
    });
  }
  for (SelfGroup* g = pass.begin; g != pass.end; ++g) {
    if (g->touches)
      lanes_visit<L>(*g, pass, [&](SelfLanes<L>& of) {
        const simd::Vec<L> j = of.friction_bounded(of.get3(g->friction) * L(pass.c.kick));
        of.set3(g->friction, j);
        of.velocities_load();
        of.push_across(of.levers(), j);
        of.velocities_store();
      });
    else lanes_visit<L>(*g, pass, [&](SelfLanes<L>& of) { of.set3(g->friction, {L(0.0), L(0.0), L(0.0)}); });
  }
  return simd::largest_of(largest);
}

// Updates lanes; returns the square of the change of the gap's velocity.
template <class L>
DRAPE_INLINE L lanes_sweep(SelfLanes<L>& of) {
  SelfGroup& g = of.g;
  const L zero(0.0), mass = of.get(g.mass), over = L(1.0) / mass;
  const simd::Vec<L> n = of.get3(g.n);
  of.velocities_load();
  simd::Vec<L> w = of.weighted(of.v);
  const L now = dot(w, n), stored = of.get(g.stored), normal = of.get(g.normal), stop = of.get(g.stop);
  const L rest = now - over * normal, after = (rest + of.get(g.given)) * of.get(g.yield);
  const L damped = select(gt(stored, zero), max((after - rest) * mass, zero), zero), more = damped - normal;
  const L stopped = max(fma(of.get(g.expected) - fma(over, more, now), mass, stop), zero);
  const L push = more + (stopped - stop), along = over * max(abs(more), abs(stopped - stop));
  of.set(g.normal, damped);
  of.set(g.stop, stopped);
  if (any(gt(stopped, zero))) g.presses = true;
  if (!g.presses) return along * along;
  of.push_along(n, push);
  w = w + n * (over * push);
  const SelfLevers<L> levers = of.levers();
  const simd::Vec<L> before = of.get3(g.friction),
                     j = of.friction_bounded(before - of.slip(levers, w) * mass);
  const simd::Vec<L> across = j - before;
  of.set3(g.friction, j);
  of.push_across(levers, across);
  of.velocities_store();
  return max(along * along, over * over * dot(across, across));
}

template <class L>
double self_sweep_lanes(const SelfContactPass& pass) {
  L largest(0.0);
  for (SelfGroup* g = pass.begin; g != pass.end; ++g)
    lanes_visit<L>(*g, pass, [&](SelfLanes<L>& of) { largest = max(largest, lanes_sweep(of)); });
  return __builtin_sqrt(simd::largest_of(largest));
}

template <class L>
double self_dissipated_lanes(const SelfContactPass& pass) {
  alignas(math::kLine) double sum[kGroupPairs] = {};
  for (SelfGroup* g = pass.begin; g != pass.end; ++g) {
    if (!g->presses) continue;
    lanes_visit<L>(*g, pass, [&](SelfLanes<L>& of) {
      for (int k = 0; k < 4; ++k) of.v[k] = (of.gathered(pass.old, k) + of.gathered(pass.v, k)) * L(0.5);
      const simd::Vec<L> w = of.weighted(of.v);
      const L lost = (of.get(g->normal) + of.get(g->stop) - of.get(g->stored)) * dot(of.get3(g->n), w);
      const L rubbed = dot(of.get3(g->friction), of.slip(of.levers(), w));
      L::store(sum + of.i, L::load(sum + of.i) - (lost + rubbed));
    });
  }
  double all_lanes = 0;
  for (double lane : sum) all_lanes += lane;
  return all_lanes;
}

template <class L>
void self_push_fixed_lanes(const SelfContactPass& pass) {
  for (SelfGroup* g = pass.begin; g != pass.end; ++g) {
    if (!g->presses) continue;
    lanes_visit<L>(*g, pass, [&](SelfLanes<L>& of) {
      of.velocities_load();
      L inverse[4];
      for (int k = 0; k < 4; ++k)
        inverse[k] = of.inverse[k], of.inverse[k] = L::gather(pass.pushed, g->at[k] + of.i);
      of.push_along(of.get3(g->n), of.get(g->normal) + of.get(g->stop));
      of.push_across(of.levers(), of.get3(g->friction));
      for (int k = 0; k < 4; ++k) of.inverse[k] = inverse[k];
      of.velocities_store();
    });
  }
}

template <class L>
constexpr SelfContactKernel self_contact_kernel() {
  return {self_points_lanes<L>, self_begin_lanes<L>, self_sweep_lanes<L>, self_dissipated_lanes<L>,
          self_push_fixed_lanes<L>};
}

}  // namespace
}  // namespace drape::contact
