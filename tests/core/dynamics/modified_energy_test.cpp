// The energy that leapfrog keeps, and the paper's scheme with it.
#include "dynamics/modified_energy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cloth_fixture.h"
#include "dynamics/constraint_projection.h"
#include "dynamics/energy_guard.h"
#include "model/kinetic_energy.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// Cloth that hangs from an edge and is thrown. The step is given, as a share of its limit at the start.
Scene thrown(scene::Integrator integrator, double share) {
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01);
  scene.integrator = integrator;
  scene.gravity = {0, 3, -9.81};
  scene.pins = {{"pin", 0, {}, {0}}};
  scene.pieces[0].velocity = {0.3, -0.5, 0.3};
  scene.step = share * step_limit_of(assemble(scene).system, assemble(scene).state.omega2);
  scene.communication = 16 * scene.step;
  return scene;
}

struct Range {
  double least = INFINITY, largest = -INFINITY;
  void add(double value) { least = std::min(least, value), largest = std::max(largest, value); }
  double width() const { return largest - least; }
};

// How far H and T + U move in some hundred steps.
struct Moved {
  Range modified, plain;
};
Moved moved(scene::Integrator integrator, double share) {
  Assembled a = assemble(thrown(integrator, share));
  const double h = a.system.step_given;
  Moved ranges;
  for (int k = 0; k < 40; ++k) {
    advance(a, a.system.communication);
    const ModifiedEnergy e = modified_energy(a.system, a.motion, a.state, h);
    ranges.modified.add(e.h_less_work);
    ranges.plain.add(energy_sum(e.energy));
  }
  return ranges;
}

TEST(ModifiedEnergy, IsKeptWhereTPlusURipples) {
  for (const auto integrator : {scene::Integrator::kLeapfrog, scene::Integrator::kPaper}) {
    SCOPED_TRACE(integrator == scene::Integrator::kPaper);
    const Moved coarse = moved(integrator, 0.3), fine = moved(integrator, 0.15);
    EXPECT_LE(coarse.modified.width(), 0.05 * coarse.plain.width());
    EXPECT_LE(fine.modified.width(), 0.15 * coarse.modified.width());  // by h^4: a sixteenth
    // T + U ripples by h^2; in the paper's scheme by h.
    const double order = std::log2(coarse.plain.width() / fine.plain.width());
    EXPECT_NEAR(order, integrator == scene::Integrator::kPaper ? 1 : 2, 0.2);
  }
}

// V_0 of the paper's scheme is v_{-1/2} of leapfrog, which starts at v_0 = V_0 + h a_0/2.
TEST(ModifiedEnergy, OfThePapersSchemeIsThatOfLeapfrog) {
  Assembled paper = assemble(thrown(scene::Integrator::kPaper, 0.3));
  Assembled leapfrog = assemble(thrown(scene::Integrator::kLeapfrog, 0.3));
  const double h = paper.system.step_given;
  crumple(paper, 1e-4, 2), crumple(leapfrog, 1e-4, 2);
  free_accelerations(leapfrog.system, leapfrog.motion, leapfrog.state);
  constraints_project(leapfrog.system, leapfrog.motion.constraints, leapfrog.motion.held,
                      motion_field(leapfrog.motion), nullptr);
  State& s = leapfrog.state;
  for (std::size_t n : leapfrog.system.particle) {
    s.vx[n] += h / 2 * leapfrog.motion.now_x[n];
    s.vy[n] += h / 2 * leapfrog.motion.now_y[n];
    s.vz[n] += h / 2 * leapfrog.motion.now_z[n];
  }
  for (int k = 0; k < 20; ++k) {
    advance(paper, paper.system.communication), advance(leapfrog, leapfrog.system.communication);
    const double expected = modified_energy(leapfrog.system, leapfrog.motion, s, h).h_less_work;
    EXPECT_NEAR(modified_energy(paper.system, paper.motion, paper.state, h).h_less_work, expected,
                1e-12 * paper.state.guard.largest);
  }
}

double share_missing(const Assembled& a) { return std::abs(a.state.guard.worst) / a.state.guard.worst_size; }

// Every other interval is longer, so the step changes with each; the pin goes back and forth and jolts the
// cloth.
TEST(EnergyGuard, WatchesThePapersScheme) {
  for (const double damping : {0.0, 20.0, 200.0})
    for (const double jolt : {0.0, 0.02})
      for (const double ratio : {1.0, 1.03}) {
        Scene scene = thrown(scene::Integrator::kPaper, 0.3);
        scene.damping = damping;
        scene.pins[0].drive = scene::Drive::kPosition;
        Assembled a = assemble(scene);
        const auto length = [&](int k) { return (k % 2 ? 1 : ratio) * scene.communication; };
        for (int k = 0; k < 400; ++k) {
          if (k % 50 == 0) a.motion.inputs.pin[0].position[2] = k % 100 == 0 ? 0 : jolt;
          advance(a, length(k));
          ASSERT_TRUE(a.state.guard.begun);
        }
        SCOPED_TRACE(testing::Message() << damping << "/s, " << jolt << " m, " << ratio);
        EXPECT_LE(share_missing(a), 0.005);
        if (damping > 50) continue;  // an interval takes a fifth of what is planted
        const double kinetic = model::kinetic_energy(a.system, a.state), missing = a.state.guard.unaccounted;
        for (Array* v : {&a.state.vx, &a.state.vy, &a.state.vz})
          for (double& one : *v) one *= 1.1;
        advance(a, length(0));
        guard_look(a.system, a.motion, a.state);
        EXPECT_NEAR(a.state.guard.unaccounted - missing, 0.21 * kinetic, 0.05 * kinetic);
      }
}

TEST(EnergyGuard, KnowsWhatThePapersDampingTakes) {
  for (const double damping : {20.0, 200.0}) {
    Scene scene = thrown(scene::Integrator::kPaper, 0.3);
    scene.damping = damping;
    Assembled a = assemble(scene);
    for (int k = 0; k < 400; ++k) advance(a, scene.communication);
    SCOPED_TRACE(damping);
    EXPECT_GT(a.state.guard.damped, 0.1 * a.state.guard.largest);
    EXPECT_NEAR(a.state.guard.unaccounted, 0, 0.01 * a.state.guard.damped);
  }
}

}  // namespace
}  // namespace drape::dynamics
