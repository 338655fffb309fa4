// Which pairs touch. A particle may be nearest to a side or corner that several triangles share. That is one
// point, and counts once, where none of these triangles is nearer still. Two edges count where both protrude
// from their cloth; elsewhere a particle is as near. With m from an edge into either of its triangles,
//
//   D.m >= s |D| |m| on the first edge, -D.m likewise on the second, s = thickness/(8 b):
//
// the middle of an edge of length b is then at most thickness/16 above particles at its ends. But an edge may
// lie along a triangle without a particle over it. So edges within kDeepCross of the contact distance that
// are level with a triangle, to +-s, count for the stop alone.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "contact/self/mesh.h"
#include "contact/self/narrow_phase.h"
#include "contact/self/search.h"
#include "math/closest_points.h"
#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kDeepCross = 0.5;  // of the contact distance

// A pair of candidates, points or crosses.
template <class Candidate>
SelfContactPair pair_of(const Candidate& p, std::uint32_t number, const Vec3& arm, double distance,
                        double age) {
  SelfContactPair t{};
  std::copy(p.node, p.node + 4, t.node.begin());
  t.candidate = number;
  t.cross = std::is_same_v<Candidate, model::SelfCross>;
  t.distance = distance;
  t.n = (1 / distance) * arm;
  t.start = p.start, t.final_distance = p.contact_distance;
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
  const model::SelfState& self;
  double reach;
  std::vector<double>& level_until;  // [edges], as in SelfState
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
// where sine^2 = (1 + m_1.m_2)/2. With a_k = |a_k| m_k, m_1.m_2 > c means a_1.a_2 > c |a_1| |a_2|.
bool may_protrude(const NarrowPhase& l, model::NodeIndex edge) {
  enum : char { kUnknown, kYes, kNo };
  char& known = l.pairs.protrudes[edge];
  if (known != kUnknown) return known == kYes;
  const model::SelfEdge& e = l.system.self.edge[edge];
  known = kYes;
  if (e.across[1] == model::kNoNode) return true;
  const Vec3 base = l.place[e.node[0]], along = l.place[e.node[1]] - base;
  const Vec3 r = l.place[e.across[0]] - base, q = l.place[e.across[1]] - base;
  const double sine = sine_of(l, edge), c = 2 * sine * sine - 1;
  const double ee = dot(along, along), re = dot(r, along), qe = dot(q, along);  // a_k.a_m is these over ee
  const double rq = dot(r, q) * ee - re * qe, rr = dot(r, r) * ee - re * re, qq = dot(q, q) * ee - qe * qe;
  if (c < 0 ? rq < 0 && rq * rq >= c * c * rr * qq : !(rq > 0 && rq * rq > c * c * rr * qq)) known = kNo;
  return known == kYes;
}

// The travel within its piece (m) before which an edge that cannot protrude now cannot do so either. |m_1 +
// m_2|/2 is its largest sine. While the corners come nearer to each other by at most `travel`, the component
// a_k = |a_k| m_k normal to the edge turns by at most 2 travel (1 + 2 |r_k|/|e|)/|a_k|, to first order: half
// of what that allows.
double level_travel(const NarrowPhase& l, model::NodeIndex edge) {
  const model::SelfEdge& e = l.system.self.edge[edge];
  const Vec3 base = l.place[e.node[0]], along = l.place[e.node[1]] - base;
  const double length2 = dot(along, along);
  Vec3 both{0, 0, 0};
  double turns = 0;  // 1/m
  for (model::NodeIndex n : e.across) {
    const Vec3 r = l.place[n] - base, a = r - (dot(r, along) / length2) * along;
    const double over = 1 / norm(a);
    both += over * a;
    turns += 2 * (1 + 2 * std::sqrt(dot(r, r) / length2)) * over;
  }
  return std::max(0.0, sine_of(l, edge) - norm(both) / 2) / turns;
}

// Whether an edge cannot protrude. Records up to which travel.
bool is_level(const NarrowPhase& l, model::NodeIndex edge) {
  if (l.level_until[edge] < INFINITY) return true;
  if (may_protrude(l, edge)) return false;
  const double travel = level_travel(l, edge);
  if (travel > 0) l.level_until[edge] = l.self.shape_travel + travel;
  return true;
}

// Whether it is recorded up to which travel an edge of the pair cannot protrude.
bool level_recorded(const NarrowPhase& l, const model::SelfCross& p) {
  return std::min(l.level_until[p.edge[0]], l.level_until[p.edge[1]]) < INFINITY;
}

// How far an edge protrudes along the unit vector `out`: its smallest sine over the minimum of protrusion.
double protrusion(const NarrowPhase& l, model::NodeIndex edge, const Vec3& out) {
  Vec3 into[2];
  const int count = into_set(l, l.system.self.edge[edge], into);
  double smallest = 1;
  for (int k = 0; k < count; ++k) smallest = std::min(smallest, dot(out, into[k]));
  return smallest / sine_of(l, edge);
}

// Puts the points that are due into blocks. `due`: the travel by which they are.
void points_collect(const model::SelfState& self, double due, SelfContactPairs& pairs) {
  const std::vector<model::SelfPoint>& point = self.pairs->point;
  pairs.point.clear();
  for (std::size_t begin = 0, block = 0; begin < point.size(); begin += model::kPairsPerBlock, ++block) {
    if (self.block_active_after_travel[block] > due) continue;
    const std::size_t end = std::min(begin + model::kPairsPerBlock, point.size());
    for (std::size_t k = begin; k < end; ++k)
      if (self.active_after_travel[k] <= due) pairs.point.push_back(std::uint32_t(k));
  }
  constexpr std::size_t kLanes = math::kRowUnit;
  pairs.block.resize((pairs.point.size() + kLanes - 1) / kLanes);
  for (std::size_t p = 0; p < kLanes * pairs.block.size(); ++p) {
    const model::SelfPoint& of = point[pairs.point[std::min(p, pairs.point.size() - 1)]];
    for (int k = 0; k < 4; ++k) pairs.block[p / kLanes].node[k][p % kLanes] = int(of.node[k]);
  }
}

// The travel (m) left until the pair can touch. It is 0 where the pair is within reach, and then the pair may
// be added to those that touch. `p`: number among those that are examined.
double point_narrow_phase(const NarrowPhase& l, const model::SelfPoint& point, std::size_t p) {
  const SelfPointBlock& b = l.pairs.block[p / math::kRowUnit];
  const std::size_t lane = p % math::kRowUnit;
  const double distance = b.distance[lane];
  if (distance - point.contact_distance > l.reach) return distance - point.contact_distance;
  if (!(point.contact_distance > 0) || !(distance > 0)) return 0;
  const Vec3 arm{b.arm[0][lane], b.arm[1][lane], b.arm[2][lane]};
  SelfContactPair t = pair_of(point, l.pairs.point[p], arm, distance, l.self.age);
  t.weight[0] = 1;
  for (int k = 0; k < 3; ++k) t.weight[k + 1] = -b.weight[k][lane];
  l.pairs.pair.push_back(t);
  return 0;
}

// As point_narrow_phase. A pair with an edge that cannot protrude touches only where it is deep.
double cross_narrow_phase(const NarrowPhase& l, const model::SelfCross& p, std::uint32_t number) {
  const bool level = is_level(l, p.edge[0]) || is_level(l, p.edge[1]);
  const math::EdgesClosest closest =
      math::edges_closest(l.place[p.node[0]], l.place[p.node[1]], l.place[p.node[2]], l.place[p.node[3]]);
  const double distance = std::sqrt(closest.distance2), deep = kDeepCross * p.contact_distance;
  if (level && distance - deep > l.reach) return level_recorded(l, p) ? distance - deep : 0;
  if (distance - p.contact_distance > l.reach) return distance - p.contact_distance;
  if (!closest.crosses || !(p.contact_distance > 0) || !(distance > 0)) return 0;
  SelfContactPair t = pair_of(p, number, closest.arm, distance, l.self.age);
  const double out = std::min(protrusion(l, p.edge[0], t.n), protrusion(l, p.edge[1], -1.0 * t.n));
  if (!(out > 1) && !(out > -1 && distance <= l.reach + deep)) return 0;
  const double rise = std::clamp(out - 1, 0.0, 1.0);
  t.share = rise * rise * (3 - 2 * rise);
  const double weight[4] = {1 - closest.share[0], closest.share[0], closest.share[1] - 1, -closest.share[1]};
  std::copy(weight, weight + 4, t.weight);
  l.pairs.pair.push_back(t);
  return 0;
}

void places_copy(const model::SelfMesh& mesh, const State& s, std::vector<Vec3>& place) {
  place.resize(s.x.size());
  for (const model::NodeSpan& span : mesh.span)
    for (std::size_t n = span.begin; n < span.end; ++n) place[n] = {s.x[n], s.y[n], s.z[n]};
}

// Writes the new times (as travel) at which candidates are examined, and the first of each block.
void reschedule(const std::vector<std::pair<std::size_t, double>>& left, model::SelfState& self) {
  std::vector<double>& active = self.active_after_travel;
  for (std::size_t p = 0; p < left.size();) {
    const std::size_t block = left[p].first / model::kPairsPerBlock;
    for (; p < left.size() && left[p].first / model::kPairsPerBlock == block; ++p)
      active[left[p].first] = left[p].second;
    const auto begin = active.begin() + std::ptrdiff_t(block * model::kPairsPerBlock);
    const auto end =
        active.begin() + std::ptrdiff_t(std::min((block + 1) * model::kPairsPerBlock, active.size()));
    self.block_active_after_travel[block] = *std::min_element(begin, end);
  }
}

// Examines the points in `pairs.point`; calls set(number, travel left) for each.
template <class Set>
void points_examine(const NarrowPhase& l, const model::SelfPairs& candidates, Set set) {
  std::size_t first = 0;  // pair of the present particle
  model::NodeIndex particle = model::kNoNode;
  for (std::size_t p = 0; p < l.pairs.point.size(); ++p) {
    const model::SelfPoint& point = candidates.point[l.pairs.point[p]];
    if (point.node[0] != particle) {
      minima_select(l.pairs.pair, first);
      first = l.pairs.pair.size();
      particle = point.node[0];
    }
    set(l.pairs.point[p], point_narrow_phase(l, point, p));
  }
  minima_select(l.pairs.pair, first);
}

// The same for crosses that are due, by their schedule.
template <class Set>
void crosses_examine(const NarrowPhase& l, const std::vector<double>& active,
                     const std::vector<double>& block_active, double due, Set set) {
  const model::SelfPairs& candidates = *l.self.pairs;
  const std::size_t points = candidates.point.size(), size = candidates.size();
  for (std::size_t block = points / model::kPairsPerBlock; block < block_active.size(); ++block) {
    if (block_active[block] > due) continue;
    const std::size_t begin = block * model::kPairsPerBlock,
                      end = std::min(begin + model::kPairsPerBlock, size);
    for (std::size_t k = std::max(begin, points); k < end; ++k)
      if (active[k] <= due) set(k, cross_narrow_phase(l, candidates.cross[k - points], std::uint32_t(k)));
  }
}

// Lists the crosses of each edge.
void edge_crosses_list(const std::shared_ptr<const model::SelfPairs>& of, std::size_t edges,
                       SelfContactPairs& pairs) {
  if (pairs.of_edges == of) return;
  pairs.of_edges = of;
  pairs.edge_start.assign(edges + 1, 0);
  pairs.edge_cross.resize(2 * of->cross.size());
  for (const model::SelfCross& c : of->cross)
    for (model::NodeIndex e : c.edge) ++pairs.edge_start[e + 1];
  for (std::size_t e = 0; e < edges; ++e) pairs.edge_start[e + 1] += pairs.edge_start[e];
  std::vector<std::uint32_t> next(pairs.edge_start.begin(), pairs.edge_start.end() - 1);
  for (std::size_t k = 0; k < of->cross.size(); ++k)
    for (model::NodeIndex e : of->cross[k].edge) pairs.edge_cross[next[e]++] = std::uint32_t(k);
}

// Looks at the edges that could not protrude until now. Lists the crosses of those that can, where the other
// edge can too: their schedule has ended.
void edges_examine(const NarrowPhase& l) {
  SelfContactPairs& pairs = l.pairs;
  pairs.risen.clear();
  pairs.woken.clear();
  for (std::size_t e = 0; e < l.level_until.size(); ++e) {
    if (l.level_until[e] > l.self.shape_travel) continue;
    l.level_until[e] = INFINITY;
    is_level(l, model::NodeIndex(e));
    if (l.level_until[e] == INFINITY) pairs.risen.push_back(model::NodeIndex(e));
  }
  if (pairs.risen.empty()) return;
  edge_crosses_list(l.self.pairs, l.level_until.size(), pairs);
  const std::vector<model::SelfCross>& cross = l.self.pairs->cross;
  for (model::NodeIndex e : pairs.risen)
    for (std::uint32_t k = pairs.edge_start[e]; k < pairs.edge_start[e + 1]; ++k)
      if (!level_recorded(l, cross[pairs.edge_cross[k]])) pairs.woken.push_back(pairs.edge_cross[k]);
}

// Makes crosses due now.
void wake(const std::vector<std::uint32_t>& crosses, std::size_t points, double now,
          std::vector<double>& active, std::vector<double>& block_active) {
  for (std::uint32_t k : crosses) {
    const std::size_t pair = points + k;
    active[pair] = std::min(active[pair], now);
    block_active[pair / model::kPairsPerBlock] = std::min(block_active[pair / model::kPairsPerBlock], now);
  }
}

}  // namespace

void self_narrow_phase(const System& system, const State& s, double reach, SelfPointsKernel points,
                       SelfContactPairs& pairs, model::SelfState* schedule) {
  pairs.pair.clear();
  const model::SelfState& self = s.self;
  const double now = self.travel, due = now + reach;
  const auto by = [](double until) { return [until](double travel) { return travel <= until; }; };
  if (std::ranges::none_of(self.block_active_after_travel, by(due)) &&
      std::ranges::none_of(self.level_until, by(self.shape_travel)))
    return;
  points_collect(self, due, pairs);
  const double* const r[3] = {s.x.data(), s.y.data(), s.z.data()};
  points(r, pairs.block.data(), pairs.block.data() + pairs.block.size());
  places_copy(system.self, s, pairs.place);
  pairs.protrudes.assign(system.self.edge.size(), 0);
  if (!schedule) pairs.level_until = self.level_until;
  const NarrowPhase narrow_phase{
      system, pairs.place.data(), self, reach, schedule ? schedule->level_until : pairs.level_until, pairs};
  std::vector<std::pair<std::size_t, double>>& left = pairs.left;
  left.clear();
  const auto set = [&](std::size_t k, double travel) {
    if (schedule) left.emplace_back(k, now + travel);
  };
  points_examine(narrow_phase, *self.pairs, set);
  edges_examine(narrow_phase);
  const bool wakes = !pairs.woken.empty(), copies = wakes && !schedule;
  if (copies) pairs.active = self.active_after_travel, pairs.block_active = self.block_active_after_travel;
  if (wakes)
    wake(pairs.woken, self.pairs->point.size(), now, schedule ? schedule->active_after_travel : pairs.active,
         schedule ? schedule->block_active_after_travel : pairs.block_active);
  crosses_examine(narrow_phase, copies ? pairs.active : self.active_after_travel,
                  copies ? pairs.block_active : self.block_active_after_travel, due, set);
  if (schedule) reschedule(left, *schedule);
}

}  // namespace drape::contact
