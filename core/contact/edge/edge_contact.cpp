// Response of links and cells to sharp features: the contact law of particles (contact/particle/response.h)
// on the gap of a pair. With K = sum W_k^2/m_k, an impulse J on the velocity of the gap, sum W_k v_k, changes
// the velocities of the nodes by W_k J/m_k and that of the gap by K J.
//
// The stiffness is k = min(m_k) W^2/2. It does not change as the closest point slides along a link, so that
// the penalty has an energy. (A fit has no energy balance; there it is W^2/(2 K).) S = sum |W_k| is 1 on a
// link and up to 2 beyond its end; the penalty is divided by S^2, so that k K/S^2 <= W^2/2.
#include "contact/edge/edge_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/edge/elements.h"
#include "contact/edge/pairs.h"
#include "contact/particle/contact.h"
#include "contact/particle/response.h"
#include "math/smooth_ramp.h"
#include "simd/lane_scalar.h"

namespace drape::contact {
namespace {

using namespace math::vector3;
using Lane = simd::ScalarLane<false>;

constexpr double kSoft = 0.5;        // of W^2 of a particle
constexpr double kConverged = 1e-3;  // of the first change of a velocity: sweeps end below it
constexpr int kSweeps = 10;          // maximum
constexpr double kRounding = 1e-9;   // m, of travel

simd::Vec<Lane> lanes(const Vec3& v) { return {v[0], v[1], v[2]}; }
Vec3 vector(const simd::Vec<Lane>& v) { return {v.x.v, v.y.v, v.z.v}; }

// Whether a pair belongs outside the body. So does one that was outside before. Else an element past a
// feature is cut by it where it is in the solid; elsewhere it is beyond the body, as below a plate, or in the
// groove behind a fold.
bool belongs_out(const model::Body& body, const model::EdgePair& pair, const EdgeGap& gap) {
  if (!gap.over) return false;
  return gap.distance > 0 || pair.outside || (body.mesh.surface.solid && -gap.distance < gap.inside);
}

EdgeContactPair pair_of(const System& system, const State& s, std::size_t b, std::size_t pair,
                        const model::EdgeElement& element, const EdgeGap& gap) {
  const model::Body& body = system.bodies[b];
  EdgeContactPair t{b, pair, &element, gap, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0};
  double smallest = INFINITY, inverse_effective_mass = 0;  // kg, 1/kg, of inertia
  for (int k = 0; k < element.weights(); ++k) {
    const std::size_t n = element.node[k];
    const double w = gap.weight[k];
    t.at += w * Vec3{s.x[n], s.y[n], s.z[n]};
    t.old += w * Vec3{s.vx[n], s.vy[n], s.vz[n]};
    const double inertia = model::inertia_of(system, s, n);
    smallest = std::min(smallest, inertia);
    inverse_effective_mass += w * w / inertia;
  }
  t.gap.n = model::pose_outward(body, s.body[b], gap.n);
  t.body_velocity = model::pose_velocity(body, s.body[b], t.at);
  t.stiffness = gap.share * kSoft * system.lattices[std::size_t(element.lattice)].contact_law.omega2 *
                (system.fit ? 1 / inverse_effective_mass : smallest);
  return t;
}

// Energy (J) that the penalty of a pair stores.
double energy_of(const System& system, const EdgeContactPair& t) {
  const double contact_distance = system.lattices[std::size_t(t.element->lattice)].contact_law.distance;
  const double depth = std::min(contact_distance - t.gap.distance, contact_distance);
  return depth > 0 ? t.stiffness * math::smooth_ramp_integral(kContactBlend * contact_distance, depth) : 0;
}

// Finds the pairs that touch, or may within the reach of the step. With `moves`, records in it the side and
// energy of each pair. Returns the energy (J) that pairs have lost since the last step because their share
// fell, or because they do not touch any more.
double find(const System& system, const State& s, State* moves, std::vector<EdgeContactPair>& touches) {
  double lost = 0;
  touches.clear();
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    const model::EdgeContact& c = s.body[b].edges;
    for (std::size_t p = 0; p < c.pair.size(); ++p) {
      if (c.active_after_travel[p] > c.travel + c.reach + kRounding) continue;
      const model::EdgePair& pair = c.pair[p];
      const model::EdgeElement& element = system.edge_elements.element[pair.element];
      const model::Lattice& l = system.lattices[std::size_t(element.lattice)];
      Vec3 x[6];
      edge_element_places(system, s, b, element, x);
      const EdgeGap gap = edge_gap(element, system.bodies[b].sharp.feature[pair.feature], x, edge_sine(l));
      const double left = gap.clearance - l.contact_law.distance;
      const bool asleep = left > c.reach;
      const bool out = !asleep && belongs_out(system.bodies[b], pair, gap);
      if (moves) {
        model::EdgeContact& to = moves->body[b].edges;
        to.active_after_travel[p] = asleep ? to.travel + left : to.travel;
        to.pair[p].outside = out;
        if (!out) to.pair[p].sticking = 0, to.pair[p].warm_start = {0, 0, 0};
      }
      double stored = 0, kept = pair.stored;  // J: now; and now with the last share
      if (out) {
        touches.push_back(pair_of(system, s, b, p, element, gap));
        stored = energy_of(system, touches.back());
        if (gap.share > 0) kept = pair.share / gap.share * stored;
      }
      lost += kept - stored;
      if (moves) {
        moves->body[b].edges.pair[p].share = out ? gap.share : 0;
        moves->body[b].edges.pair[p].stored = stored;
      }
    }
  }
  return lost;
}

// The law of a pair, constant within a pass.
struct PairLaw {
  std::array<double, 4> over;     // W_k/m_k, 1/kg of inertia: change of a node's velocity per impulse
  double inverse_effective_mass;  // K
  ContactLanes<Lane> lanes;
};

std::array<double, 4> pair_over(const System& system, const EdgeContactPair& t, const EdgeField& f) {
  std::array<double, 4> over{};
  for (int k = 0; k < t.element->weights(); ++k) {
    const std::size_t n = t.element->node[k];
    over[std::size_t(k)] =
        t.gap.weight[k] * system.inverse_mass[n] * (f.inverse_mass_scale ? f.inverse_mass_scale[n] : 1);
  }
  return over;
}

PairLaw pair_law(const System& system, const State& s, const EdgeContactPair& t, const ContactCoefficients& c,
                 const EdgeField& f) {
  const std::array<double, 4> over = pair_over(system, t, f);
  double inverse_effective_mass = 0;
  for (std::size_t k = 0; k < 4; ++k) inverse_effective_mass += t.gap.weight[k] * over[k];
  const model::Body& body = system.bodies[t.body];
  model::ContactLaw law = current_law(system, s, body, system.lattices[std::size_t(t.element->lattice)]);
  law.omega2 = t.stiffness * inverse_effective_mass;
  return {over, inverse_effective_mass, ContactLanes<Lane>(law, c, body.damping)};
}

// Adds an impulse J on the gap to the field.
void push(const EdgeContactPair& t, const std::array<double, 4>& over, const ContactCoefficients& c,
          const EdgeField& f, const Vec3& j) {
  for (int k = 0; k < t.element->weights(); ++k) {
    const std::size_t n = t.element->node[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const double dv = over[std::size_t(k)] * j[i];
      f.v[i][n] += dv;
      if (f.r[i]) f.r[i][n] += c.drift * dv;
    }
  }
}

Vec3 gap_velocity(const EdgeContactPair& t, const double* const v[3]) {
  Vec3 sum{0, 0, 0};
  for (int k = 0; k < t.element->weights(); ++k)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += t.gap.weight[k] * v[i][t.element->node[k]];
  return sum;
}

}  // namespace

double edge_store_velocities(const System& system, State& s, std::vector<EdgeContactPair>& touches) {
  return find(system, s, &s, touches);
}

double edge_record_sides(const System& system, EdgeScratch& scratch, State& s, double moved) {
  for (model::BodyContact& body : s.body) body.edges.reach = std::max(body.edges.reach, moved);
  return find(system, s, &s, scratch.touches);
}

double edge_narrow_phase(const System& system, const State& s, std::vector<EdgeContactPair>& touches) {
  return find(system, s, nullptr, touches);
}

void edge_warm_start(const System& system, const State& s, const EdgePass& pass) {
  for (const EdgeContactPair& t : pass.touches)
    push(t, pair_over(system, t, pass.field), pass.c, pass.field,
         pass.c.kick * s.body[t.body].edges.pair[t.pair].warm_start);
}

// The impulse of a pair in a pass.
namespace {
struct Given {
  Vec3 impulse{0, 0, 0};  // J, N s per what damping takes out of v after the kick
  double stored = 0;      // the part of it along n that the potential of the penalty gives
  double stop = 0;        // likewise, of the stop
  double sticking = 0;
  double stuck = 0;        // sticking in the last step
  Vec3 reported{0, 0, 0};  // the part of the impulse that the loads already have
};
}  // namespace

struct EdgeResponse {
  std::vector<Given> given;   // [touches]
  std::vector<PairLaw> laws;  // [touches]
  double factor = 1;          // ContactCoefficients::impulse
};

void EdgeResponseEnd::operator()(EdgeResponse* response) const { delete response; }

EdgeScratch edge_scratch_make() {
  EdgeScratch scratch;
  scratch.response.reset(new EdgeResponse);
  return scratch;
}

namespace {

// Updates J of a pair, with the impulses of all others fixed. Returns the change of the gap's velocity, m/s.
// An element past the feature is pushed as if it were at the feature itself, by 1/50 of the contact distance
// a step: faster, it would be thrown off.
double pair_respond(const EdgeContactPair& t, const PairLaw& law, const ContactCoefficients& c,
                    const EdgeField& f, Given& given) {
  const double k = law.inverse_effective_mass;
  push(t, law.over, c, f, -1.0 * given.impulse);
  const Vec3 free = gap_velocity(t, f.v), old = c.old_time > 0 || c.new_time > 0 ? t.old : free;
  const ContactHit<Lane> hit =
      contact_hit(law.lanes, lanes(t.gap.n), Lane(std::max(t.gap.distance, 0.0)), Lane(0.0),
                  lanes(free - t.body_velocity), lanes(old - t.body_velocity), Lane(given.stuck), Lane(1.0));
  const Vec3 impulse = (1 / k) * vector(hit.dv);
  const double change = k * norm(impulse - given.impulse);
  given.impulse = impulse;
  given.stored = hit.stored.v / k, given.stop = hit.stop.v / k, given.sticking = hit.sticking.v;
  push(t, law.over, c, f, impulse);
  return change;
}

void load_add(const State& s, const EdgeContactPair& t, const ContactCoefficients& c, const Given& given,
              std::vector<math::Wrench>& load) {
  const Vec3 impulse = -c.impulse * (given.impulse - given.reported);
  load[t.body].force += impulse;
  load[t.body].torque += cross(t.at - s.body[t.body].motion.position, impulse);
}

}  // namespace

double edge_respond(const System& system, const State& s, const EdgePass& pass, EdgeScratch& scratch,
                    EdgeSums& sums) {
  const auto& [touches, c, f, moves, on] = pass;
  std::vector<Given>& given = scratch.response->given;
  std::vector<PairLaw>& laws = scratch.response->laws;
  sums.load.assign(s.body.size(), math::Wrench{});
  scratch.response->factor = c.impulse;
  if (!on) {
    given.assign(touches.size(), Given{});
    laws.clear();
    for (std::size_t k = 0; k < touches.size(); ++k) {
      laws.push_back(pair_law(system, s, touches[k], c, f));
      const model::EdgePair& pair = s.body[touches[k].body].edges.pair[touches[k].pair];
      given[k].impulse = c.kick * pair.warm_start;
      given[k].stuck = pair.sticking;
    }
  }
  double first = 0, change = 0;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double largest = 0;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      largest = std::max(largest, pair_respond(touches[k], laws[k], c, f, given[k]));
      if (sweep == 0) first = std::max(first, laws[k].inverse_effective_mass * norm(given[k].impulse));
    }
    change = std::max(change, on ? largest : first);
    if (!(largest > kConverged * first)) break;
  }
  sums.stop.assign(touches.size(), 0.0);
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const EdgeContactPair& t = touches[k];
    sums.stop[k] = given[k].stop;
    load_add(s, t, c, given[k], sums.load);
    given[k].reported = given[k].impulse;
    if (!moves) continue;
    model::EdgePair& to = moves->body[t.body].edges.pair[t.pair];
    to.sticking = given[k].sticking;
    to.warm_start = 1 / c.kick * (given[k].impulse - (1 - c.warm_stop) * given[k].stop * t.gap.n);
  }
  return change;
}

ContactWork edge_work(const std::vector<EdgeContactPair>& touches, const EdgeScratch& scratch,
                      const double* const v[3]) {
  ContactWork work;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const EdgeContactPair& t = touches[k];
    const Given& given = scratch.response->given[k];
    const double factor = scratch.response->factor;
    const Vec3 impulse = -factor * given.impulse,
               middle = 0.5 * (t.old + gap_velocity(t, v)) - t.body_velocity;
    work.dissipated += dot(impulse, middle) + factor * given.stored * dot(t.gap.n, middle);
    work.input -= dot(impulse, t.body_velocity);
  }
  return work;
}

}  // namespace drape::contact
