// Parameters tuned while the cloth moves, through the C interface: which value acts when.
#include "tuning_fixture.h"

namespace drape::api {

using namespace tests;
namespace {

// Free fall while gravity goes from g to 0 within 10 q: g_k = g (1 - k/10) in the k-th interval. Leapfrog
// from a synchronous velocity is exact on this piecewise parabola: v <- v - g_k q, z <- z + v q - g_k q^2/2.
// The tolerance is 1e-13, for sums of a few hundred terms of 1e-3 m.
TEST(Tuning, GravityAlongARampInFreeFall) {
  Logged logged;
  const Cloth c = open_sheet(logged, false);
  ASSERT_TRUE(c) << logged.errors[0];
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
    EXPECT_EQ(logged.events.size(), k < 10 ? 0u : 1u);
  }
}

// An advance that is no multiple of q is one interval of its own length, with the values at its end.
TEST(Tuning, AnAdvanceOffTheGridMovesTheValuesByItsLength) {
  Logged logged;
  const Cloth c = open_sheet(logged, false), other = open_sheet(logged, false);
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
  Logged logged;
  std::vector<std::vector<double>> ends;
  for (const int calls : {1, 2, 4, 12}) {
    const Cloth c = open_sheet(logged, true);
    ASSERT_TRUE(c);
    run(c, 12, calls);
    tune_everything(c);
    run(c, 12, calls);
    ends.push_back(nodes(c));
  }
  for (const std::vector<double>& end : ends) EXPECT_EQ(end, ends[0]);
}

TEST(Tuning, ASavedStateKeepsItsRamp) {
  Logged logged;
  const Cloth c = open_sheet(logged, true);
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

// From the end of the ramp on, the cloth has the new values. A jump at that time from the same state gives
// the same motion, except for the rounding of the half steps before and after a jump.
TEST(Tuning, ValuesArriveExactly) {
  Logged logged;
  const Cloth c = open_sheet(logged, true);
  ASSERT_TRUE(c);
  run(c, 2);
  tune_everything(c);
  drape_parameters_of(c.get())->damping =
      0;  // else its two half steps would brake by (c h/2)^2 more than the whole
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
  // Positions of 1 m are rounded by 1e-16 m in each of some hundred steps, and the rounding swings at up to
  // 1e4/s.
  for (std::size_t k = 0; k < end.size(); ++k)
    EXPECT_NEAR(jumped[k], end[k], k < end.size() / 2 ? 1e-13 : 2e-11) << k;
  drape_snapshot_free(saved);
}

// Before the first step the start value applies at once, whatever the ramp.
TEST(Tuning, StartValuesAreThereAtOnce) {
  Logged logged;
  const Cloth c = open_sheet(logged, true), other = open_sheet(logged, true);
  ASSERT_TRUE(c && other);
  for (const Cloth* cloth : {&c, &other}) {
    tune_everything(*cloth);
    drape_parameters_of(cloth->get())->ramp = cloth == &c ? 1 : 0;
    run(*cloth, 4);
  }
  EXPECT_EQ(nodes(c), nodes(other));
}

// The diagram is 1, 9 N. During the ramp to 3, 9 N it is set to 3, 2 N, which falls: the previous target
// stays.
TEST(Tuning, TheTargetIsValidated) {
  Logged logged;
  const Cloth c = open_sheet(logged, true), other = open_sheet(logged, true);
  ASSERT_TRUE(c && other);
  for (const Cloth* cloth : {&c, &other}) {
    run(*cloth, 2);
    drape_parameters_of(cloth->get())->ramp = 10 * kQ;
    drape_parameters_of(cloth->get())->fabric[0].warp.force[0] = 3;
    run(*cloth, 4);
  }
  drape_parameters_of(c.get())->fabric[0].warp.force[1] = 2;
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_NE(logged.errors[0].find("fabric.f.warp.force[2] = 2 N"), std::string::npos) << logged.errors[0];
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].warp.force[0], 3);
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].warp.force[1], 9);
  run(c, 10), run(other, 10);
  EXPECT_EQ(nodes(c), nodes(other));
}

TEST(Tuning, RangesOfTheNewValues) {
  Logged logged;
  const Cloth c = open_sheet(logged, true);
  ASSERT_TRUE(c);
  drape_parameters& p = *drape_parameters_of(c.get());
  p.ramp = -1;
  p.fabric[0].damping = 11;
  p.fabric[0].friction = NAN;
  EXPECT_EQ(drape_commit(c.get()), DRAPE_DISCARD);
  ASSERT_EQ(logged.errors.size(), 3u);
  EXPECT_EQ(logged.errors[0], "parameter_ramp = -1 s; allowed: from 0 to 1000000 s");
  EXPECT_EQ(logged.errors[1], "fabric.f.damping = 11 s; allowed: from 0 to 1 s");
  EXPECT_EQ(logged.errors[2], "fabric.f.friction = nan; allowed: from 0 to 10");
  EXPECT_EQ(p.ramp, 0);
  EXPECT_EQ(p.fabric[0].damping, 0);
  EXPECT_EQ(p.fabric[0].friction, 0.3);
}

// Above order 2 no force may depend on velocity. Such a value is refused with one sentence, and the motion
// continues as if it had not been set.
TEST(Tuning, NoDampingAlongSpringsAboveOrder2) {
  Logged logged;
  const Cloth c = open_sheet(logged, true, "0.000030517578125", "", 4),
              other = open_sheet(logged, true, "0.000030517578125", "", 4);
  ASSERT_TRUE(c && other);
  run(c, 4), run(other, 4);
  drape_parameters_of(c.get())->fabric[0].damping = 1e-6;
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_EQ(
      logged.errors[0],
      "fabric.f.damping = 1e-06 s; allowed: 0 with scene.order = 4, whose steps go partly back in time, "
      "where it would speed the cloth up");
  EXPECT_EQ(drape_parameters_of(c.get())->fabric[0].damping, 0);
  run(c, 4), run(other, 4);
  EXPECT_EQ(nodes(c), nodes(other));
}

// Order 6 keeps its energy through a change of density and of c. A saved state continues to the same bits.
TEST(Tuning, AboveOrder2AChangeIsCountedAndASavedStateGoesOn) {
  Logged logged;
  const Cloth c = open_sheet(logged, true, "0.000030517578125", "", 6);
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
  // Leapfrog's own error is 1e-5 of the energies that move here.
  EXPECT_LE(std::abs(e.balance_error), 1e-9 * (e.kinetic + e.stretch + e.shear + e.dissipated));
  EXPECT_GT(e.dissipated, 0.01 * e.kinetic);
  drape_restore(c.get(), saved);
  run(c, 10, 2);
  EXPECT_EQ(nodes(c), end);
  drape_snapshot_free(saved);
}

// One advance reports all problems of its parameters and of its inputs.
TEST(Tuning, FaultsOfOneAdvanceAreReportedTogether) {
  Logged logged;
  const Cloth c = open_sheet(logged, true, "0.000030517578125", "drive = \"position\"\n");
  ASSERT_TRUE(c);
  drape_parameters_of(c.get())->damping = -1;
  drape_inputs_of(c.get())->pin[0].position[2] = NAN;
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_DISCARD);
  ASSERT_EQ(logged.errors.size(), 2u);
  EXPECT_EQ(logged.errors[0].rfind("damping = -1 1/s; allowed: ", 0), 0u);
  EXPECT_EQ(logged.errors[1].rfind("pin.corner.position[3] = nan m; allowed: ", 0), 0u);
  EXPECT_EQ(drape_advance(c.get(), kQ), DRAPE_OK);
}

// A damping of 1e-9/s has almost no effect. Along a ramp each interval begins with a half kick; still every
// impulse is reported exactly once (h is 1/64 of an advance). A refused advance keeps the force of the last
// one.
TEST(Tuning, PinsReportEachImpulseOnce) {
  Logged logged;
  const Cloth c = open_sheet(logged, true), untouched = open_sheet(logged, true);
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

// Neither friction without contact nor a ramp without a changed value alters a bit.
TEST(Tuning, WhatMovesNothingChangesNoBits) {
  Logged logged;
  const Cloth c = open_sheet(logged, true), untouched = open_sheet(logged, true);
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
