// Tuned values on their way: value after the k-th interval = from + (to - from) min(1, k q/T).
#include "api/ramp.h"

#include <gtest/gtest.h>

namespace drape::api {
namespace {

const std::vector<int> kGroup{0, 1, 2, 2, -1};  // two numbers, a diagram of two points, one that jumps
const ParameterValues kStart{{1, 10, 2, 4, 5}};

TEST(Ramp, GoesAlongALineAndArrivesExactly) {
  Ramp ramp = ramp_at(kStart);
  EXPECT_FALSE(ramp_under_way(ramp));
  const ParameterValues target{{3, 10, 2, 4, 5}};
  ramp_set_target(ramp, kStart, target, 10, kGroup);
  EXPECT_EQ(ramp_values(ramp), kStart);
  for (int k = 1; k < 10; ++k) {
    ramp_advance(ramp, 1);
    EXPECT_TRUE(ramp_under_way(ramp));
    EXPECT_DOUBLE_EQ(ramp_values(ramp).value[0], 1 + 2 * 0.1 * k);
    EXPECT_EQ(ramp_values(ramp).value[1], 10);
  }
  ramp_advance(ramp, 1);
  EXPECT_FALSE(ramp_under_way(ramp));
  EXPECT_EQ(ramp_values(ramp), target);
}

// 0.3/0.001 is 299.99999999999994, 0.7/0.001 is 700 and more: the way is 300 and 700 intervals long.
TEST(Ramp, ARoundedQuotientCostsNoInterval) {
  for (const auto& [length, intervals] : {std::pair{0.3, 300}, {0.7, 700}, {0.0105, 11}}) {
    Ramp ramp = ramp_at(kStart);
    ramp_set_target(ramp, kStart, {{3, 10, 2, 4, 5}}, length / 0.001, kGroup);
    int count = 0;
    for (; ramp_under_way(ramp); ++count) ramp_advance(ramp, 1);
    EXPECT_EQ(count, intervals);
  }
}

// Without a span, and for what never moves gradually.
TEST(Ramp, Jumps) {
  Ramp ramp = ramp_at(kStart);
  ramp_set_target(ramp, kStart, {{1, 10, 2, 4, 6}}, 10, kGroup);
  EXPECT_EQ(ramp_values(ramp).value[4], 6);
  EXPECT_FALSE(ramp_under_way(ramp));
  ramp_set_target(ramp, kStart, {{2, 10, 2, 4, 6}}, 0, kGroup);
  EXPECT_EQ(ramp_values(ramp).value[0], 2);
  EXPECT_FALSE(ramp_under_way(ramp));
}

TEST(Ramp, ANewTargetSetsOutFromThePresentValueAndLeavesTheOthersAlone) {
  Ramp ramp = ramp_at(kStart);
  ramp_set_target(ramp, kStart, {{3, 20, 2, 4, 5}}, 10, kGroup);
  ramp_advance(ramp, 5);
  ParameterValues now = ramp_values(ramp);
  EXPECT_EQ(now, (ParameterValues{{2, 15, 2, 4, 5}}));
  ramp_set_target(ramp, now, {{0, 20, 2, 4, 5}}, 4, kGroup);
  EXPECT_EQ(ramp_values(ramp), now);
  ramp_advance(ramp, 2);
  EXPECT_EQ(ramp_values(ramp), (ParameterValues{{1, 17, 2, 4, 5}}));
  ramp_advance(ramp, 3);
  EXPECT_EQ(ramp_values(ramp), (ParameterValues{{0, 20, 2, 4, 5}}));
  EXPECT_FALSE(ramp_under_way(ramp));
}

// One point of a diagram set anew takes the others with it: between two diagrams that do not fall, none does.
TEST(Ramp, ThePointsOfADiagramMoveTogether) {
  Ramp ramp = ramp_at(kStart);
  ramp_set_target(ramp, kStart, {{1, 10, 6, 8, 5}}, 10, kGroup);
  ramp_advance(ramp, 5);
  const ParameterValues now = ramp_values(ramp);
  EXPECT_EQ(now, (ParameterValues{{1, 10, 4, 6, 5}}));
  ramp_set_target(ramp, now, {{1, 10, 6, 20, 5}}, 10, kGroup);
  ramp_advance(ramp, 5);
  EXPECT_EQ(ramp_values(ramp), (ParameterValues{{1, 10, 5, 13, 5}}));
}

}  // namespace
}  // namespace drape::api
