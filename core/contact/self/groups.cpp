#include "contact/self/groups.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "math/vector3.h"

namespace drape::contact {
namespace {

using namespace math::vector3;

constexpr double kSoft = 0.25;  // of omega^2 of contact with bodies: a particle is in several pairs

const model::ContactLaw& law_of(const System& system, const SelfContactPair& t, std::size_t side) {
  const model::NodeIndex node = t.node[side == 0 ? 0 : t.cross ? 2 : 1];
  return system.lattices[std::size_t(system.self.lattice_of[node])].contact_law;
}

// Collects the nodes of all pairs.
void nodes_collect(const System& system, const std::vector<SelfContactPair>& pairs, SelfGroups& all) {
  SelfNodes& nodes = all.node;
  nodes.node.clear();
  all.index.resize(system.nodes, -1);
  for (const SelfContactPair& t : pairs)
    for (model::NodeIndex n : t.node)
      if (int& at = all.index[n]; at < 0) at = int(nodes.node.size()), nodes.node.push_back(n);
  const std::size_t size = nodes.node.size();
  nodes.fixed.resize(size);
  for (std::size_t k = 0; k < size; ++k) nodes.fixed[k] = system.self.fixed[nodes.node[k]];
  nodes.pushed.assign(size + 1, 0.0);
  for (Array* rows : {&nodes.r, &nodes.old, &nodes.v}) rows->assign(4 * (size + 1), 0.0);
}

// Deals pairs out to groups: each to the first open one that has none of its nodes.
struct Dealer {
  static constexpr int kOpen = 64;
  SelfGroups& all;
  std::vector<std::uint64_t> open_with;  // [nodes] a bit for each open group that has the node
  std::array<std::uint32_t, kOpen> group{};
  std::array<std::size_t, kOpen> filled{};
  std::uint64_t open = 0;
  bool crosses = false;  // of the groups that are opened

  void close(int k) {
    const SelfGroup& g = all.group[group[std::size_t(k)]];
    for (const auto& at : g.at)
      for (int n : at) open_with[std::size_t(n)] &= ~(std::uint64_t(1) << k);
    open &= ~(std::uint64_t(1) << k);
  }
  int open_one() {
    if (open == ~std::uint64_t(0))
      close(int(std::max_element(filled.begin(), filled.end()) - filled.begin()));
    const int k = std::countr_one(open);
    open |= std::uint64_t(1) << k;
    group[std::size_t(k)] = std::uint32_t(all.group.size());
    filled[std::size_t(k)] = 0;
    SelfGroup& g = all.group.emplace_back();
    g.crosses = crosses;
    for (auto& at : g.at) std::fill_n(at, kGroupPairs, int(all.node.node.size()));
    return k;
  }
  void turn_to(bool to_crosses) {
    for (int k = 0; k < kOpen; ++k)
      if (open >> k & 1) close(k);
    crosses = to_crosses;
  }
  void deal(const std::array<int, 4>& at) {
    std::uint64_t taken = 0;
    for (int n : at) taken |= open_with[std::size_t(n)];
    const std::uint64_t fits = open & ~taken;
    const int k = fits != 0 ? std::countr_zero(fits) : open_one();
    const std::size_t lane = filled[std::size_t(k)]++;
    all.slot.push_back(std::uint32_t(group[std::size_t(k)] * kGroupPairs + lane));
    SelfGroup& g = all.group[group[std::size_t(k)]];
    for (std::size_t n = 0; n < 4; ++n) {
      g.at[n][lane] = at[n];
      open_with[std::size_t(at[n])] |= std::uint64_t(1) << k;
    }
    if (lane + 1 == kGroupPairs) close(k);
  }
};

// What stays as long as the pairs are the same.
void groups_make(const System& system, const std::vector<SelfContactPair>& pairs, SelfGroups& all) {
  nodes_collect(system, pairs, all);
  all.group.clear();
  all.slot.clear();
  Dealer dealer{all, std::vector<std::uint64_t>(all.node.node.size() + 1, 0)};
  for (const SelfContactPair& t : pairs) {
    if (t.cross != dealer.crosses) dealer.turn_to(t.cross);
    std::array<int, 4> at{};
    for (std::size_t k = 0; k < 4; ++k) at[k] = all.index[t.node[k]];
    dealer.deal(at);
  }
  for (model::NodeIndex n : all.node.node) all.index[n] = -1;
}

bool made_for(const SelfGroups& all, const model::SelfState& self,
              const std::vector<SelfContactPair>& pairs) {
  return all.candidates == self.pairs &&
         std::equal(pairs.begin(), pairs.end(), all.made_for.begin(), all.made_for.end(),
                    [](const SelfContactPair& t, std::uint32_t k) { return t.candidate == k; });
}

// The present state of the nodes.
void nodes_update(const System& system, const State& s, bool inertia_of_fit, SelfNodes& nodes) {
  const double* const r[3] = {s.x.data(), s.y.data(), s.z.data()};
  const double* const v[3] = {s.vx.data(), s.vy.data(), s.vz.data()};
  const bool scaled = inertia_of_fit && !s.inverse_mass_scale.empty();
  for (std::size_t k = 0; k < nodes.node.size(); ++k) {
    const std::size_t n = nodes.node[k];
    const double inverse = (scaled ? s.inverse_mass_scale[n] : 1) * system.inverse_mass[n];
    nodes.v[4 * k + 3] = nodes.fixed[k] ? 0 : inverse;
    nodes.pushed[k] = nodes.fixed[k] ? inverse : 0;
    row_set(nodes.r, k, r, n);
    row_set(nodes.old, k, v, n);
  }
}

// The friction (N) of the last step of a pair, and whether it stuck. The list is in the order of the pairs.
struct Holds {
  std::vector<model::SelfHold>::const_iterator at, end;

  const model::SelfHold* find(const SelfContactPair& t) {
    const auto before = [&](const model::SelfHold& h) {
      return h.cross != t.cross ? t.cross : h.node < t.node;
    };
    while (at != end && before(*at)) ++at;
    return at != end && at->cross == t.cross && at->node == t.node ? &*at : nullptr;
  }
};

void lane_set(const SelfContactPair& t, const SelfPairLaw& law, const model::SelfHold* hold, SelfGroup& g,
              std::size_t lane) {
  const Vec3 friction = hold ? hold->force - dot(hold->force, t.n) * t.n : Vec3{0, 0, 0};
  for (std::size_t k = 0; k < 4; ++k) g.weight[k][lane] = t.weight[k];
  for (std::size_t k = 0; k < 3; ++k) g.n[k][lane] = t.n[k], g.friction[k][lane] = friction[k];
  g.distance[lane] = t.distance;
  g.contact_distance[lane] = t.contact_distance;
  g.stiffness[lane] = t.share * law.stiffness;
  g.slide[lane] = law.slide;
  g.limit[lane] = hold && hold->sticks ? law.stick : law.slide;
}

}  // namespace

SelfContactPass self_pass(const ContactCoefficients& c, SelfGroups& all) {
  SelfNodes& n = all.node;
  return {all.group.data(),
          all.group.data() + all.group.size(),
          n.pushed.data(),
          n.r.data(),
          n.old.data(),
          n.v.data(),
          c};
}

SelfPairLaw self_pair_law(const System& system, const SelfContactPair& t) {
  const model::ContactLaw &a = law_of(system, t, 0), &b = law_of(system, t, 1);
  double smallest = INFINITY;
  for (model::NodeIndex n : t.node) smallest = std::min(smallest, system.mass[n]);
  return {kSoft * std::min(a.omega2, b.omega2) * smallest / 2, (a.friction[0] + b.friction[0]) / 2,
          (a.friction[1] + b.friction[1]) / 2};
}

void self_group(const System& system, const State& s, bool inertia_of_fit,
                const std::vector<SelfContactPair>& pairs, SelfGroups& all) {
  if (!made_for(all, s.self, pairs)) {
    groups_make(system, pairs, all);
    all.candidates = s.self.pairs;
    all.made_for.clear();
    for (const SelfContactPair& t : pairs) all.made_for.push_back(t.candidate);
  }
  nodes_update(system, s, inertia_of_fit, all.node);
  Holds holds{s.self.hold.begin(), s.self.hold.end()};
  for (std::size_t p = 0; p < pairs.size(); ++p)
    lane_set(pairs[p], self_pair_law(system, pairs[p]), holds.find(pairs[p]),
             all.group[all.slot[p] / kGroupPairs], all.slot[p] % kGroupPairs);
}

}  // namespace drape::contact
