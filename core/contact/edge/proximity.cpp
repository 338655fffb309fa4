// Which links and cells are near sharp features. A pair is inactive until its nodes may have travelled as far
// as it was apart. Pairs are listed again once that travel may exceed what their list covers.
#include <algorithm>
#include <cmath>

#include "contact/edge/elements.h"
#include "contact/edge/pairs.h"
#include "contact/particle/contact.h"
#include "math/closest_points.h"
#include "math/vector3.h"
#include "model/body_pose.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kReachSteps = 2;       // steps at the present speed before contact: pairs are active
constexpr double kReachDistance = 0.1;  // of the contact distance, added to that
constexpr double kAheadSteps = 1.5;     // steps that a node is extrapolated by
constexpr double kListSteps = 6;        // steps that pairs are listed for, besides the margin
constexpr double kUsed = 0.5;           // of the free travel: a node beyond it is listed together with others
// Nodes are tracked up to this factor times the near ones, and so many more.
constexpr std::size_t kMaxTrackedFactor = 3, kMaxTrackedExtra = 64;
constexpr double kMaxTravel = 0.25;  // of the contact distance, of near nodes in a step

Vec3 position(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

bool before(const model::EdgePair& a, const model::EdgePair& b) {
  return a.element != b.element ? a.element < b.element : a.feature < b.feature;
}

// The elements that have one of the nodes; sorted.
void elements_of(const model::EdgeElements& cloth, const std::vector<std::uint32_t>& nodes,
                 std::vector<std::uint32_t>& elements) {
  elements.clear();
  for (std::uint32_t n : nodes)
    elements.insert(elements.end(), cloth.of_node.begin() + cloth.first[n],
                    cloth.of_node.begin() + cloth.first[n + 1]);
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

double speed_of(const System& system, const State& s, std::size_t b, std::size_t n) {
  return norm(Vec3{s.vx[n], s.vy[n], s.vz[n]} -
              model::pose_velocity(system.bodies[b], s.body[b], position(s, n)));
}

// The body that pairs are listed for, and the next step of `ahead` s.
struct Listing {
  const System& system;
  const State& state;
  std::size_t body;
  double ahead;
};

// Lists the pairs of scratch.elements in scratch.found, in order.
void pairs_find(const Listing& listing, EdgeScratch& scratch) {
  const auto& [system, s, b, ahead] = listing;
  std::vector<model::EdgePair>& found = scratch.found;
  std::vector<std::uint32_t>& features = scratch.features;
  const body::SharpFeatures& of = system.bodies[b].sharp;
  found.clear();
  for (std::uint32_t p : scratch.elements) {
    const model::EdgeElement& element = system.edge_elements.element[p];
    const model::Lattice& l = system.lattices[std::size_t(element.lattice)];
    Vec3 x[6], middle{0, 0, 0};
    edge_element_places(system, s, b, element, x);
    double fastest = 0, around = 0;
    for (int k = 0; k < element.weights(); ++k) {
      fastest = std::max(fastest, speed_of(system, s, b, element.node[k]));
      middle += (1.0 / element.weights()) * x[k];
    }
    for (int k = 0; k < element.weights(); ++k) around = std::max(around, norm(x[k] - middle));
    const double reach = l.contact_law.distance + edge_margin(l) + kListSteps * fastest * ahead;
    const Vec3 box = (around + reach) * Vec3{1, 1, 1};
    body::sharp_features_in(of, middle - box, middle + box, features);
    for (std::uint32_t r : features) {
      const body::SharpFeature& feature = of.feature[r];
      if (math::segment_distance2(middle, feature.from, feature.to) > (around + reach) * (around + reach))
        continue;
      if (edge_gap(element, feature, x, edge_sine(l)).clearance <= reach) found.push_back({p, r});
    }
  }
}

// Adds the nodes of scratch.elements to the tracked ones. Those of scratch.nodes are tracked from their
// present positions.
void nodes_track(const Listing& listing, EdgeScratch& scratch, model::EdgeContact& c) {
  const auto& [system, s, b, ahead] = listing;
  const std::vector<std::uint32_t>& nodes = scratch.nodes;
  std::vector<std::uint32_t>& joined = scratch.joined;
  std::vector<Vec3>& from = scratch.from;
  joined = c.node;
  for (std::uint32_t p : scratch.elements) {
    const model::EdgeElement& element = system.edge_elements.element[p];
    joined.insert(joined.end(), element.node, element.node + element.nodes);
  }
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
  from.resize(joined.size());
  c.last.resize(joined.size());
  std::size_t known = 0;
  for (std::size_t k = 0; k < joined.size(); ++k) {
    c.last[k] = model::pose_inward(system.bodies[b], s.body[b], position(s, joined[k]));
    while (known < c.node.size() && c.node[known] < joined[k]) ++known;
    const bool old = known < c.node.size() && c.node[known] == joined[k] &&
                     !std::binary_search(nodes.begin(), nodes.end(), joined[k]);
    from[k] = old ? c.from[known] : c.last[k];
  }
  c.node = joined;
  c.from = from;
}

// Replaces the pairs of scratch.elements, or with `all` every pair, by scratch.found. Pairs that were listed
// before keep their state.
void pairs_join(EdgeScratch& scratch, bool all, model::EdgeContact& c) {
  const std::vector<std::uint32_t>& elements = scratch.elements;
  const std::vector<model::EdgePair>& found = scratch.found;
  std::vector<model::EdgePair>& pair = scratch.pairs;
  std::vector<double>& active = scratch.active_after_travel;
  pair.clear();
  active.clear();
  std::size_t element = 0, old = 0;
  const auto retain = [&](std::size_t k) {
    pair.push_back(c.pair[k]), active.push_back(c.active_after_travel[k]);
  };
  for (const model::EdgePair& p : found) {
    for (; old < c.pair.size() && before(c.pair[old], p); ++old) {
      while (element < elements.size() && elements[element] < c.pair[old].element) ++element;
      if (!all && (element == elements.size() || elements[element] != c.pair[old].element)) retain(old);
    }
    if (old < c.pair.size() && !before(p, c.pair[old])) retain(old++);
    else pair.push_back(p), active.push_back(c.travel);
  }
  for (; old < c.pair.size(); ++old) {
    while (element < elements.size() && elements[element] < c.pair[old].element) ++element;
    if (!all && (element == elements.size() || elements[element] != c.pair[old].element)) retain(old);
  }
  c.pair = pair;
  c.active_after_travel = active;
}

// Lists the pairs of scratch.nodes, which are sorted; with `all`, no other pairs are left.
void list(const Listing& listing, EdgeScratch& scratch, bool all, model::EdgeContact& c) {
  elements_of(listing.system.edge_elements, scratch.nodes, scratch.elements);
  pairs_find(listing, scratch);
  nodes_track(listing, scratch, c);
  pairs_join(scratch, all, c);
}

// Adds the travel of the nodes relative to the body, and sets the reach of the next step. Returns whether a
// node may, by the next step, have moved by `margin` (m) since its elements were listed: the list is then
// stale.
bool travel_add(const System& system, State& s, std::size_t b, double ahead, double margin) {
  model::BodyContact& body = s.body[b];
  model::EdgeContact& c = body.edges;
  double travel2 = 0, speed2 = 0;
  bool stale = false;
  for (std::size_t k = 0; k < c.node.size(); ++k) {
    const std::size_t n = c.node[k];
    const Vec3 at = position(s, n), x = model::pose_inward(system.bodies[b], body, at), moved = x - c.last[k];
    const Vec3 v = Vec3{s.vx[n], s.vy[n], s.vz[n]} - model::pose_velocity(system.bodies[b], body, at);
    const Vec3 away = x - c.from[k];
    const double v2 = dot(v, v), ahead2 = kAheadSteps * kAheadSteps * ahead * ahead * v2;
    travel2 = std::max(travel2, dot(moved, moved));
    speed2 = std::max(speed2, v2);
    stale = stale || 2 * (dot(away, away) + ahead2) > margin * margin;
    c.last[k] = x;
  }
  c.travel += std::sqrt(travel2);
  c.reach = kReachSteps * std::sqrt(speed2) * ahead + kReachDistance * max_contact_distance(system);
  return stale;
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

// An element is listed with the features within its contact distance and a margin M. Each of its nodes may
// move by M/2 after that. A node that has not moved by M/2 since its own elements were listed is no farther
// from where it was at the listing of any of them. Where one node is to be listed again, so are all that have
// used up half of that.
void edge_update_proximity(const System& system, EdgeScratch& scratch, State& s, std::size_t b,
                           double ahead) {
  std::vector<std::uint32_t>& nodes = scratch.nodes;
  model::EdgeContact& c = s.body[b].edges;
  if (c.fresh.empty() && c.node.empty()) return;
  const double half = min_margin(system) / 2;
  const bool stale = travel_add(system, s, b, ahead, half);
  if (!stale && c.fresh.empty()) return;
  nodes = c.fresh;
  c.fresh.clear();
  for (std::size_t k = 0; stale && k < c.node.size(); ++k) {
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
      const model::EdgeElement& element = system.edge_elements.element[pair.element];
      pair.sticking = 1;
      for (int k = 0; k < element.weights(); ++k) {
        const std::size_t n = element.node[k];
        if (s.vx[n] != 0 || s.vy[n] != 0 || s.vz[n] != 0) pair.sticking = 0;
      }
    }
  }
}

MaxStep edge_max_step(const System& system, const State& s) {
  MaxStep least;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    for (std::uint32_t n : s.body[b].edges.node) {
      const double speed = speed_of(system, s, b, n);
      max_step_include(least, {kMaxTravel * model::system_lattice_of(system, n).contact_law.distance / speed,
                               speed, b, n});
    }
  return least;
}

}  // namespace drape::contact
