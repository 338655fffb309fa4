// Which particles are checked against a body after a step. core/README.md, section 7.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "contact/particle/contact_pass.h"
#include "dynamics/kernel/kernel.h"
#include "model/composition.h"

namespace drape::contact {
namespace {

// Particles move with velocities that are new in every stage. A block becomes stale when one of its
// particles is past its free distance or would be after one more step: |r + h v - from| >= free distance. No
// other block does, whichever groups are skipped; also where the stages of a step go partly back in time.
TEST(Proximity, FindsWhatEveryComparisonWould) {
  constexpr std::size_t kNodes = 5 * kProximityGroup + math::kRowUnit, kBlocks = kNodes / math::kRowUnit;
  constexpr double kForward[] = {1}, kStep = 1e-3;
  const auto drifts = [&](int order) {
    const model::Composition* of = model::composition_of(order);
    return of ? std::vector<double>(of->drift, of->drift + of->stages)
              : std::vector<double>(kForward, kForward + 1);
  };
  for (const char* name : {"scalar", "portable", "avx2", "avx512"})
    for (int order : {2, 4, 6}) {
      const dynamics::Kernel* kernel = dynamics::kernel_named(name);
      if (!kernel) continue;  // not on this processor
      std::mt19937 random(7);
      std::uniform_real_distribution<double> speed(-1, 1), free_distance(0.002, 0.05);
      Array r[3], v[3];
      for (Array& of : r) of.assign(kNodes, 0.0);
      for (Array& of : v) of.assign(kNodes, 0.0);
      model::BodyContact body;
      body.rotation = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
      body.x = body.y = body.z = Array(kNodes, 0.0);
      body.free_distance2.assign(kNodes, 0.0);
      body.group_clearance.assign(kBlocks, 0.0);
      std::vector<std::size_t> stale(kBlocks);
      std::size_t none = 0, some = 0;
      for (int step = 0; step < 400; ++step)
        for (const double share : drifts(order)) {
          const double fast = step % 40 < 8 ? 5 : 0.1;
          for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t n = 0; n < kNodes; ++n) {
              v[k][n] = fast * speed(random);
              r[k][n] += share * kStep * v[k][n];
            }
          const ProximityPass pass{&body,
                                   {r[0].data(), r[1].data(), r[2].data()},
                                   {v[0].data(), v[1].data(), v[2].data()},
                                   share * kStep,
                                   kStep,
                                   0,
                                   kNodes};
          const std::size_t count = kernel->contact.update_proximity[0](pass, stale.data());
          std::vector<std::size_t> expected;
          for (std::size_t b = 0; b < kNodes; b += math::kRowUnit) {
            bool is = false;
            for (std::size_t n = b; n < b + math::kRowUnit; ++n) {
              const double x = r[0][n] + kStep * v[0][n] - body.x[n],
                           y = r[1][n] + kStep * v[1][n] - body.y[n],
                           z = r[2][n] + kStep * v[2][n] - body.z[n];
              is = is || x * x + y * y + z * z >= body.free_distance2[n];
            }
            if (is) expected.push_back(b);
          }
          ASSERT_EQ(std::vector<std::size_t>(stale.begin(), stale.begin() + std::ptrdiff_t(count)), expected)
              << name << ", order " << order << ", step " << step;
          (expected.empty() ? none : some) += 1;
          for (std::size_t b : expected)
            for (std::size_t n = b; n < b + math::kRowUnit; ++n) {
              body.x[n] = r[0][n], body.y[n] = r[1][n], body.z[n] = r[2][n];
              body.free_distance2[n] = free_distance(random) * free_distance(random) * 10;
            }
        }
      EXPECT_GT(none, 40u);
      EXPECT_GT(some, 40u);
    }
}

}  // namespace
}  // namespace drape::contact
