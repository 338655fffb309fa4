// The energy guard: core/README.md, section 4, "Energy guard".
#include "dynamics/energy_guard.h"

#include <gtest/gtest.h>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "forces/hinge_energy.h"
#include "forces/irregular_elements.h"
#include "model/elements.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {

using namespace tests;
namespace {

Vec3 edge(const State& s, std::size_t from, std::size_t to) {
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}

// Link by link and hinge by hinge.
drape_energy energy_by_elements(const System& system, const State& s) {
  drape_energy e{};
  const model::Lattice& l = system.lattices[0];
  model::links_visit(system, l, [&](const model::Link& link) {
    (link.along == model::YarnDirection::kBias ? e.shear : e.stretch) +=
        link.width * link.rest *
        math::curve_energy(model::law_curve(l.law, link.along), model::link_strain(s, link));
  });
  model::hinges_visit(system, l,
                      [&](std::size_t n0, std::size_t n1, std::size_t n2, bool warp, double share) {
                        e.bending += model::law_bending(l.law, warp) * share *
                                     forces::hinge_energy_between(edge(s, n0, n1), edge(s, n1, n2));
                      });
  return e;
}

// Crumpled by up to 8 mm on cells of 10 mm, some hinges fold by more than 120 degrees.
TEST(PotentialEnergy, OfARowIsTheSumOverItsElements) {
  for (const Shape shape : {Shape::kRectangle, Shape::kTriangle, Shape::kDiscWithHole, Shape::kSlits})
    for (const double amplitude : {1e-5, 2e-3, 8e-3}) {
      Assembled a = assemble(cut_piece(reference::curved_fabric(), shape));
      crumple(a, amplitude, 3);
      const drape_energy expected = energy_by_elements(a.system, a.state);
      for (const char* name : {"portable", "scalar", "avx2", "avx512"}) {
        const Kernel* kernel = kernel_named(name);
        if (!kernel) continue;
        SCOPED_TRACE(std::string(shape_name(shape)) + " " + name);
        const drape_energy e = potential_energy(a.system, *kernel, a.state);
        // strains of 1e-3 round to 1e-16
        EXPECT_NEAR(e.stretch, expected.stretch, 1e-12 * expected.stretch);
        EXPECT_NEAR(e.shear, expected.shear, 1e-12 * expected.shear);
        EXPECT_NEAR(e.bending, expected.bending, 1e-12 * expected.bending);
      }
    }
}

TEST(PotentialEnergy, HasTheSameBitsInAllVectorLanes) {
  if (!kernel_named("scalar")) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  Assembled a = assemble(cut_piece(reference::curved_fabric(), Shape::kDiscWithHole));
  crumple(a, 2e-3, 5);
  const drape_energy expected = potential_energy(a.system, *kernel_named("scalar"), a.state);
  for (const char* name : {"avx2", "avx512"}) {
    const Kernel* kernel = kernel_named(name);
    if (!kernel) continue;
    const drape_energy e = potential_energy(a.system, *kernel, a.state);
    EXPECT_EQ(energy_sum(e), energy_sum(expected)) << name;
  }
}

// Cloth with straight laws, that hangs from an edge and swings without damping.
Scene swinging() {
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01);
  scene.gravity = {0, 3, -9.81};
  scene.pins = {{"pin", 0, {}, {0}}};
  return scene;
}

double share_missing(const Assembled& a) { return std::abs(a.state.guard.worst) / a.state.guard.largest; }

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
}

// The step recovers once nothing goes missing any more.
TEST(EnergyGuard, GivesTheRefinementBack) {
  Assembled a = assemble(swinging());
  advance(a, 0.3);
  const double h = a.state.h_old;
  ASSERT_TRUE(guard_refine(a.system, a.state, false));
  advance(a, 0.02);
  EXPECT_EQ(a.state.guard.refinement, 2);
  EXPECT_LT(a.state.h_old, 0.6 * h);
  for (int k = 0; k < 3000 && a.state.guard.refinement > 1; ++k) advance(a, 0.001);
  advance(a, 0.2);
  EXPECT_EQ(a.state.guard.refinement, 1);
  EXPECT_GT(a.state.h_old, 0.8 * h);
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
  Assembled a = assemble(swinging()), b = assemble(swinging());
  gain(a.state, 1.0);
  for (Assembled* one : {&a, &b})
    for (double& v : one->state.vz) v = -4;  // hard enough that the guard acts
  advance(a, 0.04);
  for (int k = 0; k < 40; ++k) advance(b, 0.001);
  EXPECT_EQ((positions(a) - positions(b)).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(a.state.guard.unaccounted, b.state.guard.unaccounted);
}

}  // namespace
}  // namespace drape::dynamics
