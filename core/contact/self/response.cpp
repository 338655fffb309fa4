// Response of self-contact: the contact law of bodies (contact/particle/response.h) on pairs, whose impulses
// are equal and opposite. With K = sum W_k^2/m_k and the depth e = contact distance - d,
//
//   normal     P = [k phi(e) dt - 2 zeta sqrt(k/K) phi'(e) w_n dt]+,   the damping centred
//   stop       d_{n+1} >= kMin x contact distance: removes the approach that is left
//   friction   J on the tangential w, |J| <= mu P (Coulomb); a pair that sticks has no tangential w at all
//
// First come all penalties. Then damping, stops and friction act in turn, pair by pair, until nothing changes
// (projected Gauss-Seidel; Jourdan, Alart, Jean 1998). Friction is warm-started with that of the last step,
// so that cloth at rest needs one sweep and does not creep.
#include <algorithm>
#include <cmath>

#include "contact/self/mesh.h"
#include "contact/self/narrow_phase.h"
#include "math/smooth_ramp.h"
#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kSoft = 0.25;   // of omega^2 of contact with bodies: a particle is in several pairs
constexpr double kDamping = 1;   // zeta
constexpr double kThin = 1e-12;  // of the trace cubed: nodes on one line have no rotation
constexpr double kMin = 1 - kContactDeepest;  // of the contact distance: the smallest distance allowed

Vec3 times(const double* m, const Vec3& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}

// The inverse of a symmetric matrix xx xy xz yy yz zz; 0 where it has none.
void inverse_set(const double* i, double* to) {
  const double xx = i[3] * i[5] - i[4] * i[4], xy = i[2] * i[4] - i[1] * i[5], xz = i[1] * i[4] - i[2] * i[3];
  const double det = i[0] * xx + i[1] * xy + i[2] * xz, trace = i[0] + i[3] + i[5];
  const double over = det > kThin * trace * trace * trace ? 1 / det : 0;
  const double minor[6] = {
      xx, xy, xz, i[0] * i[5] - i[2] * i[2], i[1] * i[2] - i[0] * i[4], i[0] * i[3] - i[1] * i[1]};
  for (int k = 0; k < 6; ++k) to[k] = over * minor[k];
}

// Sets p_k and I^-1, once; only friction needs them.
void levers_set(const SelfContactPairs& pairs, SelfContactPair& t) {
  if (t.inverse[0] > 0) return;
  Vec3 mean{0, 0, 0};
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    t.lever[k] = pairs.place[t.node[std::size_t(k)]];
    mean += t.turn[k] * t.lever[k];
    sum += t.turn[k];
  }
  double inertia[6]{};
  for (int k = 0; k < 4; ++k) {
    t.lever[k] -= (1 / sum) * mean;
    const Vec3& p = t.lever[k];
    const double p2 = dot(p, p), u = t.turn[k];
    inertia[0] += u * (p2 - p[0] * p[0]);
    inertia[1] -= u * p[0] * p[1];
    inertia[2] -= u * p[0] * p[2];
    inertia[3] += u * (p2 - p[1] * p[1]);
    inertia[4] -= u * p[1] * p[2];
    inertia[5] += u * (p2 - p[2] * p[2]);
  }
  inverse_set(inertia, t.inverse);
}

void law_set(const System& system, const std::vector<SelfNode>& node, SelfContactPair& t) {
  const auto& of = system.self.lattice_of;
  const model::ContactLaw &a = system.lattices[std::size_t(of[t.node[0]])].contact_law,
                          &b = system.lattices[std::size_t(of[t.node[t.cross ? 2 : 1]])].contact_law;
  double smallest = INFINITY;
  t.inverse_effective_mass = 0;
  for (int k = 0; k < 4; ++k) {
    const SelfNode& n = node[std::size_t(t.at[k])];
    smallest = std::min(smallest, system.mass[n.node]);
    t.inverse_effective_mass += t.weight[k] * t.weight[k] * n.inverse;
  }
  t.stiffness = t.share * kSoft * std::min(a.omega2, b.omega2) * smallest / 2;
  t.drag =
      t.inverse_effective_mass > 0 ? 2 * kDamping * std::sqrt(t.stiffness / t.inverse_effective_mass) : 0;
  t.stick = (a.friction[0] + b.friction[0]) / 2;
  t.slide = (a.friction[1] + b.friction[1]) / 2;
}

// sum W_k of a field of the nodes
Vec3 gap_rate(const SelfContactPairs& pairs, const SelfContactPair& t, Vec3 SelfNode::* field) {
  Vec3 sum{0, 0, 0};
  for (int k = 0; k < 4; ++k) sum += t.weight[k] * (pairs.node[std::size_t(t.at[k])].*field);
  return sum;
}

// The tangential w.
Vec3 slip(const SelfContactPairs& pairs, SelfContactPair& t, Vec3 SelfNode::* field) {
  levers_set(pairs, t);
  Vec3 turning{0, 0, 0};
  for (int k = 0; k < 4; ++k)
    turning += t.turn[k] * cross(t.lever[k], pairs.node[std::size_t(t.at[k])].*field);
  const Vec3 w = gap_rate(pairs, t, field) - cross(times(t.inverse, turning), t.arm);
  return w - dot(w, t.n) * t.n;
}

void node_push(SelfNode& n, const Vec3& f) {
  n.v += n.inverse * f;
  n.impulse += f;
}

void normal_push(SelfContactPairs& pairs, const SelfContactPair& t, double p) {
  for (int k = 0; k < 4; ++k) node_push(pairs.node[std::size_t(t.at[k])], (t.weight[k] * p) * t.n);
}

void tangential_push(SelfContactPairs& pairs, SelfContactPair& t, const Vec3& j) {
  levers_set(pairs, t);
  const Vec3 turned = times(t.inverse, cross(t.arm, j));
  for (int k = 0; k < 4; ++k)
    node_push(pairs.node[std::size_t(t.at[k])], t.weight[k] * j - t.turn[k] * cross(turned, t.lever[k]));
}

// Applies the penalty; returns the change of w_n, m/s.
double normal_begin(const ContactCoefficients& c, SelfContactPairs& pairs, SelfContactPair& t) {
  const double blend = kSelfBlend * t.contact_distance, depth = t.contact_distance - t.distance;
  if (!(depth > 0)) return 0;
  const double u = std::min(depth / blend, 1.0);
  t.resist = t.inverse_effective_mass * t.drag * u * u * (3 - 2 * u);
  t.before = dot(t.n, gap_rate(pairs, t, &SelfNode::old));
  t.stored = t.normal = c.kick * t.stiffness * math::smooth_ramp(blend, depth);
  normal_push(pairs, t, t.normal);
  return t.inverse_effective_mass * t.normal;
}

// Updates P with damping, the impulses of all others fixed; returns the change of w_n, m/s.
double normal_sweep(const ContactCoefficients& c, SelfContactPairs& pairs, SelfContactPair& t) {
  if (t.stored == 0) return 0;
  const double rest = dot(t.n, gap_rate(pairs, t, &SelfNode::v)) - t.inverse_effective_mass * t.normal;
  const double after = (rest + t.inverse_effective_mass * t.stored - t.resist * c.old_time * t.before) /
                       (1 + t.resist * c.new_time);
  const double normal = std::max((after - rest) / t.inverse_effective_mass, 0.0), more = normal - t.normal;
  t.normal = normal;
  normal_push(pairs, t, more);
  return t.inverse_effective_mass * std::abs(more);
}

double stop_sweep(const ContactCoefficients& c, SelfContactPairs& pairs, SelfContactPair& t) {
  const double w = dot(t.n, gap_rate(pairs, t, &SelfNode::v)),
               clearance = t.distance - kMin * t.contact_distance;
  const double expected = -clearance * (clearance >= 0 ? c.stop_rate : c.push_rate);
  const double stop = std::max(t.stop + (expected - w) / t.inverse_effective_mass, 0.0), more = stop - t.stop;
  if (more == 0) return 0;
  t.stop = stop;
  normal_push(pairs, t, more);
  return t.inverse_effective_mass * std::abs(more);
}

// J, bounded by Coulomb friction.
Vec3 friction_bounded(SelfContactPair& t, const Vec3& j) {
  const double pressed = t.normal + t.stop, size = norm(j);
  t.slides = size > (t.stuck ? t.stick : t.slide) * pressed;
  if (!t.slides) return j;
  return size > 0 ? (t.slide * pressed / size) * j : j;
}

double friction_change(SelfContactPairs& pairs, SelfContactPair& t, const Vec3& expected) {
  const Vec3 j = friction_bounded(t, expected), more = j - t.friction;
  const double size = norm(more);
  if (size == 0) return 0;
  t.friction = j;
  tangential_push(pairs, t, more);
  return t.inverse_effective_mass * size;
}

}  // namespace

void self_prepare(const System& system, const State& s, bool inertia_of_fit, SelfContactPairs& pairs) {
  pairs.node.clear();
  pairs.index.resize(system.nodes, -1);
  for (SelfContactPair& t : pairs.pair)
    for (int k = 0; k < 4; ++k) {
      const model::NodeIndex n = t.node[std::size_t(k)];
      int& at = pairs.index[n];
      if (at < 0) {
        at = int(pairs.node.size());
        const double inverse_scale =
            inertia_of_fit && !s.inverse_mass_scale.empty() ? s.inverse_mass_scale[n] : 1;
        const bool fixed = system.self.fixed[n];
        pairs.node.push_back({n,
                              fixed,
                              fixed ? 0 : inverse_scale * system.inverse_mass[n],
                              system.mass[n] / inverse_scale,
                              {s.vx[n], s.vy[n], s.vz[n]},
                              {}});
      }
      t.at[k] = at;
    }
  for (const SelfNode& n : pairs.node) pairs.index[n.node] = -1;
  for (SelfContactPair& t : pairs.pair) law_set(system, pairs.node, t);
  std::erase_if(pairs.pair, [](const SelfContactPair& t) {
    return !(t.inverse_effective_mass > 0);
  });                               // held on both sides
  auto held = s.self.hold.begin();  // in the same order
  for (SelfContactPair& t : pairs.pair) {
    const auto before = [&](const model::SelfHold& h) {
      return h.cross != t.cross ? t.cross : h.node < t.node;
    };
    while (held != s.self.hold.end() && before(*held)) ++held;
    if (held == s.self.hold.end() || held->cross != t.cross || held->node != t.node) continue;
    t.hold = held->force - dot(held->force, t.n) * t.n;
    t.stuck = held->sticks;
  }
}

void self_respond(const ContactCoefficients& c, double tolerance, int sweeps, SelfContactPairs& pairs) {
  double first = 0;
  for (SelfContactPair& t : pairs.pair) first = std::max(first, normal_begin(c, pairs, t));
  for (SelfContactPair& t : pairs.pair)
    if (t.normal > 0) friction_change(pairs, t, c.kick * t.hold);
  for (int k = 0; k < sweeps; ++k) {
    double largest = 0;
    for (SelfContactPair& t : pairs.pair) {
      largest = std::max(largest, normal_sweep(c, pairs, t));
      largest = std::max(largest, stop_sweep(c, pairs, t));
      if (!(t.normal + t.stop > 0) && dot(t.friction, t.friction) == 0) continue;
      const Vec3 w = slip(pairs, t, &SelfNode::v);
      largest = std::max(largest, friction_change(pairs, t, t.friction - (1 / t.inverse_effective_mass) * w));
    }
    if (k == 0) first = std::max(first, largest);
    if (!(largest > tolerance * first)) break;
  }
}

double self_dissipated(SelfContactPairs& pairs) {
  double sum = 0;
  for (SelfContactPair& t : pairs.pair) {
    if (!(t.stored + t.stop > 0)) continue;
    const double w = dot(t.n, gap_rate(pairs, t, &SelfNode::old) + gap_rate(pairs, t, &SelfNode::v)) / 2;
    const Vec3 along = 0.5 * (slip(pairs, t, &SelfNode::old) + slip(pairs, t, &SelfNode::v));
    sum -= (t.normal + t.stop - t.stored) * w + dot(t.friction, along);
  }
  return sum;
}

}  // namespace drape::contact
