// Parameters tuned while the cloth moves, through the C interface: which value acts when.
#include "tuning_fixture.h"

namespace drape::api {

using namespace tests;
namespace {

// Free fall with gravity on its way from g to 0 within 10 q: g_k = g (1 - k/10) in the k-th interval, a
// parabola, on which leapfrog from a synchronous velocity lies: v <- v - g_k q, z <- z + v q - g_k q^2/2.
// Sums of a few hundred terms of 1e-3 m, to 1e-13.
TEST(Tuning, GravityAlongARampInFreeFall) {
  Heard heard;
  const Cloth c = open_sheet(heard, false);
  ASSERT_TRUE(c) << heard.errors[0];
  run(c, 4);
  drape_parameters_of(c.get())->ramp = 10 * kQ;
  drape_parameters_of(c.get())->gravity[2] = 0;
  double z = 1, v = 0;
  const auto fall = [&](double g) {
    z += v * kQ - g * kQ * kQ / 2;
    v -= g * kQ;
  };
  for (int k = 0; k < 4; ++k) fall(kG);
  EXPECT_NEAR(height(c), z, 1e-13);
  for (int k = 1; k <= 15; ++k) {
    run(c, 1);
    fall(kG * (1 - std::min(1.0, 0.1 * k)));
    EXPECT_NEAR(height(c), z, 1e-13) << k;
    EXPECT_EQ(heard.events.size(), k < 10 ? 0u : 1u);
  }
}

// An advance that is no multiple of q is one interval of its own length: the share is that of its end.
TEST(Tuning, AnAdvanceOffTheGridMovesTheValuesByItsLength) {
  Heard heard;
  const Cloth c = open_sheet(heard, false), other = open_sheet(heard, false);
  ASSERT_TRUE(c && other);
  run(c, 1), run(other, 1);
  drape_parameters_of(c.get())->ramp = 10 * kQ;
  drape_parameters_of(c.get())->gravity[2] = 0;
  drape_parameters_of(other.get())->gravity[2] = -0.75 * kG;
  ASSERT_EQ(drape_advance(c.get(), 2.5 * kQ), DRAPE_OK);
  ASSERT_EQ(drape_advance(other.get(), 2.5 * kQ), DRAPE_OK);
  EXPECT_NEAR(height(c), height(other), 1e-15);
}

TEST(Tuning, GroupingOfStepsDoesNotChangeBits) {
  Heard heard;
  std::vector<std::vector<double>> ends;
  for (const int calls : {1, 2, 4, 12}) {
    const Cloth c = open_sheet(heard, true);
    ASSERT_TRUE(c);
    run(c, 12, calls);
    tune_everything(c);
    run(c, 12, calls);
    ends.push_back(nodes(c));
  }
  for (const std::vector<double>& end : ends) EXPECT_EQ(end, ends[0]);
}

TEST(Tuning, ASavedStateKeepsItsRamp) {
  Heard heard;
  const Cloth c = open_sheet(heard, true);
  ASSERT_TRUE(c);
  run(c, 2);
  tune_everything(c);
  run(c, 3);
  drape_parameters_of(c.get())->gravity[1] = 4;  // not committed yet
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  run(c, 12);
  const std::vector<double> end = nodes(c);
  drape_parameters_of(c.get())->damping = 100;
  run(c, 2);
  drape_restore(c.get(), saved);
  run(c, 12);
  EXPECT_EQ(nodes(c), end);
  drape_snapshot_free(saved);
}

// From the end of the way on, the cloth is one of the new values: a jump at that time from the same state,
// but for the rounding of the half steps that lead to and from a jump.
TEST(Tuning, ValuesArriveExactly) {
  Heard heard;
  const Cloth c = open_sheet(heard, true);
  ASSERT_TRUE(c);
  run(c, 2);
  tune_everything(c);
  drape_parameters_of(c.get())->damping =
      0;  // of which the two half steps brake by (c h/2)^2 more than the whole
  run(c, 8);
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  run(c, 4);
  const std::vector<double> end = nodes(c);
  drape_restore(c.get(), saved);
  drape_parameters_of(c.get())->gravity[0] = 5;
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK);
  drape_parameters_of(c.get())->ramp = 0;
  drape_parameters_of(c.get())->gravity[0] = 2;
  ASSERT_EQ(drape_commit(c.get()), DRAPE_OK);
  run(c, 4);
  const std::vector<double> jumped = nodes(c);
  // Places of 1 m round by 1e-16 m in each of some hundred steps, which swings at up to 1e4/s.
  for (std::size_t k = 0; k < end.size(); ++k)
    EXPECT_NEAR(jumped[k], end[k], k < end.size() / 2 ? 1e-13 : 2e-11) << k;
  drape_snapshot_free(saved);
}

// Before the first step: the start value, whatever the ramp.
TEST(Tuning, StartValuesAreThereAtOnce) {
  Heard heard;
  const Cloth c = open_sheet(heard, true), other = open_sheet(heard, true);
  ASSERT_TRUE(c && other);
  for (const Cloth* cloth : {&c, &other}) {
    tune_everything(*cloth);
    drape_parameters_of(cloth->get())->ramp = cloth == &c ? 1 : 0;
    run(*cloth, 4);
  }
  EXPECT_EQ(nodes(c), nodes(other));
}

// The diagram is 1, 9 N; on its way to 3, 9 it is set to 3, 2: that falls, and the target before it stays.
TEST(Tuning, TheTargetIsValidated) {
  Heard heard;
  const Cloth c = open_sheet(heard, true), other = open_sheet(heard, true);
  ASSERT_TRUE(c && other);
  for (const Cloth* cloth : {&c, &other}) {
    run(*cloth, 2);
    drape_parameters_of(cloth->get())->ramp = 10 * kQ;
    drape_parameters_of(cloth->get())->fabric[0].warp.force[0] = 3;
    run(*cloth, 4);
  }
  drape_parameters_of(c.get())->fabric[0].warp.force[1] = 2;
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  ASSERT_EQ(heard.errors.size(), 1u);
  EXPECT_NE(heard.errors[0].find("fabric.f.warp.force[2] = 2 N"), std::string::npos) << heard.errors[0];
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].warp.force[0], 3);
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].warp.force[1], 9);
  run(c, 10), run(other, 10);
  EXPECT_EQ(nodes(c), nodes(other));
}

TEST(Tuning, RangesOfTheNewValues) {
  Heard heard;
  const Cloth c = open_sheet(heard, true);
  ASSERT_TRUE(c);
  drape_parameters& p = *drape_parameters_of(c.get());
  p.ramp = -1;
  p.fabric[0].damping = 11;
  p.fabric[0].friction = NAN;
  EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD);
  ASSERT_EQ(heard.errors.size(), 3u);
  EXPECT_EQ(heard.errors[0], "parameter_ramp = -1 s; allowed: from 0 to 1000000 s");
  EXPECT_EQ(heard.errors[1], "fabric.f.damping = 11 s; allowed: from 0 to 1 s");
  EXPECT_EQ(heard.errors[2], "fabric.f.friction = nan; allowed: from 0 to 10");
  EXPECT_EQ(p.ramp, 0);
  EXPECT_EQ(p.fabric[0].damping, 0);
  EXPECT_EQ(p.fabric[0].friction, 0.3);
}

// Above order 2 no force may depend on velocity: such a value is refused in one sentence, and the motion is
// that of a cloth where nobody tried.
TEST(Tuning, NoDampingAlongSpringsAboveOrder2) {
  Heard heard;
  const Cloth c = open_sheet(heard, true, "0.000030517578125", "", 4),
              other = open_sheet(heard, true, "0.000030517578125", "", 4);
  ASSERT_TRUE(c && other);
  run(c, 4), run(other, 4);
  drape_parameters_of(c.get())->fabric[0].damping = 1e-6;
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  ASSERT_EQ(heard.errors.size(), 1u);
  EXPECT_EQ(
      heard.errors[0],
      "fabric.f.damping = 1e-06 s; allowed: 0 with scene.order = 4, whose steps go partly back in time, "
      "where it would speed the cloth up");
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].damping, 0);
  run(c, 4), run(other, 4);
  EXPECT_EQ(nodes(c), nodes(other));
}

// Order 6 keeps its energy through a change of density and of c, and goes on from a saved state to the same
// bits.
TEST(Tuning, AboveOrder2AChangeIsCountedAndASavedStateGoesOn) {
  Heard heard;
  const Cloth c = open_sheet(heard, true, "0.000030517578125", "", 6);
  ASSERT_TRUE(c);
  run(c, 4);
  drape_parameters_of(c.get())->damping = 30;
  drape_parameters_of(c.get())->ramp = 5 * kQ;
  drape_parameters_of(c.get())->fabric[0].areal_density = 0.2;
  run(c, 3, 3);
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  run(c, 10, 10);
  const std::vector<double> end = nodes(c);
  const drape_energy e = drape_get_outputs(c.get(), DRAPE_OUT_SCALARS)->energy;
  // Leapfrog's own error is 1e-5 of what moves here.
  EXPECT_LE(std::abs(e.balance_error), 1e-9 * (e.kinetic + e.stretch + e.shear + e.dissipated));
  EXPECT_GT(e.dissipated, 0.01 * e.kinetic);
  drape_restore(c.get(), saved);
  run(c, 10, 2);
  EXPECT_EQ(nodes(c), end);
  drape_snapshot_free(saved);
}

// One advance tells of both what is wrong with its parameters and what with its inputs.
TEST(Tuning, FaultsOfOneAdvanceAreReportedTogether) {
  Heard heard;
  const Cloth c = open_sheet(heard, true, "0.000030517578125", "drive = \"position\"\n");
  ASSERT_TRUE(c);
  drape_parameters_of(c.get())->damping = -1;
  drape_inputs_of(c.get())->pin[0].position[2] = NAN;
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  ASSERT_EQ(heard.errors.size(), 2u);
  EXPECT_EQ(heard.errors[0].rfind("damping = -1 1/s; allowed: ", 0), 0u);
  EXPECT_EQ(heard.errors[1].rfind("pin.corner.position[3] = nan m; allowed: ", 0), 0u);
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_OK);
}

// A damping of 1e-9/s does next to nothing. On its way along a ramp each interval begins with half a kick,
// and still every impulse is told, once: all of h is 1/64 of an advance. A refused advance leaves the last
// one's force as it was.
TEST(Tuning, PinsReportEachImpulseOnce) {
  Heard heard;
  const Cloth c = open_sheet(heard, true), untouched = open_sheet(heard, true);
  ASSERT_TRUE(c && untouched);
  run(c, 20), run(untouched, 20);
  drape_parameters_of(c.get())->ramp = 8 * kQ;
  drape_parameters_of(c.get())->damping += 1e-9;
  for (int k = 0; k < 6; ++k) {
    run(c, 2), run(untouched, 2);
    EXPECT_NEAR(pin_force(c), pin_force(untouched), 1e-8 * std::abs(pin_force(untouched))) << k;
  }
  const double force = pin_force(c);
  drape_parameters_of(c.get())->damping += 1e-9;
  drape_parameters_of(c.get())->ramp = 0;
  drape_parameters_of(c.get())->gravity[1] = NAN;
  ASSERT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  EXPECT_NEAR(pin_force(c), force, 1e-12 * std::abs(force));
}

// Neither friction, where nothing touches, nor a ramp without anything on its way changes a bit.
TEST(Tuning, WhatMovesNothingChangesNoBits) {
  Heard heard;
  const Cloth c = open_sheet(heard, true), untouched = open_sheet(heard, true);
  ASSERT_TRUE(c && untouched);
  for (int k = 0; k < 12; ++k) {
    if (k % 3 == 1) drape_parameters_of(c.get())->ramp = k * kQ;
    if (k % 3 == 2) drape_parameters_of(c.get())->fabric[0].friction = 0.05 * k;
    run(c, 2), run(untouched, 2);
    EXPECT_EQ(pin_force(c), pin_force(untouched)) << k;
    EXPECT_EQ(energy(c).kinetic, energy(untouched).kinetic) << k;
    EXPECT_EQ(energy(c).balance_error, energy(untouched).balance_error) << k;
  }
}

}  // namespace
}  // namespace drape::api
