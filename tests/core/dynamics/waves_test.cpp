// Frequencies of the lattice in the kernel's own motion: the stretched net, and plane waves in the cloth.
// Leapfrog moves a mode of frequency w with sin(w_d h/2) = w h/2, so w = w_d [1 - (w_d h)^2/24 + O((w_d
// h)^4/1920)].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth_fixture.h"

namespace drape::dynamics {

using namespace tests;
namespace {

constexpr double kPi = std::numbers::pi;

// The frequency of a signal cos(w_d k h) from sums over it, cos(w_d h) = sum s_k (s_{k-1} + s_{k+1})/(2 sum
// s_k^2), corrected to w.
double frequency_of(const std::vector<double>& s, double h) {
  double top = 0, bottom = 0;
  for (std::size_t k = 1; k + 1 < s.size(); ++k)
    top += s[k] * (s[k - 1] + s[k + 1]), bottom += 2 * s[k] * s[k];
  const double discrete = std::acos(top / bottom) / h;
  return discrete * (1 - std::pow(discrete * h, 2) / 24);
}

scene::FabricSpec linear(double warp, double weft, double bias, double bending) {
  scene::FabricSpec f = reference::threads(warp);
  f.weft = reference::straight(weft);
  if (bias > 0) f.bias = reference::diagram({0, 0.1}, {0, 0.1 * bias * 0.05});
  f.bending_warp = f.bending_weft = bending;
  return f;
}

// Case g: a square net, its rim held, both threads strained by e: T = p(e)/(1 + e) per width and
//     w^2 = 4 T/(rho b^2) [sin^2(m pi/2N) + sin^2(n pi/2N)] + 16 B/(rho b^2 l^2) [sin^4 + sin^4],
//     l = b (1 + e).
TEST(StretchedNet, SwingsAtItsFrequencies) {
  const int n = 12;
  const double b = 0.01, rho = 0.15, k = 80, e = 0.04, amplitude = 1e-7;
  for (const double bending : {0.0, 3e-6})
    for (const auto& [p, q] : {std::pair{1, 1}, {2, 1}, {3, 5}, {11, 11}}) {
      Scene scene = reference::rectangle(linear(k, k, 0, bending), n * b, n * b, b);
      scene.gravity = {0, 0, 0};
      Assembled a = assemble(scene);
      const model::Lattice& l = a.system.lattices[0];
      const auto shape = [&](int i, int j) { return std::sin(p * kPi * i / n) * std::sin(q * kPi * j / n); };
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
          const std::size_t at = l.node(i, j);
          a.state.x[at] *= 1 + e;
          a.state.y[at] *= 1 + e;
          a.state.z[at] = amplitude * shape(i, j);
          if (i == 0 || j == 0 || i == n || j == n) a.system.inverse_mass[at] = 0;
        }
      const double s1 = std::pow(std::sin(p * kPi / (2 * n)), 2),
                   s2 = std::pow(std::sin(q * kPi / (2 * n)), 2);
      const double w =
          std::sqrt(4 * k * e / (1 + e) / (rho * b * b) * (s1 + s2) +
                    16 * bending / (rho * std::pow(b, 4) * std::pow(1 + e, 2)) * (s1 * s1 + s2 * s2));
      const double h = std::min(
          0.2 / w, 0.4 * step_limit_of(a.system, step_limit_omega2(a.system, *a.motion.kernel, a.state)));
      std::vector<double> swing;
      for (int step = 0; step < int(40 / (w * h)); ++step) {
        double sum = 0;
        for (int j = 0; j <= n; ++j)
          for (int i = 0; i <= n; ++i) sum += shape(i, j) * a.state.z[l.node(i, j)];
        swing.push_back(sum);
        leapfrog_step(a.system, a.motion, a.state, h);
      }
      const double found = frequency_of(swing, h);
      EXPECT_NEAR(found, w, 1e-4 * w) << p << " " << q << " bending " << bending;
      std::printf("net, mode %d %d, B %.0e: frequency off by %.1e\n", p, q, bending, found / w - 1);
    }
}

// Case g': in-plane waves of phase (kx, ky) per cell, m = rho b^2, k_d = g'/2:
//     m D_xx = 4 k_weft sin^2(kx/2) + 2 k_d (1 - cos kx cos ky),  m D_yy likewise,
//     m D_xy = 2 k_d sin kx sin ky.
// After k steps the middle node depends only on k cells around it: it moves as in cloth without a rim.
TEST(PlaneWave, RunsAtItsFrequency) {
  const double b = 0.01, rho = 0.15, warp = 300, weft = 120, bias = 60, amplitude = 1e-9;
  const int steps = 40, n = 2 * steps + 4;
  for (const auto& [kx, ky] : {std::pair{0.3, 0.2}, {1.1, 0.0}, {0.7, -1.3}, {kPi, 0.0}, {2.5, 2.0}})
    for (const int branch : {0, 1}) {
      Scene scene = reference::rectangle(linear(warp, weft, bias, 0), n * b, n * b, b);
      scene.gravity = {0, 0, 0};
      scene.bias_model = scene::BiasModel::kPaper;
      scene.clamp_correction = false;
      Assembled a = assemble(scene);
      const double kd = bias / 2, m = rho * b * b;
      Eigen::Matrix2d d;
      d(0, 0) = 4 * weft * std::pow(std::sin(kx / 2), 2) + 2 * kd * (1 - std::cos(kx) * std::cos(ky));
      d(1, 1) = 4 * warp * std::pow(std::sin(ky / 2), 2) + 2 * kd * (1 - std::cos(kx) * std::cos(ky));
      d(0, 1) = d(1, 0) = 2 * kd * std::sin(kx) * std::sin(ky);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes(d / m);
      const double w = std::sqrt(modes.eigenvalues()[branch]);
      const Eigen::Vector2d way = modes.eigenvectors().col(branch);
      const model::Lattice& l = a.system.lattices[0];
      const int half = n / 2;
      const std::size_t middle = l.node(half, half);
      const double x0 = a.state.x[middle], y0 = a.state.y[middle];
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
          const double u = amplitude * std::cos(kx * (i - half) + ky * (j - half));
          a.state.x[l.node(i, j)] += u * way[0];
          a.state.y[l.node(i, j)] += u * way[1];
        }
      const double h = std::min(0.45 * 2 / std::sqrt(a.state.omega2), 0.6 / w);
      std::vector<double> wave;
      for (int step = 0; step <= steps; ++step) {
        wave.push_back((a.state.x[middle] - x0) * way[0] + (a.state.y[middle] - y0) * way[1]);
        leapfrog_step(a.system, a.motion, a.state, h);
      }
      const double found = frequency_of(wave, h);
      std::printf("wave %.1f %.1f, branch %d: h w = %.3f, frequency off by %.1e\n", kx, ky, branch, h * w,
                  found / w - 1);
      EXPECT_NEAR(found, w, 1e-4 * w);
    }
}

}  // namespace
}  // namespace drape::dynamics
