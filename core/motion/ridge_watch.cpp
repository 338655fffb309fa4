// Which links and cells are near ridges. A pair sleeps until the way that its nodes can have gone is what it
// was apart; all pairs are listed anew when that may be more than a listing saw.
#include <algorithm>
#include <cmath>

#include "constraint/vector3.h"
#include "contact/pose.h"
#include "motion/ridge_pairs.h"

namespace drape {
namespace {

using namespace vector3;

constexpr double kReachSteps = 2;    // at the present speed, for which pairs are looked at before they touch
constexpr double kReachLayer = 0.1;  // of the layer, likewise
constexpr double kWay = 0.25;        // of the layer: the most a step may move what is near

Vec3 place(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

bool before(const RidgePair& a, const RidgePair& b) {
  return a.part != b.part ? a.part < b.part : a.ridge < b.ridge;
}

// The parts that have one of the nodes.
void parts_of(const RidgeCloth& cloth, const std::vector<std::uint32_t>& nodes,
              std::vector<std::uint32_t>& parts) {
  parts.clear();
  for (std::uint32_t n : nodes)
    parts.insert(parts.end(), cloth.of_node.begin() + cloth.first[n],
                 cloth.of_node.begin() + cloth.first[n + 1]);
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
}

// Lists the pairs of these parts, in order.
void pairs_find(const System& system, const State& s, std::size_t b, const std::vector<std::uint32_t>& parts,
                std::vector<RidgePair>& found) {
  static thread_local std::vector<std::uint32_t> ridges;
  const Ridges& of = system.bodies[b].ridges;
  found.clear();
  for (std::uint32_t p : parts) {
    const RidgePart& part = system.ridge_cloth.part[p];
    const Lattice& l = system.lattices[std::size_t(part.lattice)];
    const double reach = l.touch.layer + std::max(ridge_margin(l), kReachSteps * s.body[b].ridge.reach);
    Vec3 x[6], low{INFINITY, INFINITY, INFINITY}, high = -1.0 * low;
    ridge_places(system, s, b, part, x);
    for (int k = 0; k < part.weights(); ++k)
      for (std::size_t i = 0; i < 3; ++i)
        low[i] = std::min(low[i], x[k][i] - reach), high[i] = std::max(high[i], x[k][i] + reach);
    ridges_in(of, low, high, ridges);
    for (std::uint32_t r : ridges) {
      if (part.cell && !of.ridge[r].tip) continue;
      if (ridge_gap(part, of.ridge[r], x, ridge_sine(l)).clearance <= reach) found.push_back({p, r});
    }
  }
}

// Nodes of the parts join those that are watched.
void nodes_watch(const System& system, const State& s, std::size_t b, const std::vector<std::uint32_t>& parts,
                 RidgeContact& c) {
  for (std::uint32_t p : parts) {
    const RidgePart& part = system.ridge_cloth.part[p];
    c.node.insert(c.node.end(), part.node, part.node + part.nodes);
  }
  std::sort(c.node.begin(), c.node.end());
  c.node.erase(std::unique(c.node.begin(), c.node.end()), c.node.end());
  c.last.resize(c.node.size());
  for (std::size_t k = 0; k < c.node.size(); ++k)
    c.last[k] = pose_inward(system.bodies[b], s.body[b], place(s, c.node[k]));
}

// What known pairs remember goes on; `all`: those that are not found are gone.
void pairs_join(std::vector<RidgePair>& found, bool all, RidgeContact& c) {
  for (RidgePair& pair : found)
    if (const auto at = std::lower_bound(c.pair.begin(), c.pair.end(), pair, before);
        at != c.pair.end() && !before(pair, *at))
      pair = *at;
  if (!all)
    for (const RidgePair& pair : c.pair)
      if (!std::binary_search(found.begin(), found.end(), pair, before)) found.push_back(pair);
  std::sort(found.begin(), found.end(), before);
  c.pair = found;
  c.wake.assign(c.pair.size(), c.way);
}

void list(const System& system, State& s, std::size_t b, bool all) {
  static thread_local std::vector<std::uint32_t> nodes, parts;
  static thread_local std::vector<RidgePair> found;
  RidgeContact& c = s.body[b].ridge;
  nodes = c.fresh;
  if (all) {
    nodes.clear();
    for (std::size_t n : system.particle)
      if (c.near[n]) nodes.push_back(std::uint32_t(n));
    c.node.clear();
    c.listed = c.way;
  }
  c.fresh.clear();
  parts_of(system.ridge_cloth, nodes, parts);
  pairs_find(system, s, b, parts, found);
  nodes_watch(system, s, b, parts, c);
  pairs_join(found, all, c);
}

// How far and how fast the nodes have gone against the body.
void way_add(const System& system, State& s, std::size_t b, double ahead) {
  BodyContact& body = s.body[b];
  RidgeContact& c = body.ridge;
  double way2 = 0, speed2 = 0, layer = 0;
  for (const Lattice& l : system.lattices) layer = std::max(layer, l.touch.layer);
  for (std::size_t k = 0; k < c.node.size(); ++k) {
    const std::size_t n = c.node[k];
    const Vec3 at = place(s, n), x = pose_inward(system.bodies[b], body, at), moved = x - c.last[k];
    const Vec3 v = Vec3{s.vx[n], s.vy[n], s.vz[n]} - pose_velocity(system.bodies[b], body, at);
    way2 = std::max(way2, dot(moved, moved));
    speed2 = std::max(speed2, dot(v, v));
    c.last[k] = x;
  }
  c.way += std::sqrt(way2);
  c.reach = kReachSteps * std::sqrt(speed2) * ahead + kReachLayer * layer;
}

double margin_least(const System& system) {
  double least = INFINITY;
  for (const Lattice& l : system.lattices) least = std::min(least, ridge_margin(l));
  return least;
}

}  // namespace

void ridge_begin(const System& system, State& s) {
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    s.body[b].ridge = RidgeContact{};
    if (!system.bodies[b].ridges.ridge.empty()) s.body[b].ridge.near.assign(system.nodes, 0);
  }
}

void ridge_watch(const System& system, State& s, std::size_t b, double ahead) {
  RidgeContact& c = s.body[b].ridge;
  if (c.fresh.empty() && c.node.empty()) return;
  way_add(system, s, b, ahead);
  const bool all = c.way + c.reach > c.listed + margin_least(system);
  if (all || !c.fresh.empty()) list(system, s, b, all);
}

void ridge_stick(const System& system, State& s) {
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (system.bodies[b].moves) continue;
    for (RidgePair& pair : s.body[b].ridge.pair) {
      const RidgePart& part = system.ridge_cloth.part[pair.part];
      pair.grip = 1;
      for (int k = 0; k < part.weights(); ++k) {
        const std::size_t n = part.node[k];
        if (s.vx[n] != 0 || s.vy[n] != 0 || s.vz[n] != 0) pair.grip = 0;
      }
    }
  }
}

double ridge_step_most(const System& system, const State& s) {
  double longest = INFINITY;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    for (std::uint32_t n : s.body[b].ridge.node) {
      const Vec3 v =
          Vec3{s.vx[n], s.vy[n], s.vz[n]} - pose_velocity(system.bodies[b], s.body[b], place(s, n));
      longest = std::min(longest, kWay * system_lattice_of(system, n).touch.layer / norm(v));
    }
  return longest;
}

}  // namespace drape
