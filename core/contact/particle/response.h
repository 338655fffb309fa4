// What a surface does to the particles near it, at the kick of t_n.
//
//   distance d = D (x - p), signed by the side; depth e = layer - d
//   normal     F/m = [omega^2 phi(e) - 2 zeta omega phi'(e) v_n]+,  centred damping as in -m c v
//              phi' = 3 t^2 - 2 t^3,  t = e/blend from 0 to 1;  1 beyond: C2 where they touch
//   stop       r_{n+1} is not nearer than `least`: what the penalty leaves of the approach is taken away
//   friction   the tangential velocity that is left, no more than mu of the normal impulse (Coulomb). What
//   sticks
//              has no tangential velocity at all: it does not creep.
//
// A kernel has moved the particles without this: v is the free v_{n+1/2}, r = r_n + drift v.
//
// Pins and welds share what one particle is given among all that they tie together, and several surfaces act
// on a particle one after the other, so that a single pass leaves a part undone. Such particles are given in
// advance what they got in the step before (carry); pins, welds and other surfaces leave what it lacks, and
// the pass takes it back and does it anew. At rest the two are the same. Stops are not carried on: what
// answers to a place one step late, without bound, swings.
#pragma once
#include <algorithm>

#include "contact/particle/contact_pass.h"
#include "simd/vector_lanes.h"

namespace drape::contact {
namespace {

template <class L>
struct ContactLanes {
  L kick, old_time, new_time, stop_rate, push_rate;
  L omega2, nu, layer, inverse_blend, blend, least;  // nu = 2 zeta omega
  L stick, slide;

  DRAPE_INLINE ContactLanes(const model::ContactLaw& law, const ContactCoefficients& c, double zeta)
      : kick(c.kick),
        old_time(c.old_time),
        new_time(c.new_time),
        stop_rate(c.stop_rate),
        push_rate(c.push_rate),
        omega2(law.omega2),
        nu(2 * zeta * __builtin_sqrt(law.omega2)),
        layer(law.distance),
        inverse_blend(1 / (kContactBlend * law.distance)),
        blend(kContactBlend * law.distance),
        least((1 - kContactDeepest) * law.distance),
        stick(law.friction[0]),
        slide(law.friction[1]) {}

  struct Normal {
    L impulse;  // P, what the normal velocity gains, at least 0
    L stop;     // of it, what the stop gives
    L stored;   // what the penalty's potential gives
  };
  // w_n of the free velocity, before that of v_{n-1/2}; stiff: of the penalty, over omega^2.
  DRAPE_INLINE Normal normal(L distance, L w, L before, L stiff) const {
    const L depth = layer - distance, t = min(max(depth * inverse_blend, L(0.0)), L(1.0));
    const L t2 = t * t, slope = t2 * fma(L(-2.0), t, L(3.0));
    const L phi = fma(blend, t2 * t * fma(L(-0.5), t, L(1.0)), max(depth - blend, L(0.0)));
    const L stored = kick * stiff * omega2 * phi, drag = nu * slope;
    const L after = (w + stored - drag * old_time * before) / fma(drag, new_time, L(1.0));
    const L workspace = distance - least;
    const L expected = L(0.0) - workspace * select(ge(workspace, L(0.0)), stop_rate, push_rate);
    const L soft = max(after - w, L(0.0)), all = max(soft, expected - w);
    return {all, all - soft, stored};
  }
};

template <class L>
struct ContactHit {
  simd::Vec<L> dv;
  L sticking, stored, stop;  // stored, stop: along n
};

template <class L>
DRAPE_INLINE ContactHit<L> contact_hit(const ContactLanes<L>& k, const simd::Vec<L>& n, L distance,
                                       const simd::Vec<L>& w, const simd::Vec<L>& before, L grip, L stiff) {
  const L wn = dot(w, n);
  const typename ContactLanes<L>::Normal normal = k.normal(distance, wn, dot(before, n), stiff);
  const L p = normal.impulse;
  const simd::Vec<L> wt = w - n * wn;
  const L speed = sqrt(dot(wt, wt));
  const auto touches = gt(p, L(0.0));
  const L hold = select(gt(grip, L(0.0)), k.stick, k.slide) * p;
  const auto sticks = ge(hold, speed);
  const L share = select(sticks, L(1.0), k.slide * p / max(speed, L(1e-300)));
  const L zero(0.0);
  return {{select(touches, fma(p, n.x, zero - share * wt.x), zero),
           select(touches, fma(p, n.y, zero - share * wt.y), zero),
           select(touches, fma(p, n.z, zero - share * wt.z), zero)},
          select(touches, select(sticks, L(1.0), zero), zero),
          select(touches, normal.stored, zero),
          select(touches, normal.stop, zero)};
}

// The pose of a body in lanes.
template <class L, bool kMoves>
struct PoseLanes {
  simd::Vec<L> origin, velocity, spin;
  L r[3][3];
  DRAPE_INLINE explicit PoseLanes(const model::BodyContact& b) {
    const auto lanes = [](const Vec3& v)
                           DRAPE_INLINE_LAMBDA { return simd::Vec<L>{L(v[0]), L(v[1]), L(v[2])}; };
    origin = lanes(b.motion.position);
    velocity = lanes(b.motion.velocity);
    spin = lanes(b.motion.angular_velocity);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) r[i][j] = L(b.rotation[i][j]);
  }
  DRAPE_INLINE simd::Vec<L> inward(const simd::Vec<L>& at) const {  // R^T (r - o)
    if constexpr (!kMoves) return at;
    const simd::Vec<L> d = at - origin;
    return {fma(r[0][0], d.x, fma(r[1][0], d.y, r[2][0] * d.z)),
            fma(r[0][1], d.x, fma(r[1][1], d.y, r[2][1] * d.z)),
            fma(r[0][2], d.x, fma(r[1][2], d.y, r[2][2] * d.z))};
  }
  DRAPE_INLINE simd::Vec<L> outward(const simd::Vec<L>& n) const {  // R n
    if constexpr (!kMoves) return n;
    return {fma(r[0][0], n.x, fma(r[0][1], n.y, r[0][2] * n.z)),
            fma(r[1][0], n.x, fma(r[1][1], n.y, r[1][2] * n.z)),
            fma(r[2][0], n.x, fma(r[2][1], n.y, r[2][2] * n.z))};
  }
  DRAPE_INLINE simd::Vec<L> velocity_at(const simd::Vec<L>& arm) const {  // V + w x (r - o)
    if constexpr (!kMoves) return {L(0.0), L(0.0), L(0.0)};
    return velocity + cross(spin, arm);
  }
};

// d and the unit vector along it, in the body's frame.
template <class L>
struct Gap {
  L distance;
  simd::Vec<L> n;
};
template <class L>
DRAPE_INLINE Gap<L> contact_gap(const model::ContactBlock& b, int i, const simd::Vec<L>& x, L s) {
  if (b.flat) return {s, {L::load(b.side[0] + i), L::load(b.side[1] + i), L::load(b.side[2] + i)}};
  const auto at = [&](const double* row) DRAPE_INLINE_LAMBDA { return L::load(row + i); };
  const simd::Vec<L> e = x - simd::Vec<L>{at(b.point[0]), at(b.point[1]), at(b.point[2])};
  const L xx = at(b.shape[0]), xy = at(b.shape[1]), xz = at(b.shape[2]), yy = at(b.shape[3]),
          yz = at(b.shape[4]), zz = at(b.shape[5]);
  const simd::Vec<L> u{fma(xx, e.x, fma(xy, e.y, xz * e.z)), fma(xy, e.x, fma(yy, e.y, yz * e.z)),
                       fma(xz, e.x, fma(yz, e.y, zz * e.z))};
  const L length = sqrt(dot(u, u)), sign = select(ge(s, L(0.0)), L(1.0), L(-1.0));
  const L inverse = sign / max(length, L(1e-300));
  const auto clear = gt(length, L(1e-12));      // on the surface itself only the side is known
  const auto none = gt(s, L(model::kFar / 2));  // a lane without a surface
  return {select(none, s, sign * length),
          {select(clear, u.x * inverse, at(b.side[0])), select(clear, u.y * inverse, at(b.side[1])),
           select(clear, u.z * inverse, at(b.side[2]))}};
}

// What a particle that is not alone is given in advance in the next step: all but stops, which would swing.
template <class L>
DRAPE_INLINE simd::Vec<L> warm_start_of(const ContactCoefficients& c, const simd::Vec<L>& n,
                                        const ContactHit<L>& hit, L shares, L light) {
  return (hit.dv - n * hit.stop) * select(gt(light, L(0.0)), shares / (L(c.kick) * light), L(0.0));
}
template <class L>
DRAPE_INLINE void warm_start_store(model::ContactBlock& b, int i, const simd::Vec<L>& carry) {
  L::store(b.warm_start[0] + i, carry.x);
  L::store(b.warm_start[1] + i, carry.y);
  L::store(b.warm_start[2] + i, carry.z);
  b.has_warm_start = b.has_warm_start || any(gt(abs(carry.x) + abs(carry.y) + abs(carry.z), L(0.0)));
}

// Sums over the blocks, one for each place of a block: the same bits for every width of a lane.
template <class L>
struct ContactSums {
  static constexpr int kParts = math::kRowUnit / L::kWidth;
  L sum[8][kParts];  // force x y z, torque x y z, dissipated, input
  DRAPE_INLINE ContactSums() {
    for (auto& row : sum)
      for (L& v : row) v = L(0.0);
  }
  DRAPE_INLINE void add(int part, const simd::Vec<L>& impulse, const simd::Vec<L>& arm) {
    const simd::Vec<L> torque = cross(arm, impulse);
    const L v[6] = {impulse.x, impulse.y, impulse.z, torque.x, torque.y, torque.z};
    for (int k = 0; k < 6; ++k) sum[k][part] = sum[k][part] + v[k];
  }
  void give(double* to) const {
    alignas(math::kLine) double lane[math::kRowUnit];
    for (int k = 0; k < 8; ++k) {
      for (int p = 0; p < kParts; ++p) L::store(lane + p * L::kWidth, sum[k][p]);
      for (double v : lane) to[k] += v;
    }
  }
};

// What a pass reads of every block.
DRAPE_INLINE void block_fetch(const model::ContactBlock& b) {
  for (const double* row : {b.side[0], b.side[1], b.side[2], b.offset, b.sticking}) __builtin_prefetch(row);
  __builtin_prefetch(&b.node);
}

DRAPE_INLINE simd::Row row_of(const ContactMoves& moves, std::size_t n) {
  return {moves.r[0] + n, moves.r[1] + n, moves.r[2] + n};
}

template <class L, bool kMoves>
void contact_run(const ContactPass& pass) {
  const PoseLanes<L, kMoves> pose(*pass.body);
  const ContactCoefficients& c = pass.c;
  ContactSums<L> sums;
  int lattice = 0;  // of the laws
  ContactLanes<L> law(pass.law[0], c, pass.damping), reported(pass.law[0], pass.reported, pass.damping);
  const model::ContactBlocks& blocks = pass.body->blocks;
  const ContactMoves* const moves = pass.moves;
  for (std::size_t k = 0; k < blocks.order.size(); ++k) {
    const model::ContactBlock& b = blocks.pool[blocks.order[k].block];
    model::ContactBlock* const to = moves ? moves->pool + blocks.order[k].block : nullptr;
    if (k + 1 < blocks.order.size()) block_fetch(blocks.pool[blocks.order[k + 1].block]);
    if (b.lattice != lattice) {
      lattice = b.lattice;
      law = ContactLanes<L>(pass.law[lattice], c, pass.damping);
      reported = ContactLanes<L>(pass.law[lattice], pass.reported, pass.damping);
    }
    const bool given = b.has_warm_start;  // in advance
    if (to) to->has_warm_start = false;
    for (int i = 0, part = 0; i < math::kRowUnit; i += L::kWidth, ++part) {
      const std::size_t n = b.node + std::size_t(i);
      const simd::ConstRow r{pass.r[0] + n, pass.r[1] + n, pass.r[2] + n};
      const simd::Row v{pass.v[0] + n, pass.v[1] + n, pass.v[2] + n};
      const L light = pass.inverse_mass_scale ? L::load(pass.inverse_mass_scale + n) : L(1.0);
      simd::Vec<L> free = simd::vec_load<L>(v, 0), moved = simd::vec_load<L>(r, 0);
      if (given) {
        const simd::Vec<L> carried_on =
            simd::Vec<L>{L::load(b.warm_start[0] + i), L::load(b.warm_start[1] + i),
                         L::load(b.warm_start[2] + i)} *
            (L(c.kick) * light);
        free = free - carried_on;
        moved = moved - carried_on * L(c.drift);
      }
      const simd::Vec<L> at = moved - free * L(c.drift);
      const simd::Vec<L> x = pose.inward(at), arm = at - pose.origin, carried = pose.velocity_at(arm),
                         w = free - carried;
      const L s =
          fma(L::load(b.side[0] + i), x.x,
              fma(L::load(b.side[1] + i), x.y, fms(L::load(b.side[2] + i), x.z, L::load(b.offset + i))));
      const L nearer = L(c.reach_time) * (abs(w.x) + abs(w.y) + abs(w.z));
      if (!any(gt(law.layer, s - nearer))) {
        if (to) L::store(to->sticking + i, L(0.0));
        if (given) {
          simd::vec_store(v, 0, free);
          if (to) simd::vec_store(row_of(*moves, n), 0, moved);
          if (to && pass.hit) pass.hit[b.node / math::kRowUnit] = 1;
          if (to) warm_start_store(*to, i, simd::Vec<L>{L(0.0), L(0.0), L(0.0)});
        }
        continue;
      }
      const Gap<L> gap = contact_gap(b, i, x, s);
      const simd::Vec<L> normal = pose.outward(gap.n);
      const L grip = L::load(b.sticking + i);
      const L stiff = pass.stiff ? L(1.0) / max(L::load(pass.stiff + n), L(1e-300)) : L(1.0);
      const double* kept = pass.old ? pass.old + 3 * math::kRowUnit * k + std::size_t(i) : nullptr;
      const simd::Vec<L> old = kept ? simd::Vec<L>{L::load(kept), L::load(kept + math::kRowUnit),
                                                   L::load(kept + 2 * math::kRowUnit)}
                                    : free;
      const ContactHit<L> hit = contact_hit(law, normal, gap.distance, w, old - carried, grip, stiff);
      const L inertia = select(gt(light, L(0.0)), L::load(pass.mass + n) / light, L(0.0)) * L(c.impulse);
      simd::Vec<L> impulse = hit.dv * (L(0.0) - inertia);
      if (to) L::store(to->sticking + i, hit.sticking);
      const simd::Vec<L> now = free + hit.dv;
      simd::vec_store(v, 0, now);
      if (to) simd::vec_store(row_of(*moves, n), 0, moved + hit.dv * L(c.drift));
      if (to && (given || pass.tied || b.shares)) {
        const L tied = pass.tied ? L::load(pass.tied + n) : L(0.0);
        if (pass.hit && (given || any(gt(tied * (abs(hit.dv.x) + abs(hit.dv.y) + abs(hit.dv.z)), L(0.0)))))
          pass.hit[b.node / math::kRowUnit] = 1;
        warm_start_store(*to, i, warm_start_of(c, normal, hit, max(tied, L::load(b.shared + i)), light));
      }
      if (pass.energy) {
        // J of the rest moves against v_mid - v_b, all of J with v_b
        const simd::Vec<L> middle = (old + now) * L(0.5) - carried;
        const L rest = dot(impulse, middle) + inertia * hit.stored * dot(normal, middle);
        sums.sum[6][part] = sums.sum[6][part] + rest;
        sums.sum[7][part] = sums.sum[7][part] - dot(impulse, carried);
      }
      if (pass.begins) {
        // the advance before has been told what turned its last half kick into v_n
        const simd::Vec<L> kicked = free - old * L(c.keep);
        const simd::Vec<L> half = (old + kicked * L(c.reported_share)) * L(1 / c.reported_centred) - carried;
        const ContactHit<L> was = contact_hit(reported, normal, gap.distance, half, half, grip, stiff);
        impulse = impulse + was.dv * (inertia * L(c.reported_centred / c.impulse));
      }
      sums.add(part, impulse, arm);
    }
  }
  sums.give(pass.sum);
}

// Over the lanes.
template <class L>
double largest_of(L a) {
  alignas(math::kLine) double lane[L::kWidth];
  L::store(lane, a);
  return *std::max_element(lane, lane + L::kWidth);
}
template <class L>
double smallest_of(L a) {
  alignas(math::kLine) double lane[L::kWidth];
  L::store(lane, a);
  return *std::min_element(lane, lane + L::kWidth);
}

// The largest speed of nodes.
template <class L>
DRAPE_INLINE double contact_speed(const ProximityPass& pass, std::size_t begin, std::size_t end) {
  L largest(0.0);
  for (std::size_t i = begin; i < end; i += L::kWidth) {
    const L x = L::load(pass.v[0] + i), y = L::load(pass.v[1] + i), z = L::load(pass.v[2] + i);
    largest = max(largest, fma(x, x, fma(y, y, z * z)));
  }
  return __builtin_sqrt(largest_of(largest));
}

// Blocks of nodes of which one has moved as far as it may, or will in the next step. Against a body that
// stays a group is not looked at as long as its fastest node could not have.
template <class L, bool kMoves>
std::size_t update_proximity_lanes(const ProximityPass& pass, std::size_t* due) {
  constexpr double kRounding = 1 - 1e-9;
  const PoseLanes<L, kMoves> pose(*pass.body);
  model::BodyContact& b = *pass.body;
  std::size_t count = 0;
  for (std::size_t begin = pass.begin; begin < pass.end; begin += kProximityGroup) {
    const std::size_t end = begin + kProximityGroup < pass.end ? begin + kProximityGroup : pass.end;
    if constexpr (!kMoves) {
      const double speed = contact_speed<L>(pass, begin, end);
      double& ease = b.group_clearance[begin / math::kRowUnit];
      ease -= __builtin_fabs(pass.drift) * speed;  // stages of order 4 and 6 go partly back
      if (ease > pass.ahead * speed) continue;
    }
    L left(model::kFar);
    for (std::size_t n = begin; n < end; n += math::kRowUnit) {
      bool moved = false;
      for (std::size_t i = n; i < n + math::kRowUnit; i += L::kWidth) {
        const simd::Vec<L> from{L::load(b.x.data() + i), L::load(b.y.data() + i), L::load(b.z.data() + i)};
        const simd::Vec<L> at{L::load(pass.r[0] + i), L::load(pass.r[1] + i), L::load(pass.r[2] + i)};
        const simd::Vec<L> v{L::load(pass.v[0] + i), L::load(pass.v[1] + i), L::load(pass.v[2] + i)};
        const simd::Vec<L> along = v - pose.velocity_at(at - pose.origin);
        const simd::Vec<L> d = pose.inward(at + along * L(pass.ahead)) - from;
        const L budget2 = L::load(b.free_distance2.data() + i);
        moved = moved || any(ge(dot(d, d), budget2));
        if constexpr (!kMoves) left = min(left, sqrt(budget2) - sqrt(dot(at - from, at - from)));
      }
      if (moved) due[count++] = n, left = L(0.0);
    }
    if constexpr (!kMoves) b.group_clearance[begin / math::kRowUnit] = kRounding * smallest_of(left);
  }
  return count;
}

template <class L>
constexpr ContactKernel contact_kernel() {
  return {{contact_run<L, false>, contact_run<L, true>},
          {update_proximity_lanes<L, false>, update_proximity_lanes<L, true>}};
}

}  // namespace
}  // namespace drape::contact
