// The contact law of particles near a surface, at the kick of t_n.
//
//   distance d = |D (x - p)|, signed by the side;  depth e = contact distance - d
//   normal     F/m = [omega^2 phi(e) - 2 zeta omega phi'(e) v_n]+,  centred damping as in -m c v
//              phi' = 3 t^2 - 2 t^3,  t = e/blend from 0 to 1;  1 beyond: C2 where they touch
//   stop       r_{n+1} is not nearer than min_distance + sink: removes the approach that the penalty leaves
//   friction   removes the tangential velocity, with at most mu of the normal impulse (Coulomb). A particle
//              that sticks has no tangential velocity at all, so it does not creep.
//
// The lattice kernel has moved the particles without contact: v is the free v_{n+1/2}, r = r_n + drift v.
//
// Pins and welds spread the impulse on one particle over all that they tie together, and several surfaces act
// on a particle one after the other. Such particles get a warm start: the impulse of the last step, before
// pins and welds act. The pass then replaces it by the present impulse; at rest the two are equal. Contact
// and constraints respond in turns until they agree (dynamics/agreement.h): a pass that goes on takes the
// impulse of the pass before out of the velocity and computes it anew. The impulse of a stop is warm-started
// in a fit, which comes to rest; in a motion, where it ends an impact, it would be a blow one step late.
#pragma once
#include <algorithm>

#include "contact/particle/contact_pass.h"
#include "contact/particle/law_lanes.h"
#include "simd/vector_lanes.h"

namespace drape::contact {
namespace {

template <class L>
struct ContactLanes {
  L kick, old_time, new_time, stop_rate, push_rate;
  L omega2, nu, contact_distance, inverse_blend, blend, min_distance;  // nu = 2 zeta omega
  L stick, slide;

  DRAPE_INLINE ContactLanes(const model::ContactLaw& law, const ContactCoefficients& c, double zeta)
      : kick(c.kick),
        old_time(c.old_time),
        new_time(c.new_time),
        stop_rate(c.stop_rate),
        push_rate(c.push_rate),
        omega2(law.omega2),
        nu(2 * zeta * __builtin_sqrt(law.omega2)),
        contact_distance(law.distance),
        inverse_blend(1 / (kContactBlend * law.distance)),
        blend(kContactBlend * law.distance),
        min_distance((1 - kContactDeepest) * law.distance),
        stick(law.friction[0]),
        slide(law.friction[1]) {}

  struct Normal {
    L impulse;  // P, gain of the normal velocity, m/s, at least 0
    L stop;     // the part of it that the stop adds
    L stored;   // the part that the potential of the penalty gives
  };
  // w: normal velocity of the free motion; before: that of v_{n-1/2}; penalty_scale: factor on omega^2; sink:
  // m, by which the stop keeps the particle farther away.
  DRAPE_INLINE Normal normal(L distance, L sink, L w, L before, L penalty_scale) const {
    const L depth = contact_distance - distance, t = min(max(depth * inverse_blend, L(0.0)), L(1.0));
    const RampLanes<L> ramp(blend, depth, t);
    const L stored = kick * penalty_scale * omega2 * ramp.phi, drag = nu * ramp.slope;
    const L after = (w + stored - drag * old_time * before) / fma(drag, new_time, L(1.0));
    const L expected = stop_velocity(distance - (min_distance + sink), stop_rate, push_rate);
    const L soft = max(after - w, L(0.0)), all = max(soft, expected - w);
    return {all, all - soft, stored};
  }
};

// Change of one particle's velocity, m/s; stored and stop are along n. sticking: 1 or 0.
template <class L>
struct ContactHit {
  simd::Vec<L> dv;
  L sticking, stored, stop;
};

template <class L>
// NOLINTNEXTLINE(readability-function-size): a kernel, whose parts share their registers
DRAPE_INLINE ContactHit<L> contact_hit(const ContactLanes<L>& k, const simd::Vec<L>& n, L distance, L sink,
                                       const simd::Vec<L>& w, const simd::Vec<L>& before, L sticking,
                                       L penalty_scale) {
  const L wn = dot(w, n);
  const typename ContactLanes<L>::Normal normal = k.normal(distance, sink, wn, dot(before, n), penalty_scale);
  const L p = normal.impulse;
  const simd::Vec<L> wt = w - n * wn;
  const L speed = sqrt(dot(wt, wt));
  const auto touches = gt(p, L(0.0));
  const L hold = select(gt(sticking, L(0.0)), k.stick, k.slide) * p;
  const auto sticks = ge(hold, speed);
  const L share = select(sticks, L(1.0), k.slide * p / max(speed, L(1e-300)));
  const L zero(0.0);
  return {{select(touches, fma(p, n.x, zero - share * wt.x), zero),
           select(touches, fma(p, n.y, zero - share * wt.y), zero),
           select(touches, fma(p, n.z, zero - share * wt.z), zero)},
          select(touches, select(sticks, L(1.0), zero), zero),
          normal.stored,
          select(touches, normal.stop, zero)};
}

// The pose of a body in lanes.
template <class L, bool kMoves>
struct PoseLanes {
  simd::Vec<L> origin, velocity, angular_velocity;
  L r[3][3];
  DRAPE_INLINE explicit PoseLanes(const model::BodyContact& b) {
    const auto lanes = [](const Vec3& v)
                           DRAPE_INLINE_LAMBDA { return simd::Vec<L>{L(v[0]), L(v[1]), L(v[2])}; };
    origin = lanes(b.motion.position);
    velocity = lanes(b.motion.velocity);
    angular_velocity = lanes(b.motion.angular_velocity);
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
    return velocity + cross(angular_velocity, arm);
  }
};

// Signed distance d (m) and the unit vector along it, in the frame of the body.
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
  const auto off_surface = gt(length, L(1e-12));  // on the surface only the side is known
  const auto none = gt(s, L(model::kFar / 2));    // a lane without a surface
  return {
      select(none, s, sign * length),
      {select(off_surface, u.x * inverse, at(b.side[0])), select(off_surface, u.y * inverse, at(b.side[1])),
       select(off_surface, u.z * inverse, at(b.side[2]))}};
}

// The warm start of the next step (m/s^2), of particles that several constraints act on.
template <class L>
DRAPE_INLINE simd::Vec<L> warm_start_of(const ContactCoefficients& c, const simd::Vec<L>& n,
                                        const ContactHit<L>& hit, L shares, L inverse_scale) {
  return (hit.dv - n * (L(1 - c.warm_stop) * hit.stop)) *
         select(gt(inverse_scale, L(0.0)), shares / (L(c.kick) * inverse_scale), L(0.0));
}
template <class L>
DRAPE_INLINE void warm_start_store(model::ContactBlock& b, int i, const simd::Vec<L>& next) {
  L::store(b.warm_start[0] + i, next.x);
  L::store(b.warm_start[1] + i, next.y);
  L::store(b.warm_start[2] + i, next.z);
  b.has_warm_start = b.has_warm_start || any(gt(abs(next.x) + abs(next.y) + abs(next.z), L(0.0)));
}

// Sums over the blocks, one for each place within a block, so that every lane width gives the same bits.
template <class L>
struct ContactSums {
  static constexpr int kParts = math::kRowUnit / L::kWidth;
  L sum[6][kParts];  // force x y z, torque x y z
  DRAPE_INLINE ContactSums() {
    for (auto& row : sum)
      for (L& v : row) v = L(0.0);
  }
  DRAPE_INLINE void add(int part, const simd::Vec<L>& impulse, const simd::Vec<L>& arm) {
    const simd::Vec<L> torque = cross(arm, impulse);
    const L v[6] = {impulse.x, impulse.y, impulse.z, torque.x, torque.y, torque.z};
    for (int k = 0; k < 6; ++k) sum[k][part] = sum[k][part] + v[k];
  }
  void add_to(double* to) const {
    alignas(math::kLine) double lane[math::kRowUnit];
    for (int k = 0; k < 6; ++k) {
      for (int p = 0; p < kParts; ++p) L::store(lane + p * L::kWidth, sum[k][p]);
      for (double v : lane) to[k] += v;
    }
  }
};

template <class L>
DRAPE_INLINE void vector_store(double* rows, const simd::Vec<L>& v) {
  L::store(rows, v.x);
  L::store(rows + math::kRowUnit, v.y);
  L::store(rows + 2 * math::kRowUnit, v.z);
}
template <class L>
DRAPE_INLINE simd::Vec<L> vector_load(const double* rows) {
  return {L::load(rows), L::load(rows + math::kRowUnit), L::load(rows + 2 * math::kRowUnit)};
}

// a in the lanes of the mask, else b.
template <class L, class Mask>
DRAPE_INLINE simd::Vec<L> select_vector(const Mask& mask, const simd::Vec<L>& a, const simd::Vec<L>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

// Prefetches what a pass reads of every block.
DRAPE_INLINE void block_fetch(const model::ContactBlock& b) {
  for (const double* row : {b.side[0], b.side[1], b.side[2], b.offset, b.sink, b.sticking})
    __builtin_prefetch(row);
  __builtin_prefetch(&b.node);
}

DRAPE_INLINE simd::Row row_of(const ContactMoves& moves, std::size_t n) {
  return {moves.r[0] + n, moves.r[1] + n, moves.r[2] + n};
}

template <class L, bool kMoves>
// NOLINTNEXTLINE(readability-function-size): a kernel, whose parts share their registers
void contact_run(const ContactPass& pass) {
  const PoseLanes<L, kMoves> pose(*pass.body);
  const ContactCoefficients& c = pass.c;
  ContactSums<L> sums;
  int lattice = 0;  // that the two laws belong to
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
    const bool warm_started = b.has_warm_start && !pass.on, shares = pass.tied || b.shares;
    double* const response = shares ? pass.response + kResponseRows * math::kRowUnit * k : nullptr;
    if (pass.on && !shares) continue;
    if (to && !pass.on) to->has_warm_start = false;
    for (int i = 0, part = 0; i < math::kRowUnit; i += L::kWidth, ++part) {
      const std::size_t n = b.node + std::size_t(i);
      const simd::ConstRow r{pass.r[0] + n, pass.r[1] + n, pass.r[2] + n};
      const simd::Row v{pass.v[0] + n, pass.v[1] + n, pass.v[2] + n};
      const L inverse_scale = pass.inverse_mass_scale ? L::load(pass.inverse_mass_scale + n) : L(1.0);
      const simd::Vec<L> v_before = simd::vec_load<L>(v, 0), r_before = simd::vec_load<L>(r, 0);
      simd::Vec<L> free = v_before, moved = r_before;
      const L tied = pass.tied ? L::load(pass.tied + n) : L(0.0),
              shared = shares ? max(tied, L::load(b.shared + i)) : L(0.0);
      const auto responds = gt(pass.on ? shared : L(1.0), L(0.0));  // other lanes stay as they are
      if (!any(responds)) continue;
      simd::Vec<L> given{L(0.0), L(0.0), L(0.0)};  // what the particle has got of it already
      if (warm_started || pass.on) {
        given = pass.on ? vector_load<L>(response + i)
                        : simd::Vec<L>{L::load(b.warm_start[0] + i), L::load(b.warm_start[1] + i),
                                       L::load(b.warm_start[2] + i)} *
                              (L(c.kick) * inverse_scale);
        free = free - given;
        moved = moved - given * L(c.drift);
      }
      const simd::Vec<L> at = moved - free * L(c.drift);
      const simd::Vec<L> x = pose.inward(at), arm = at - pose.origin, body_velocity = pose.velocity_at(arm),
                         w = free - body_velocity;
      const L s =
          fma(L::load(b.side[0] + i), x.x,
              fma(L::load(b.side[1] + i), x.y, fms(L::load(b.side[2] + i), x.z, L::load(b.offset + i))));
      const L nearer = L(c.reach_time) * (abs(w.x) + abs(w.y) + abs(w.z));
      if (!pass.on && !any(gt(law.contact_distance, s - nearer))) {
        if (response) {
          vector_store(response + i, simd::Vec<L>{L(0.0), L(0.0), L(0.0)});
          L::store(response + i + 3 * math::kRowUnit, L(0.0));
        }
        if (to) L::store(to->sticking + i, L(0.0));
        if (warm_started) {
          simd::vec_store(v, 0, free);
          if (to) simd::vec_store(row_of(*moves, n), 0, moved);
          if (to && pass.touched) pass.touched[b.node / math::kRowUnit] = 1;
          if (to) warm_start_store(*to, i, simd::Vec<L>{L(0.0), L(0.0), L(0.0)});
        }
        continue;
      }
      const Gap<L> gap = contact_gap(b, i, x, s);
      const simd::Vec<L> normal = pose.outward(gap.n);
      const L sticking = pass.on ? L::load(response + i + 3 * math::kRowUnit) : L::load(b.sticking + i),
              sink = L::load(b.sink + i);
      const L penalty_scale = pass.inverse_penalty_scale
                                  ? L(1.0) / max(L::load(pass.inverse_penalty_scale + n), L(1e-300))
                                  : L(1.0);
      const double* kept = pass.old ? pass.old + 3 * math::kRowUnit * k + std::size_t(i) : nullptr;
      const simd::Vec<L> old = kept ? simd::Vec<L>{L::load(kept), L::load(kept + math::kRowUnit),
                                                   L::load(kept + 2 * math::kRowUnit)}
                                    : free;
      const ContactHit<L> hit =
          contact_hit(law, normal, gap.distance, sink, w, old - body_velocity, sticking, penalty_scale);
      const L inertia =
          select(gt(inverse_scale, L(0.0)), L::load(pass.mass + n) / inverse_scale, L(0.0)) * L(c.impulse);
      const simd::Vec<L> zero{L(0.0), L(0.0), L(0.0)}, more = select_vector(responds, hit.dv - given, zero);
      if (pass.change) {
        const simd::Vec<L>& by = pass.on ? more : hit.dv;
        *pass.change = std::max(*pass.change, simd::largest_of(max(max(abs(by.x), abs(by.y)), abs(by.z))));
      }
      if (response) {
        vector_store(response + i, select_vector(responds, hit.dv, given));
        L::store(response + i + 3 * math::kRowUnit, sticking);
      }
      simd::Vec<L> impulse = (pass.on ? more : hit.dv) * (L(0.0) - inertia);
      if (to) L::store(to->sticking + i, select(responds, hit.sticking, L::load(to->sticking + i)));
      simd::vec_store(v, 0, select_vector(responds, free + hit.dv, v_before));
      if (to)
        simd::vec_store(row_of(*moves, n), 0, select_vector(responds, moved + hit.dv * L(c.drift), r_before));
      if (to && (warm_started || shares)) {
        if (pass.touched &&
            (warm_started || any(gt(tied * (abs(hit.dv.x) + abs(hit.dv.y) + abs(hit.dv.z)), L(0.0)))))
          pass.touched[b.node / math::kRowUnit] = 1;
        warm_start_store(*to, i, warm_start_of(c, normal, hit, shared, inverse_scale));
      }
      if (pass.given) {
        double* const of = pass.given + kGivenRows * math::kRowUnit * k + std::size_t(i);
        const auto keep = [&](double* rows, const simd::Vec<L>& value) DRAPE_INLINE_LAMBDA {
          vector_store(rows, select_vector(responds, value, vector_load<L>(rows)));
        };
        keep(of, hit.dv * (L(0.0) - inertia));
        keep(of + 3 * math::kRowUnit, normal * (inertia * hit.stored));
        keep(of + 6 * math::kRowUnit, body_velocity);
      }
      if (pass.begins) {
        // the advance before has reported the impulse of its last half kick, which gave v_n
        const simd::Vec<L> kicked = free - old * L(c.decay);
        const simd::Vec<L> half =
            (old + kicked * L(c.reported_share)) * L(1 / c.reported_centred) - body_velocity;
        const ContactHit<L> half_kick =
            contact_hit(reported, normal, gap.distance, sink, half, half, sticking, penalty_scale);
        impulse = impulse + half_kick.dv * (inertia * L(c.reported_centred / c.impulse));
      }
      sums.add(part, impulse, arm);
    }
  }
  sums.add_to(pass.sum);
}

// The largest speed (m/s) of the nodes begin .. end - 1.
template <class L>
DRAPE_INLINE double contact_speed(const ProximityPass& pass, std::size_t begin, std::size_t end) {
  L largest(0.0);
  for (std::size_t i = begin; i < end; i += L::kWidth) {
    const L x = L::load(pass.v[0] + i), y = L::load(pass.v[1] + i), z = L::load(pass.v[2] + i);
    largest = max(largest, fma(x, x, fma(y, y, z * z)));
  }
  return __builtin_sqrt(simd::largest_of(largest));
}

// Collects the blocks in which a node has moved by its free distance, or will in the next step. Against a
// body that stays, a group is skipped as long as its fastest node cannot have used up the group clearance.
template <class L, bool kMoves>
std::size_t update_proximity_lanes(const ProximityPass& pass, std::size_t* stale) {
  constexpr double kRounding = 1 - 1e-9;
  const PoseLanes<L, kMoves> pose(*pass.body);
  model::BodyContact& b = *pass.body;
  std::size_t count = 0;
  for (std::size_t begin = pass.begin; begin < pass.end; begin += kProximityGroup) {
    const std::size_t end = begin + kProximityGroup < pass.end ? begin + kProximityGroup : pass.end;
    if constexpr (!kMoves) {
      const double speed = contact_speed<L>(pass, begin, end);
      double& clearance = b.group_clearance[begin / math::kRowUnit];
      clearance -= __builtin_fabs(pass.drift) * speed;  // some stages of order 4 and 6 go back
      if (clearance > pass.ahead * speed) continue;
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
        const L free_distance2 = L::load(b.free_distance2.data() + i);
        moved = moved || any(ge(dot(d, d), free_distance2));
        if constexpr (!kMoves) left = min(left, sqrt(free_distance2) - sqrt(dot(at - from, at - from)));
      }
      if (moved) stale[count++] = n, left = L(0.0);
    }
    if constexpr (!kMoves) b.group_clearance[begin / math::kRowUnit] = kRounding * simd::smallest_of(left);
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
