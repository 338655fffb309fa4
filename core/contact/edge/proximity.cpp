// Which links and cells are near ridges. A pair sleeps until the way that its nodes can have gone is what it
// was apart; all pairs are listed anew when that may be more than a listing saw.
#include <algorithm>
#include <cmath>

#include "contact/edge/elements.h"
#include "contact/edge/pairs.h"
#include "math/closest_points.h"
#include "math/vector3.h"
#include "model/body_pose.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kReachSteps = 2;    // at the present speed, for which pairs are looked at before they touch
constexpr double kReachLayer = 0.1;  // of the layer, likewise
constexpr double kAheadSteps = 1.5;  // that a node is looked ahead
constexpr double kListSteps = 6;     // that parts are listed for beyond the margin
constexpr double kUsed = 0.5;        // of what a node may go: what has gone farther is listed with others
constexpr std::size_t kMaxTrackedFactor = 3, kMaxTrackedExtra = 64;  // nodes, times those near, and beyond it
constexpr double kWay = 0.25;  // of the layer: the most a step may move what is near

Vec3 place(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

bool before(const model::EdgePair& a, const model::EdgePair& b) {
  return a.element != b.element ? a.element < b.element : a.feature < b.feature;
}

// The parts that have one of the nodes.
void parts_of(const model::EdgeElements& cloth, const std::vector<std::uint32_t>& nodes,
              std::vector<std::uint32_t>& parts) {
  parts.clear();
  for (std::uint32_t n : nodes)
    parts.insert(parts.end(), cloth.of_node.begin() + cloth.first[n],
                 cloth.of_node.begin() + cloth.first[n + 1]);
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
}

double speed_of(const System& system, const State& s, std::size_t b, std::size_t n) {
  return norm(Vec3{s.vx[n], s.vy[n], s.vz[n]} -
              model::pose_velocity(system.bodies[b], s.body[b], place(s, n)));
}

// What pairs are listed for: a body, and the next step of `ahead` s.
struct Listing {
  const System& system;
  const State& state;
  std::size_t body;
  double ahead;
};

// Lists the pairs of the elements of the scratch in `found`, in order.
void pairs_find(const Listing& listing, EdgeScratch& scratch) {
  const auto& [system, s, b, ahead] = listing;
  std::vector<model::EdgePair>& found = scratch.found;
  std::vector<std::uint32_t>& features = scratch.features;
  const body::SharpFeatures& of = system.bodies[b].sharp;
  found.clear();
  for (std::uint32_t p : scratch.elements) {
    const model::EdgeElement& part = system.edge_elements.element[p];
    const model::Lattice& l = system.lattices[std::size_t(part.lattice)];
    Vec3 x[6], middle{0, 0, 0};
    edge_element_places(system, s, b, part, x);
    double fastest = 0, around = 0;
    for (int k = 0; k < part.weights(); ++k) {
      fastest = std::max(fastest, speed_of(system, s, b, part.node[k]));
      middle += (1.0 / part.weights()) * x[k];
    }
    for (int k = 0; k < part.weights(); ++k) around = std::max(around, norm(x[k] - middle));
    const double reach = l.contact_law.distance + edge_margin(l) + kListSteps * fastest * ahead;
    const Vec3 box = (around + reach) * Vec3{1, 1, 1};
    body::sharp_features_in(of, middle - box, middle + box, features);
    for (std::uint32_t r : features) {
      const body::SharpFeature& feature = of.feature[r];
      if (part.cell && !feature.tip) continue;
      if (math::segment_distance2(middle, feature.from, feature.to) > (around + reach) * (around + reach))
        continue;
      if (edge_gap(part, feature, x, edge_sine(l)).clearance <= reach) found.push_back({p, r});
    }
  }
}

// The nodes of the elements of the scratch, which have one of its nodes, join those that are tracked; those
// are tracked from here.
void nodes_track(const Listing& listing, EdgeScratch& scratch, model::EdgeContact& c) {
  const auto& [system, s, b, ahead] = listing;
  const std::vector<std::uint32_t>& nodes = scratch.nodes;
  std::vector<std::uint32_t>& joined = scratch.joined;
  std::vector<Vec3>& from = scratch.from;
  joined = c.node;
  for (std::uint32_t p : scratch.elements) {
    const model::EdgeElement& part = system.edge_elements.element[p];
    joined.insert(joined.end(), part.node, part.node + part.nodes);
  }
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
  from.resize(joined.size());
  c.last.resize(joined.size());
  std::size_t known = 0;
  for (std::size_t k = 0; k < joined.size(); ++k) {
    c.last[k] = model::pose_inward(system.bodies[b], s.body[b], place(s, joined[k]));
    while (known < c.node.size() && c.node[known] < joined[k]) ++known;
    const bool old = known < c.node.size() && c.node[known] == joined[k] &&
                     !std::binary_search(nodes.begin(), nodes.end(), joined[k]);
    from[k] = old ? c.from[known] : c.last[k];
  }
  c.node = joined;
  c.from = from;
}

// Those found take the place of the pairs of the elements of the scratch, or of all; what they remember goes
// on.
void pairs_join(EdgeScratch& scratch, bool all, model::EdgeContact& c) {
  const std::vector<std::uint32_t>& parts = scratch.elements;
  const std::vector<model::EdgePair>& found = scratch.found;
  std::vector<model::EdgePair>& pair = scratch.pairs;
  std::vector<double>& wake = scratch.active_after_travel;
  pair.clear();
  wake.clear();
  std::size_t part = 0, old = 0;
  const auto take = [&](std::size_t k) {
    pair.push_back(c.pair[k]), wake.push_back(c.active_after_travel[k]);
  };
  for (const model::EdgePair& p : found) {
    for (; old < c.pair.size() && before(c.pair[old], p); ++old) {
      while (part < parts.size() && parts[part] < c.pair[old].element) ++part;
      if (!all && (part == parts.size() || parts[part] != c.pair[old].element)) take(old);
    }
    if (old < c.pair.size() && !before(p, c.pair[old])) take(old++);
    else pair.push_back(p), wake.push_back(c.travel);
  }
  for (; old < c.pair.size(); ++old) {
    while (part < parts.size() && parts[part] < c.pair[old].element) ++part;
    if (!all && (part == parts.size() || parts[part] != c.pair[old].element)) take(old);
  }
  c.pair = pair;
  c.active_after_travel = wake;
}

// Lists the pairs of the nodes of the scratch, sorted; `all`: no others are left.
void list(const Listing& listing, EdgeScratch& scratch, bool all, model::EdgeContact& c) {
  parts_of(listing.system.edge_elements, scratch.nodes, scratch.elements);
  pairs_find(listing, scratch);
  nodes_track(listing, scratch, c);
  pairs_join(scratch, all, c);
}

// How far and how fast the nodes have gone against the body. Whether one may by the next step have gone so
// far from where its parts were listed that they must be anew.
bool travel_add(const System& system, State& s, std::size_t b, double ahead, double margin) {
  model::BodyContact& body = s.body[b];
  model::EdgeContact& c = body.edges;
  double way2 = 0, speed2 = 0, contact_distance = 0;
  bool due = false;
  for (const model::Lattice& l : system.lattices)
    contact_distance = std::max(contact_distance, l.contact_law.distance);
  for (std::size_t k = 0; k < c.node.size(); ++k) {
    const std::size_t n = c.node[k];
    const Vec3 at = place(s, n), x = model::pose_inward(system.bodies[b], body, at), moved = x - c.last[k];
    const Vec3 v = Vec3{s.vx[n], s.vy[n], s.vz[n]} - model::pose_velocity(system.bodies[b], body, at);
    const Vec3 away = x - c.from[k];
    const double v2 = dot(v, v), ahead2 = kAheadSteps * kAheadSteps * ahead * ahead * v2;
    way2 = std::max(way2, dot(moved, moved));
    speed2 = std::max(speed2, v2);
    due = due || 2 * (dot(away, away) + ahead2) > margin * margin;
    c.last[k] = x;
  }
  c.travel += std::sqrt(way2);
  c.reach = kReachSteps * std::sqrt(speed2) * ahead + kReachLayer * contact_distance;
  return due;
}

double min_margin(const System& system) {
  double smallest = INFINITY;
  for (const model::Lattice& l : system.lattices) smallest = std::min(smallest, edge_margin(l));
  return smallest;
}

}  // namespace

void edge_begin(const System& system, State& s) {
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    s.body[b].edges = model::EdgeContact{};
    if (!system.bodies[b].sharp.feature.empty()) s.body[b].edges.near.assign(system.nodes, 0);
  }
}

// A part is listed with what is within its layer and a margin M of it. Each of its nodes may have gone M/2
// since then: one that has not gone M/2 from where its own parts were listed before is no farther from where
// it was. Where one is to be listed anew, so are all that have used up half of that.
void edge_update_proximity(const System& system, EdgeScratch& scratch, State& s, std::size_t b,
                           double ahead) {
  std::vector<std::uint32_t>& nodes = scratch.nodes;
  model::EdgeContact& c = s.body[b].edges;
  if (c.fresh.empty() && c.node.empty()) return;
  const double half = min_margin(system) / 2;
  const bool due = travel_add(system, s, b, ahead, half);
  if (!due && c.fresh.empty()) return;
  nodes = c.fresh;
  c.fresh.clear();
  for (std::size_t k = 0; due && k < c.node.size(); ++k) {
    const Vec3 away = c.last[k] - c.from[k];
    const double step = kAheadSteps * ahead * speed_of(system, s, b, c.node[k]);
    if (2 * (dot(away, away) + step * step) > kUsed * kUsed * half * half) nodes.push_back(c.node[k]);
  }
  const auto near = std::size_t(
      std::count_if(c.node.begin(), c.node.end(), [&](std::uint32_t n) { return c.near[n] != 0; }));
  const bool all = c.node.size() > kMaxTrackedFactor * near + kMaxTrackedExtra;
  if (all) {
    for (std::uint32_t n : c.node)
      if (c.near[n]) nodes.push_back(n);
    c.node.clear();
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  list({system, s, b, ahead}, scratch, all, c);
}

void edge_stick(const System& system, State& s) {
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (system.bodies[b].moves) continue;
    for (model::EdgePair& pair : s.body[b].edges.pair) {
      const model::EdgeElement& part = system.edge_elements.element[pair.element];
      pair.sticking = 1;
      for (int k = 0; k < part.weights(); ++k) {
        const std::size_t n = part.node[k];
        if (s.vx[n] != 0 || s.vy[n] != 0 || s.vz[n] != 0) pair.sticking = 0;
      }
    }
  }
}

double edge_max_step(const System& system, const State& s) {
  double longest = INFINITY;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    for (std::uint32_t n : s.body[b].edges.node)
      longest = std::min(longest, kWay * model::system_lattice_of(system, n).contact_law.distance /
                                      speed_of(system, s, b, n));
  return longest;
}

}  // namespace drape::contact
