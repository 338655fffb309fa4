// Which pairs touch. A particle may be nearest to a side or corner that several triangles share: it is one
// place, and counts once, where none of these triangles is nearer still. Two edges count where both stand out
// of their cloth, for elsewhere a particle is as near: with m from an edge into either of its triangles,
//
//   D.m >= kStandsOut |D| |m| on the first edge, and -D.m likewise on the second.
#include <algorithm>
#include <cmath>

#include "constraint/vector3.h"
#include "self_contact/mesh.h"
#include "self_contact/nearest.h"
#include "self_contact/search.h"
#include "self_contact/touch.h"

namespace drape {
namespace {

using namespace vector3;

constexpr double kStandsOut = 0.01, kStandsOutWhole = 0.03;  // sine of the angle; where the penalty is whole

Vec3 place(const State& s, NodeIndex n) { return {s.x[n], s.y[n], s.z[n]}; }

SelfTouch touch_of(const NodeIndex* node, bool cross, const Vec3& arm, double distance, double layer) {
  SelfTouch t{};
  std::copy(node, node + 4, t.node.begin());
  t.cross = cross;
  t.arm = arm;
  t.distance = distance;
  t.n = (1 / distance) * arm;
  t.layer = layer;
  t.share = 1;
  return t;
}

// Every node at which the foot of `a` has weight is one of b's triangle, and b is nearer.
bool nearer_there(const SelfTouch& b, const SelfTouch& a, bool b_first) {
  if (!(b.distance < a.distance || (b.distance == a.distance && b_first))) return false;
  int shared = 0, wanted = 0;
  for (int k = 1; k < 4; ++k) {
    if (a.weight[k] == 0) continue;
    ++wanted;
    for (int m = 1; m < 4; ++m) shared += a.node[std::size_t(k)] == b.node[std::size_t(m)];
  }
  return wanted < 3 && shared == wanted;
}

// Keeps the local minima among those of one particle, from `first` on.
void minima_keep(std::vector<SelfTouch>& touch, std::size_t first) {
  if (touch.size() - first < 2) return;
  std::vector<char> drop(touch.size() - first, 0);
  for (std::size_t a = first; a < touch.size(); ++a)
    for (std::size_t b = first; b < touch.size(); ++b)
      if (a != b && nearer_there(touch[b], touch[a], b < a)) drop[a - first] = 1;
  std::size_t to = first;
  for (std::size_t a = first; a < touch.size(); ++a)
    if (!drop[a - first]) touch[to++] = touch[a];
  touch.resize(to);
}

// How far an edge stands out of its cloth along `out`, of length 1: the least sine over its triangles.
double stands_out(const State& s, NodeIndex from, NodeIndex to, const NodeIndex* across, const Vec3& out) {
  const Vec3 base = place(s, from), edge = place(s, to) - base;
  double least = 1;
  for (int k = 0; k < 2; ++k) {
    if (across[k] == kNoNode) continue;
    const Vec3 reach = place(s, across[k]) - base;
    const Vec3 m = reach - (dot(reach, edge) / dot(edge, edge)) * edge;
    least = std::min(least, dot(out, m) / norm(m));
  }
  return least;
}

struct Looking {
  const System& system;
  const State& state;
  double reach;
};

// The way left until the pair can touch; 0 where it is within reach, and then it may be one more of `touch`.
double point_look(const Looking& l, const SelfPoint& p, std::vector<SelfTouch>& touch) {
  const State& s = l.state;
  const double layer = self_pair_layer(l.system, l.system.self, p);
  const TriangleFoot foot =
      triangle_foot(place(s, p.node[0]), place(s, p.node[1]), place(s, p.node[2]), place(s, p.node[3]));
  const double distance = std::sqrt(foot.distance2);
  if (distance - layer > l.reach) return distance - layer;
  if (layer > 0 && distance > 0) {
    SelfTouch t = touch_of(p.node, false, foot.arm, distance, layer);
    t.weight[0] = 1;
    for (int k = 0; k < 3; ++k) t.weight[k + 1] = -foot.weight[k], t.turn[k + 1] = 1;
    touch.push_back(t);
  }
  return 0;
}

double cross_look(const Looking& l, const SelfCross& p, std::vector<SelfTouch>& touch) {
  const State& s = l.state;
  const double layer = self_pair_layer(l.system, l.system.self, p);
  const EdgesFoot foot =
      edges_foot(place(s, p.node[0]), place(s, p.node[1]), place(s, p.node[2]), place(s, p.node[3]));
  const double distance = std::sqrt(foot.distance2);
  if (distance - layer > l.reach) return distance - layer;
  if (!foot.crosses || !(layer > 0) || !(distance > 0)) return 0;
  SelfTouch t = touch_of(p.node, true, foot.arm, distance, layer);
  const double out = std::min(stands_out(s, p.node[0], p.node[1], p.across, t.n),
                              stands_out(s, p.node[2], p.node[3], p.across + 2, -1.0 * t.n));
  if (!(out > kStandsOut)) return 0;
  const double rise = std::min((out - kStandsOut) / (kStandsOutWhole - kStandsOut), 1.0);
  t.share = rise * rise * (3 - 2 * rise);
  const double weight[4] = {1 - foot.share[0], foot.share[0], foot.share[1] - 1, -foot.share[1]};
  for (int k = 0; k < 4; ++k) t.weight[k] = weight[k], t.turn[k] = 1;
  touch.push_back(t);
  return 0;
}

}  // namespace

void self_look(const System& system, const State& s, double reach, std::vector<SelfTouch>& touch,
               SelfState* wake) {
  touch.clear();
  if (!s.self.pairs) return;
  const SelfPairs& pairs = *s.self.pairs;
  const std::size_t points = pairs.point.size(), size = pairs.size();
  const double now = s.self.way;
  const Looking looking{system, s, reach};
  std::size_t first = 0;  // of the touches of the present particle
  NodeIndex particle = kNoNode;
  for (std::size_t begin = 0, block = 0; begin < size; begin += kWakeBlock, ++block) {
    if (s.self.wake_block[block] > now + reach) continue;
    const std::size_t end = std::min(begin + kWakeBlock, size);
    double soonest = INFINITY;
    for (std::size_t k = begin; k < end; ++k) {
      double until = s.self.wake[k];
      if (until <= now + reach) {
        const bool point = k < points;
        if (const NodeIndex n = point ? pairs.point[k].node[0] : kNoNode; n != particle) {
          minima_keep(touch, first);
          first = touch.size();
          particle = n;
        }
        until = now + (point ? point_look(looking, pairs.point[k], touch)
                             : cross_look(looking, pairs.cross[k - points], touch));
        if (wake) wake->wake[k] = until;
      }
      soonest = std::min(soonest, until);
    }
    if (wake) wake->wake_block[block] = soonest;
  }
  if (particle != kNoNode) minima_keep(touch, first);
}

}  // namespace drape
