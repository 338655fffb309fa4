// An assembled scene, with all that a test needs.
#pragma once
#include <gtest/gtest.h>

#include <random>

#include "assembly/assemble.h"
#include "dynamics/advance.h"
#include "dynamics/potential_energy.h"
#include "dynamics/step_size/step_limit.h"
#include "outputs/outputs.h"
#include "reference/test_cloth.h"

namespace drape::tests {

struct Assembled {
  Scene scene;
  System system;
  State state;
  dynamics::Motion motion;
};

inline scene::FabricSpec linen(double thickness = 1e-3) {
  scene::FabricSpec fabric;
  fabric.name = "linen";
  fabric.areal_density = 0.2;
  fabric.thickness = thickness;
  fabric.warp = reference::straight(2000);
  fabric.weft = reference::straight(2000);
  fabric.bias = reference::diagram({0, 0.05, 0.1, 0.15}, {0, 1, 2, 3});
  fabric.bending_warp = fabric.bending_weft = 1e-5;
  return fabric;
}

inline Assembled assemble(const Scene& scene) {
  Assembled a;
  a.scene = scene;
  std::vector<Problem> problems;
  a.system = assembly::system_assemble(scene, a.state, problems);
  if (!problems.empty()) throw std::runtime_error(scene::problem_text(problems[0]));
  a.motion = dynamics::motion_make(a.system);
  dynamics::leapfrog_begin(a.system, a.motion, a.state);
  return a;
}

inline void advance(Assembled& a, double length) {
  std::string event;
  ASSERT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, length, event), dynamics::Advance::kDone);
}

// Moves every particle by up to `amplitude` (m) along each axis, in the reference's order.
inline void crumple(Assembled& a, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amplitude, amplitude);
  for (std::size_t n : a.system.particle)
    for (Array* r : {&a.state.x, &a.state.y, &a.state.z}) (*r)[n] += shift(random);
}

// A nodal field as one vector [3 x particles], in the reference's order.
inline Eigen::VectorXd gathered(const System& system, const Array& x, const Array& y, const Array& z) {
  Eigen::VectorXd v(Eigen::Index(3 * system.particle.size()));
  Eigen::Index k = 0;
  for (std::size_t n : system.particle) {
    v[k++] = x[n];
    v[k++] = y[n];
    v[k++] = z[n];
  }
  return v;
}

inline Eigen::VectorXd positions(const Assembled& a) {
  return gathered(a.system, a.state.x, a.state.y, a.state.z);
}

// A restored state continues with the same bits.
inline void expect_goes_on(Assembled& a, double length) {
  const State kept = a.state;
  advance(a, length);
  const Eigen::VectorXd first = positions(a);
  a.state = kept;
  advance(a, length);
  EXPECT_EQ((positions(a) - first).cwiseAbs().maxCoeff(), 0.0);
}

// The energies after `length` (s) from the start.
inline drape_energy energies_after(Assembled& a, double length) {
  dynamics::energy_begin(a.system, a.state);
  advance(a, length);
  outputs::Outputs outputs;
  outputs::outputs_make(outputs, a.scene, a.system);
  outputs::outputs_fill(outputs, a.system, a.motion, a.state, DRAPE_OUT_ENERGY);
  return outputs.c_view.energy;
}

inline Eigen::VectorXd forces_by(const dynamics::Kernel& kernel, Assembled& a) {
  Array fx(a.system.nodes), fy(a.system.nodes), fz(a.system.nodes);
  dynamics::kernel_forces(kernel, a.system, a.state, a.motion.workspace, {fx.data(), fy.data(), fz.data()});
  return gathered(a.system, fx, fy, fz);
}

// F = -dE/dr for every particle, by central differences at `eps` (m).
template <class Energy>
void expect_minus_gradient(Assembled& a, const Eigen::VectorXd& force, const Energy& energy, double eps) {
  const double scale = force.lpNorm<Eigen::Infinity>();
  Eigen::Index k = 0;
  for (std::size_t n : a.system.particle)
    for (Array* r : {&a.state.x, &a.state.y, &a.state.z}) {
      const double at = (*r)[n];
      (*r)[n] = at + eps;
      const double above = energy();
      (*r)[n] = at - eps;
      const double below = energy();
      (*r)[n] = at;
      EXPECT_NEAR(force[k++], -(above - below) / (2 * eps), 1e-6 * scale);
    }
}

}  // namespace drape::tests
