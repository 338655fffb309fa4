// The energy guard: core/README.md, section 4, "Energy guard".
#include "dynamics/energy_guard.h"

#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "model/kinetic_energy.h"
#include "outputs/outputs.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// Cloth with straight laws, that hangs from an edge and swings without damping.
Scene swinging() {
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01);
  scene.gravity = {0, 3, -9.81};
  scene.pins = {{"pin", 0, {}, {0}}};
  return scene;
}

double share_missing(const Assembled& a) { return std::abs(a.state.guard.worst) / a.state.guard.worst_size; }

Scene thrown(const Vec3& velocity) {
  Scene scene = swinging();
  scene.pieces[0].velocity = velocity;
  return scene;
}

TEST(EnergyGuard, MissesLittleWhereLittleIsMissing) {
  for (const double damping : {0.0, 2.0, 50.0}) {
    Scene scene = swinging();
    scene.damping = damping;
    Assembled a = assemble(scene);
    advance(a, 0.3);
    SCOPED_TRACE(damping);
    EXPECT_TRUE(a.state.guard.begun);
    EXPECT_LE(share_missing(a), 1e-4);
    EXPECT_EQ(a.state.guard.refinement, 1);
    EXPECT_NEAR(a.state.guard.unaccounted, 0, 0.01 * a.state.guard.largest);
    if (damping > 0) {
      EXPECT_GT(a.state.guard.damped, 0.01 * a.state.guard.largest);
    }
  }
}

// A cloth that is thrown ends in stiff vibrations. By m v-.v+/2 + U it would lose 2 to 3 % at this step,
// though it loses none for good: that falls by (h omega)^2/6 of all energy that moves into a vibration of
// omega.
TEST(EnergyGuard, TakesStiffVibrationsForNoLoss) {
  Scene scene = thrown({1, -2, 1});
  scene.step = 0.55 * step_limit_of(assemble(scene).system, assemble(scene).state.omega2);
  scene.communication = 0.001;
  Assembled a = assemble(scene);
  const double energy = model::kinetic_energy(a.system, a.state);
  for (int k = 0; k < 1000; ++k) advance(a, 0.001);
  EXPECT_GT(a.state.guard.largest, energy);
  EXPECT_LE(share_missing(a), 0.005);
}

// One cell vibrates evenly. At one of these steps a look at every eighth would see it at one phase.
// Velocities are those between the steps, whose squares are larger by (h omega)^2/4.
TEST(EnergyGuard, KnowsWhatDampingTakesFromOneVibration) {
  for (double share = 0.25; share < 0.34; share += 0.01) {
    Scene scene = reference::rectangle(linen(), 0.01, 0.01, 0.01);
    scene.damping = 50;
    scene.gravity = {0, 0, 0};
    scene.pins = {{"pin", 0, {}, {0}}};
    scene.pieces[0].velocity = {0, 0.1, 0};
    scene.step = share * step_limit_of(assemble(scene).system, assemble(scene).state.omega2);
    Assembled a = assemble(scene);
    advance(a, 0.02);
    EXPECT_NEAR(a.state.guard.damped / a.state.guard.largest, 1 - std::exp(-50 * 0.02), 0.05) << share;
  }
}

// One cell, thrown along its warp, has all its energy in its stiffest vibration. At the step of other cloth
// T + U would ripple by (h omega)^2/4 of it, almost by half.
TEST(EnergyGuard, KeepsTheRippleOfASingleCellSmall) {
  for (const double damping : {0.0, 5.0}) {
    Scene scene = reference::rectangle(linen(), 0.01, 0.01, 0.01);
    scene.energy = true;
    scene.damping = damping;
    scene.gravity = {0, 0, 0};
    scene.pins = {{"pin", 0, {}, {0}}};
    scene.pieces[0].velocity = {0, 0.1, 0};
    Assembled a = assemble(scene);
    energy_begin(a.system, a.state);
    const double thrown = a.state.energy_start;
    outputs::Outputs o;
    outputs::outputs_make(o, a.scene, a.system);
    double missing = 0;
    for (int k = 0; k < 300; ++k) {
      advance(a, 0.001);
      outputs::outputs_fill(o, a.system, a.motion, a.state, DRAPE_OUT_ENERGY);
      missing = std::max(missing, std::abs(o.c_view.energy.balance_error));
    }
    EXPECT_LE(missing, 0.01 * thrown) << damping;
  }
}

// The energy that the given step takes out of the constant belongs to the step, not to the motion.
TEST(EnergyGuard, TakesAChangeOfTheStepForNoChangeOfTheEnergy) {
  Scene scene = swinging();
  scene.step = 2e-5;
  Assembled a = assemble(scene);
  crumple(a, 1e-5, 1);  // stiff vibrations, whose term of the step is large
  advance(a, 0.02);
  const double before = a.state.guard.unaccounted;
  a.system.step_given = 1e-5;
  a.state.steps_per_interval *= 2;
  advance(a, 0.02);
  EXPECT_NEAR(a.state.guard.unaccounted, before, 1e-3 * a.state.guard.largest);
}

void gain(State& s, double factor) {
  for (Array* v : {&s.vx, &s.vy, &s.vz})
    for (double& one : *v) one *= factor;
}

TEST(EnergyGuard, FindsEnergyThatWasPlanted) {
  for (const double factor : {1.05, 0.9}) {
    Scene scene = swinging();
    scene.step = 2e-5;  // a step that is given is not refined
    Assembled a = assemble(scene);
    advance(a, 0.08);
    const double kinetic = model::kinetic_energy(a.system, a.state);
    gain(a.state, factor);
    advance(a, 0.02);
    EXPECT_NEAR(a.state.guard.unaccounted, kinetic * (factor * factor - 1), 0.02 * kinetic);
    EXPECT_EQ(std::signbit(a.state.guard.worst), factor < 1);
    EXPECT_GT(share_missing(a), 0.01);
  }
}

// A master that sends positions off the grid makes the step change where velocities jump.
TEST(EnergyGuard, FollowsAStepThatChangesInAJump) {
  for (const double length : {0.001, 0.00101, 0.0012}) {
    Scene scene = thrown({0, 0, -1});
    scene.pins[0].drive = scene::Drive::kPosition;
    scene.step = 3e-5;
    scene.communication = 0.001;
    Assembled a = assemble(scene);
    for (double t = 0; t < 0.3; t += length) {
      a.motion.inputs.pin[0].position[1] = 0.01 * std::sin(25 * (t + length));
      advance(a, length);
    }
    SCOPED_TRACE(length);
    EXPECT_LE(share_missing(a), 0.005);
  }
}

// The work of a jolt is booked, and the energy that the step then has.
TEST(EnergyGuard, FollowsJolts) {
  Scene scene = swinging();
  scene.pins[0].drive = scene::Drive::kPosition;
  Assembled a = assemble(scene);
  for (int k = 0; k < 60; ++k) {
    if (k % 10 == 0) a.motion.inputs.pin[0].position[2] = k % 20 == 0 ? 0.004 : 0;
    advance(a, 0.002);
  }
  EXPECT_LE(share_missing(a), 0.005);
}

TEST(EnergyGuard, KnowsWhatDampingTakesInStepsOfAnySize) {
  Scene scene = thrown({0, 0, -2});
  scene.damping = 20;
  scene.step = scene.communication = 2e-5;
  Assembled a = assemble(scene);
  for (double t = 0; t < 0.05; t += 2.02e-5) {
    advance(a, 2e-5);
    advance(a, 2e-7);
  }
  EXPECT_GT(a.state.guard.damped, 0.1 * a.state.guard.largest);
  EXPECT_LE(share_missing(a), 0.005);
}

// What still air takes is not known; what comes back out of nothing is.
TEST(EnergyGuard, FindsGainsAfterLossesToTheAir) {
  Scene scene = thrown({0, 0, -2});
  scene.has_air = true;
  scene.air_normal = 1;
  scene.step = 2e-5;
  Assembled a = assemble(scene);
  advance(a, 0.2);
  EXPECT_LE(share_missing(a), 0.002);
  const double kinetic = model::kinetic_energy(a.system, a.state);
  gain(a.state, 1.1);
  advance(a, 0.001);
  guard_look(a.system, a.motion, a.state);
  EXPECT_GT(a.state.guard.unaccounted, 0.9 * 0.21 * kinetic);
}

// A loss counts by the energy of its time, also where the cloth moves faster later; and up to the last step.
TEST(EnergyGuard, ForgetsNothing) {
  Scene scene = swinging();
  scene.step = 2e-5;
  Assembled a = assemble(scene);
  advance(a, 0.03);
  gain(a.state, 0.9);
  const std::int64_t at = a.state.steps;
  advance(a, 0.001);
  ASSERT_LT(a.state.guard.checked, a.state.steps);
  guard_look(a.system, a.motion, a.state);
  const double share = share_missing(a);
  EXPECT_GT(share, 0.01);
  EXPECT_GE(a.state.steps, at);
  const double size = a.state.guard.largest;
  advance(a, 0.2);
  EXPECT_GT(a.state.guard.largest, 2 * size);
  EXPECT_GE(share_missing(a), share);
}

TEST(EnergyGuard, WatchesAcrossChanges) {
  Scene scene = swinging();
  scene.step = 2e-5;
  Assembled a = assemble(scene);
  double planted = 0;
  for (int k = 0; k < 100; ++k) {
    change_begin(a.system, a.motion, a.state, Change::kFrequent);
    advance(a, 0.003);
    if (k == 50) {
      planted = model::kinetic_energy(a.system, a.state) * (1.05 * 1.05 - 1);
      EXPECT_LE(share_missing(a), 1e-3);
      gain(a.state, 1.05);
    }
    advance(a, 0.003);  // 300 steps in all
  }
  EXPECT_NEAR(a.state.guard.unaccounted, planted, 0.05 * planted);
}

TEST(EnergyGuard, RefinesTheStepAndStopsWhereThatDoesNotHelp) {
  Assembled a = assemble(swinging());
  bool told = false;
  Advance how = Advance::kDone;
  for (int interval = 0; how == Advance::kDone && interval < 1000; ++interval) {
    std::string event;
    how = leapfrog_advance(a.system, a.motion, a.state, a.system.communication, event, [&](double) {
      gain(a.state, 1.002);
      return false;
    });
    told = told || event.find("energy is missing") != std::string::npos;
  }
  EXPECT_EQ(how, Advance::kEnergyLost);
  EXPECT_EQ(a.state.guard.refinement, 16);
  EXPECT_TRUE(a.state.guard.failing);
  EXPECT_TRUE(told);
}

// A missing energy that smaller steps do not bring back costs no steps.
TEST(EnergyGuard, KeepsTheStepWhereSmallerOnesDoNotHelp) {
  Scene scene = swinging();
  scene.communication = 0.01;  // intervals long enough to be repeated
  Assembled a = assemble(scene);
  advance(a, 0.3);
  gain(a.state, std::sqrt(1 + 0.015 * a.state.guard.largest / model::kinetic_energy(a.system, a.state)));
  advance(a, 0.02);
  EXPECT_EQ(a.state.guard.refinement, 1);
  EXPECT_GT(share_missing(a), 0.01);
  const double h = a.state.h_old;
  advance(a, 0.02);
  EXPECT_GT(a.state.h_old, 0.9 * h);
}

// Ten times the allowed energy missing ends a run, also in intervals that are repeated in vain.
TEST(EnergyGuard, StopsWhereRepeatingDoesNotHelp) {
  Scene scene = swinging();
  scene.communication = 0.01;
  Assembled a = assemble(scene);
  Advance how = Advance::kDone;
  for (int interval = 0; how == Advance::kDone && interval < 200; ++interval) {
    std::string event;
    how = leapfrog_advance(a.system, a.motion, a.state, 0.01, event, [&](double) {
      gain(a.state, 1.01);
      return false;
    });
  }
  EXPECT_EQ(how, Advance::kEnergyLost);
}

// The step recovers once nothing goes missing any more.
TEST(EnergyGuard, GivesTheRefinementBack) {
  Assembled a = assemble(swinging());
  advance(a, 0.3);
  const double h = a.state.h_old;
  ASSERT_TRUE(guard_refine(a.state, guard_size(a.system, a.state), false));
  advance(a, 0.02);
  EXPECT_EQ(a.state.guard.refinement, 2);
  EXPECT_LT(a.state.h_old, 0.6 * h);
  for (int k = 0; k < 3000 && a.state.guard.refinement > 1; ++k) advance(a, 0.001);
  advance(a, 0.2);
  EXPECT_EQ(a.state.guard.refinement, 1);
  EXPECT_GT(a.state.h_old, 0.8 * h);
}

// The same, sooner, once the largest energy is four times that of the refinement.
TEST(EnergyGuard, GivesTheRefinementBackSoonerWhereEnergyHasGrown) {
  for (const double growth : {1.0, 5.0}) {
    Assembled a = assemble(swinging());
    advance(a, 0.3);
    ASSERT_TRUE(guard_refine(a.state, guard_size(a.system, a.state) / growth, false));
    for (const std::int64_t begun = a.state.steps; a.state.steps < begun + 2000;) advance(a, 0.001);
    EXPECT_EQ(a.state.guard.refinement, growth > 4 ? 1 : 2);
  }
}

// What a driven pin brings in is known, also of a clamp that turns.
TEST(EnergyGuard, KnowsTheWorkOfPins) {
  for (const bool turns : {false, true}) {
    Scene scene = swinging();
    scene.pins[0].clamp = true;
    scene.pins[0].drive = scene::Drive::kPosition;
    Assembled a = assemble(scene);
    Inputs& inputs = a.motion.inputs;
    for (int k = 1; k <= 100; ++k) {
      const double t = 0.002 * k;
      inputs.pin[0].position[2] = turns ? 0 : 0.01 * (1 - std::cos(60 * t));
      const double angle = turns ? 0.6 * std::sin(40 * t) : 0;
      inputs.pin[0].orientation = {std::cos(angle / 2), std::sin(angle / 2), 0, 0};
      advance(a, 0.002);
    }
    SCOPED_TRACE(turns);
    EXPECT_GT(std::abs(a.state.drive_work), 0.1 * a.state.guard.largest);
    EXPECT_LE(share_missing(a), 0.005);
  }
}

TEST(EnergyGuard, GivesTheSameBitsHoweverAMasterGroupsItsSteps) {
  for (const double communication : {0.001, 0.01}) {  // refined after an interval, and an interval repeated
    Scene scene = thrown({0, 0, -4});
    scene.communication = communication;
    Assembled a = assemble(scene), b = assemble(scene);
    for (Assembled* one : {&a, &b}) {
      advance(*one, communication);
      one->state.guard.balance -= 0.02 * one->state.guard.largest;  // a gain that makes the guard act
    }
    advance(a, 0.04);
    for (int k = 0; k < std::lround(0.04 / communication); ++k) advance(b, communication);
    SCOPED_TRACE(communication);
    EXPECT_GT(a.state.guard.refinements, 0);
    EXPECT_EQ((positions(a) - positions(b)).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ(a.state.guard.unaccounted, b.state.guard.unaccounted);
  }
}

}  // namespace
}  // namespace drape::dynamics
