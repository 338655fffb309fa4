// The energy balance: kinetic and potential energies grow by the input less the dissipation, to O(h^2).
// core/README.md, section 4.
#include <gtest/gtest.h>

#include <cmath>

#include "cloth_fixture.h"
#include "dynamics/potential_energy.h"
#include "outputs/outputs.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// A hanging swatch that swings in the wind, with every force that adds or removes energy.
Scene windy_scene() {
  Scene scene = reference::smooth_scene();
  scene.fabrics[0].damping = 2e-4;
  scene.damping = 1.5;
  scene.has_air = true;
  scene.air_normal = 1.2;
  scene.air_tangential = 0.3;
  scene.wind = {0.5, 3, 0.2};
  scene.energy = true;
  return scene;
}

drape_energy energy_after(const Scene& scene, double h, int steps) {
  Assembled a = assemble(scene);
  dynamics::energy_begin(a.system, a.state);
  for (int k = 0; k < steps; ++k) leapfrog_step(a.system, a.motion, a.state, h);
  outputs::Outputs o;
  outputs::outputs_make(o, a.scene, a.system);
  outputs::outputs_fill(o, a.system, a.motion, a.state, DRAPE_OUT_ENERGY);
  return o.c_view.energy;
}

// Halving the step divides the error by 4; the bound of 3.4 allows for the next order.
TEST(EnergyBalance, IsMetToSecondOrder) {
  const Scene scene = windy_scene();
  const drape_energy coarse = energy_after(scene, 4e-5, 2500), fine = energy_after(scene, 2e-5, 5000),
                     finest = energy_after(scene, 1e-5, 10000);
  std::printf("balance after 0.1 s: kinetic %.3e, dissipated %.3e, input %.3e, error %.2e %.2e %.2e J\n",
              finest.kinetic, finest.dissipated, finest.input, coarse.balance_error, fine.balance_error,
              finest.balance_error);
  EXPECT_GT(finest.dissipated, 1e-5);
  EXPECT_GT(finest.input, 1e-5);
  EXPECT_LE(std::abs(fine.balance_error), 1e-4 * finest.dissipated);
  EXPECT_GT(std::abs(coarse.balance_error / fine.balance_error), 3.4);
  EXPECT_GT(std::abs(fine.balance_error / finest.balance_error), 3.4);
}

// In free fall with -m c v the potential energy is linear, and the balance closes to rounding.
TEST(EnergyBalance, ClosesExactlyWhereForcesAreConstant) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.05, 0.03, 0.01);
  scene.damping = 3;
  scene.energy = true;
  const drape_energy e = energy_after(scene, 1e-4, 1000);
  const double m = 0.15 * 0.05 * 0.03;
  // The first kick spans h/2, and the state is read a half step after the last kick: m h^2 g a/8 at either
  // end.
  EXPECT_NEAR(e.balance_error, 0, m * 9.81 * 9.81 * 1e-8 / 4);
  // v = (g/c) (1 - exp(-c t)), and m c times the integral of its square to t = 0.1 s.
  const double c = 3, g = 9.81, t = 0.1, x = std::exp(-c * t);
  const double dissipated = m * g * g / c * (t - 2 * (1 - x) / c + (1 - x * x) / (2 * c));
  EXPECT_NEAR(e.dissipated, dissipated, 1e-6 * dissipated);  // (c h)^2 and (h/t)^2
}

}  // namespace
}  // namespace drape::dynamics
