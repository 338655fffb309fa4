// Which pairs touch. A particle may be nearest to a side or corner that several triangles share. That is one
// point, and counts once, where none of these triangles is nearer still. Two edges count where both protrude
// from their cloth; elsewhere a particle is as near. With m from an edge into either of its triangles,
//
//   D.m >= s |D| |m| on the first edge, -D.m likewise on the second, s = thickness/(8 b):
//
// the middle of an edge of length b is then at most thickness/16 above particles at its ends.
#include <algorithm>
#include <cmath>

#include "contact/self/mesh.h"
#include "contact/self/narrow_phase.h"
#include "contact/self/search.h"
#include "math/closest_points.h"
#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

SelfContactPair pair_of(const model::NodeIndex* node, bool cross, const Vec3& arm, double distance,
                        const std::array<double, 2>& contact_distance, double age) {
  SelfContactPair t{};
  std::copy(node, node + 4, t.node.begin());
  t.cross = cross;
  t.arm = arm;
  t.distance = distance;
  t.n = (1 / distance) * arm;
  t.start = contact_distance[0], t.final_distance = contact_distance[1];
  t.contact_distance = self_contact_distance_at(t.start, t.final_distance, age);
  t.share = 1;
  return t;
}

// Whether b is nearer than a, and its triangle has every node that carries weight in the closest point of a.
bool nearer_there(const SelfContactPair& b, const SelfContactPair& a, bool b_first) {
  if (!(b.distance < a.distance || (b.distance == a.distance && b_first))) return false;
  int shared = 0, expected = 0;
  for (int k = 1; k < 4; ++k) {
    if (a.weight[k] == 0) continue;
    ++expected;
    for (int m = 1; m < 4; ++m) shared += a.node[std::size_t(k)] == b.node[std::size_t(m)];
  }
  return expected < 3 && shared == expected;
}

// Removes all but the local minima among the pairs of one particle, from `first` on.
void minima_select(std::vector<SelfContactPair>& contact, std::size_t first) {
  if (contact.size() - first < 2) return;
  for (std::size_t a = first; a < contact.size(); ++a)
    for (std::size_t b = first; b < contact.size(); ++b)
      if (a != b && nearer_there(contact[b], contact[a], b < a)) contact[a].drop = true;
  const auto from = contact.begin() + std::ptrdiff_t(first);
  contact.erase(std::remove_if(from, contact.end(), [](const SelfContactPair& t) { return t.drop; }),
                contact.end());
}

struct NarrowPhase {
  const System& system;
  const Vec3* place;
  double reach, age;
  SelfContactPairs& pairs;
};

// Writes the unit vectors from an edge into its triangles to `into` [2]; returns their number.
int into_set(const NarrowPhase& l, const model::SelfEdge& e, Vec3* into) {
  const Vec3 base = l.place[e.node[0]], edge = l.place[e.node[1]] - base;
  int count = 0;
  for (model::NodeIndex n : e.across) {
    if (n == model::kNoNode) continue;
    const Vec3 reach = l.place[n] - base, m = reach - (dot(reach, edge) / dot(edge, edge)) * edge;
    into[count++] = (1 / norm(m)) * m;
  }
  return count;
}

double sine_of(const NarrowPhase& l, model::NodeIndex edge) {
  const model::SelfMesh& mesh = l.system.self;
  return mesh.min_protrusion_sine[std::size_t(mesh.lattice_of[mesh.edge[edge].node[0]])];
}

// Whether an edge can protrude at all. Its smallest sine is largest along the bisector of both directions,
// where sine^2 = (1 + m_1.m_2)/2.
bool may_protrude(const NarrowPhase& l, model::NodeIndex edge) {
  enum : char { kUnknown, kYes, kNo };
  char& known = l.pairs.protrudes[edge];
  if (known == kUnknown) {
    Vec3 into[2];
    const double sine = sine_of(l, edge);
    const bool rim = into_set(l, l.system.self.edge[edge], into) < 2;
    known = rim || (1 + dot(into[0], into[1])) / 2 > sine * sine ? kYes : kNo;
  }
  return known == kYes;
}

// How far an edge protrudes along the unit vector `out`: its smallest sine over the minimum of protrusion.
double protrusion(const NarrowPhase& l, model::NodeIndex edge, const Vec3& out) {
  Vec3 into[2];
  const int count = into_set(l, l.system.self.edge[edge], into);
  double smallest = 1;
  for (int k = 0; k < count; ++k) smallest = std::min(smallest, dot(out, into[k]));
  return smallest / sine_of(l, edge);
}

// The travel (m) left until the pair can touch. It is 0 where the pair is within reach, and then the pair may
// be added to those that touch.
double point_narrow_phase(const NarrowPhase& l, const model::SelfPoint& p) {
  const math::TriangleClosest closest =
      math::triangle_closest(l.place[p.node[0]], l.place[p.node[1]], l.place[p.node[2]], l.place[p.node[3]]);
  const double distance = std::sqrt(closest.distance2);
  if (distance - p.contact_distance > l.reach) return distance - p.contact_distance;
  if (!(p.contact_distance > 0) || !(distance > 0)) return 0;
  SelfContactPair t = pair_of(p.node, false, closest.arm, distance, {p.start, p.contact_distance}, l.age);
  t.weight[0] = 1;
  for (int k = 0; k < 3; ++k) t.weight[k + 1] = -closest.weight[k], t.turn[k + 1] = 1;
  l.pairs.pair.push_back(t);
  return 0;
}

double cross_narrow_phase(const NarrowPhase& l, const model::SelfCross& p) {
  if (!may_protrude(l, p.edge[0]) || !may_protrude(l, p.edge[1])) return 0;
  const math::EdgesClosest closest =
      math::edges_closest(l.place[p.node[0]], l.place[p.node[1]], l.place[p.node[2]], l.place[p.node[3]]);
  const double distance = std::sqrt(closest.distance2);
  if (distance - p.contact_distance > l.reach) return distance - p.contact_distance;
  if (!closest.crosses || !(p.contact_distance > 0) || !(distance > 0)) return 0;
  SelfContactPair t = pair_of(p.node, true, closest.arm, distance, {p.start, p.contact_distance}, l.age);
  const double out = std::min(protrusion(l, p.edge[0], t.n), protrusion(l, p.edge[1], -1.0 * t.n));
  if (!(out > 1)) return 0;
  const double rise = std::min(out - 1, 1.0);
  t.share = rise * rise * (3 - 2 * rise);
  const double weight[4] = {1 - closest.share[0], closest.share[0], closest.share[1] - 1, -closest.share[1]};
  for (int k = 0; k < 4; ++k) t.weight[k] = weight[k], t.turn[k] = 1;
  l.pairs.pair.push_back(t);
  return 0;
}

void places_copy(const model::SelfMesh& mesh, const State& s, std::vector<Vec3>& place) {
  place.resize(s.x.size());
  for (const model::NodeSpan& span : mesh.span)
    for (std::size_t n = span.begin; n < span.end; ++n) place[n] = {s.x[n], s.y[n], s.z[n]};
}

}  // namespace

void self_narrow_phase(const System& system, const State& s, double reach, SelfContactPairs& pairs,
                       model::SelfState* schedule) {
  pairs.pair.clear();
  const std::vector<double>& blocks = s.self.block_active_after_travel;
  const double now = s.self.travel;
  if (std::none_of(blocks.begin(), blocks.end(), [&](double b) { return b <= now + reach; })) return;
  const model::SelfPairs& candidates = *s.self.pairs;
  const std::size_t points = candidates.point.size(), size = candidates.size();
  places_copy(system.self, s, pairs.place);
  pairs.protrudes.assign(system.self.edge.size(), 0);
  const NarrowPhase narrow_phase{system, pairs.place.data(), reach, s.self.age, pairs};
  std::size_t first = 0;  // pair of the present particle
  model::NodeIndex particle = model::kNoNode;
  for (std::size_t begin = 0, block = 0; begin < size; begin += model::kPairsPerBlock, ++block) {
    if (blocks[block] > now + reach) continue;
    const std::size_t end = std::min(begin + model::kPairsPerBlock, size);
    double soonest = INFINITY;
    for (std::size_t k = begin; k < end; ++k) {
      double until = s.self.active_after_travel[k];
      if (until <= now + reach) {
        const bool point = k < points;
        if (const model::NodeIndex n = point ? candidates.point[k].node[0] : model::kNoNode; n != particle) {
          minima_select(pairs.pair, first);
          first = pairs.pair.size();
          particle = n;
        }
        const double left = point ? point_narrow_phase(narrow_phase, candidates.point[k])
                                  : cross_narrow_phase(narrow_phase, candidates.cross[k - points]);
        until = now + left;
        if (schedule) schedule->active_after_travel[k] = until;
      }
      soonest = std::min(soonest, until);
    }
    if (schedule) schedule->block_active_after_travel[block] = soonest;
  }
  if (particle != model::kNoNode) minima_select(pairs.pair, first);
}

}  // namespace drape::contact
