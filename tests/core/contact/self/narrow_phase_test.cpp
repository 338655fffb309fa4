// When pairs and edges are looked at again changes nothing of what touches.
#include "contact/self/narrow_phase.h"

#include <gtest/gtest.h>

#include "contact/self/closest_lanes.h"
#include "contact/self/self_contact.h"
#include "contact/self/self_fixture.h"
#include "simd/lane_scalar.h"

namespace drape::contact {

using namespace tests;
namespace {

constexpr double kThickness = 1e-3, kCell = 0.01;

// Two flat sheets, 0.9 thicknesses apart. The middles of their edges cross.
Assembled two_flat() {
  Scene scene = reference::rectangle(linen(kThickness), 0.1, 0.1, kCell);
  scene.self_contact = true;
  sheet_add(scene, "upper", 0.1, 0.1, kCell, {kCell / 2, kCell / 2, 1.5 * kThickness});
  Assembled a = assemble(scene);
  for (std::size_t n : a.system.particle)
    if (a.system.lattices[1].owns(n)) a.state.z[n] -= 0.6 * kThickness;
  self_begin(a.system, a.state);
  return a;
}

// Folds both sheets towards each other: the middle column of one, the middle row of the other.
void fold(Assembled& a, double height) {
  for (std::size_t n : a.system.particle)
    for (const std::size_t piece : {0u, 1u}) {
      const model::Lattice& l = a.system.lattices[piece];
      if (!l.owns(n)) continue;
      const auto [i, j] = l.place_of(n);
      if ((piece == 0 ? i : j) == 5) a.state.z[n] += piece == 0 ? height : -height;
    }
  self_invalidate_proximity(a.system, a.state, height);
}

std::vector<SelfContactPair> pairs_of(const System& system, State& s, bool schedules) {
  SelfContactPairs pairs;
  self_narrow_phase(system, s, self_still_reach(system), self_points_lanes<simd::ScalarLane<false>>, pairs,
                    schedules ? &s.self : nullptr);
  return pairs.pair;
}

std::size_t crosses(const std::vector<SelfContactPair>& pairs) {
  return std::size_t(std::ranges::count(pairs, true, &SelfContactPair::cross));
}

// Edges of flat cloth do not protrude. After a fold they do, before their distance is used up.
TEST(SelfNarrowPhase, FindsEdgesThatRise) {
  for (const bool schedules : {false, true}) {
    Assembled a = two_flat();
    const std::vector<SelfContactPair> flat = pairs_of(a.system, a.state, true);
    EXPECT_GT(flat.size(), 100u);
    fold(a, 0.13 * kThickness);
    const std::vector<SelfContactPair> found = pairs_of(a.system, a.state, schedules);
    State fresh = a.state;
    self_begin(a.system, fresh);
    const std::vector<SelfContactPair> expected = pairs_of(a.system, fresh, false);
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(crosses(found), crosses(flat) + 1);
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].node, expected[k].node);
      EXPECT_EQ(found[k].share, expected[k].share);
    }
  }
}

}  // namespace
}  // namespace drape::contact
