// Cases of a whole cloth with known answers: the uniform strip, the bias strip, the catenary, the picture
// frame.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "cloth_fixture.h"
#include "dynamics/potential_energy.h"
#include "validation/load.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// Moves every node of the flat cloth to where the map (x, y) -> (X, Y) puts it.
template <class Map>
void deform(Assembled& a, Map map) {
  for (std::size_t n : a.system.particle) {
    const Vec2 to = map(a.state.x[n], a.state.y[n]);
    a.state.x[n] = to[0];
    a.state.y[n] = to[1];
  }
}

// The diagrams of the shipped wool, without the calibration on strips.
scene::FabricSpec measured_wool() {
  std::vector<Problem> problems;
  const Scene scene = validation::scene_load(DRAPE_SOURCE_DIR "/examples/hanging_wool/scene.toml", problems);
  EXPECT_TRUE(problems.empty());
  scene::FabricSpec wool = scene.fabrics[0];
  for (scene::DiagramSpec* d : {&wool.warp, &wool.weft, &wool.bias}) d->correction.clear();
  return wool;
}

// Prints the error of a case.
void print_error(const char* what, double error) { std::printf("%s: at most %.1e off\n", what, error); }

double elastic_energy(const Assembled& a) {
  const drape_energy e = dynamics::potential_energy(a.system, a.state);
  return e.stretch + e.shear + e.bending;
}

// A strip of width W. All yarns along the pull are strained by e, the others not. Across a cut of the strip
//     F = W [p(e) + sqrt(2) g(l/(sqrt(2) b) - 1) (1 + e) b/l],   l = b sqrt((1 + e)^2 + 1)
// for every b; at the diagram's own points p(e) = F_i/w_p.
TEST(UniformStrip, GivesTheInputCurveAndTheDiagonalsShareAtEveryCell) {
  const scene::FabricSpec wool = measured_wool();
  const double W = 0.05, H = 0.1;
  double worst = 0;
  for (double b : {0.0125, 0.00625, 0.003125}) {
    for (const bool warp : {true, false}) {
      const scene::DiagramSpec& diagram = warp ? wool.warp : wool.weft;
      for (std::size_t k = 1; k < diagram.force.size(); k += 3) {
        Scene scene = reference::rectangle(wool, warp ? W : H, warp ? H : W, b);
        scene.clamp_correction = false;
        Assembled a = assemble(scene);
        const double e = diagram.elongation[k], length = b * std::hypot(1 + e, 1);
        deform(a, [&](double x, double y) { return warp ? Vec2{x, (1 + e) * y} : Vec2{(1 + e) * x, y}; });
        const Eigen::VectorXd f = forces_by(kernel_pick(), a), r = positions(a);
        double pull = 0;
        for (Eigen::Index n = 0; n < r.size(); n += 3)
          if (r[n + warp] < (1 + e) * H / 2) pull += f[n + warp];
        const fabric::Law& law = a.system.lattices[0].law;
        const double share = std::numbers::sqrt2 *
                             math::curve_value(law.bias, length / (std::numbers::sqrt2 * b) - 1) * (1 + e) *
                             b / length;
        const double input = diagram.force[k] / wool.strip_width;
        // strains of 1e-4 of links at 0.1 m: 1e-17/1e-6; slopes up to 1e5 N/m
        const double error = std::abs(pull / W / (input + share) - 1);
        EXPECT_LE(error, 1e-9) << "b = " << b << ", point " << k;
        worst = std::max(worst, error);
      }
    }
  }
  print_error("case a, warp and weft", worst);
}

// A trellis of inextensible yarns along x and y, stretched by l1 along the rising diagonal and by l2 =
// sqrt(2 - l1^2) along the other: F45/w_p = dW/dl1, W the energy per area. Fourth-order differences over
// 1e-4 of smooth curves.
TEST(BiasStrip, GivesTheInputCurveAtEveryPoint) {
  const scene::FabricSpec wool = measured_wool();
  Scene scene = reference::rectangle(wool, 0.05, 0.05, 0.0125);
  scene.clamp_correction = false;
  const Assembled flat = assemble(scene);
  const auto energy = [&](double l1) {
    Assembled a = assemble(scene);
    const double l2 = std::sqrt(2 - l1 * l1);
    deform(a, [&](double x, double y) {
      const double s = l1 * (x + y) / 2, t = l2 * (y - x) / 2;
      return Vec2{s - t, s + t};
    });
    return elastic_energy(a) / (0.05 * 0.05);
  };
  double worst = 0;
  for (std::size_t k = 1; k < wool.bias.force.size(); ++k) {
    const double l1 = 1 + wool.bias.elongation[k], d = 1e-5;
    const double slope =
        (8 * (energy(l1 + d) - energy(l1 - d)) - (energy(l1 + 2 * d) - energy(l1 - 2 * d))) / (12 * d);
    const double error = std::abs(slope / (wool.bias.force[k] / wool.strip_width) - 1);
    EXPECT_LE(error, 1e-6) << "point " << k;
    worst = std::max(worst, error);
  }
  print_error("case a, 45 degrees", worst);
}

// A square of side L in a hinged frame of inextensible sides, half angle phi at the pulled corners: gamma =
// pi/2 - 2 phi, the corners are D = 2 L cos phi apart, and the force on them is dE/dD = L W'(gamma)/sin phi
// with W the energy per area. The left side comes from the kernel's nodal forces along dr/dD, the right side
// from the law's curve: W = G(e1) + G(e2), 1 + e1 = sqrt(2) cos phi, 1 + e2 = sqrt(2) sin phi.
TEST(PictureFrame, ForceIsTheShearEnergysSlope) {
  const double L = 0.06;
  Scene scene = reference::rectangle(reference::curved_fabric(), L, L, 0.01);
  double worst = 0;
  for (double phi : {0.75, 0.7, 0.65, 0.6}) {
    Assembled a = assemble(scene);
    std::vector<Vec2> rest;
    for (std::size_t n : a.system.particle) rest.push_back({a.state.x[n], a.state.y[n]});
    deform(a, [&](double x, double y) { return Vec2{(x + y) * std::cos(phi), (y - x) * std::sin(phi)}; });
    const Eigen::VectorXd f = forces_by(kernel_pick(), a);
    double force = 0;  // -f . dr/dD, dr/dD = (dr/dphi)/(-2 L sin phi)
    for (std::size_t k = 0; k < rest.size(); ++k) {
      const double u = rest[k][0] + rest[k][1], v = rest[k][1] - rest[k][0];
      const auto n = Eigen::Index(3 * k);
      force -= (f[n] * -u * std::sin(phi) + f[n + 1] * v * std::cos(phi)) / (-2 * L * std::sin(phi));
    }
    const math::Curve& g = a.system.lattices[0].law.bias;
    const double root2 = std::numbers::sqrt2, e1 = root2 * std::cos(phi) - 1, e2 = root2 * std::sin(phi) - 1;
    const double slope =  // dW/dgamma = -dW/dphi / 2
        -(math::curve_value(g, e1) * -root2 * std::sin(phi) +
          math::curve_value(g, e2) * root2 * std::cos(phi)) /
        2;
    const double error = std::abs(force / (L * slope / std::sin(phi)) - 1);
    EXPECT_LE(error, 1e-12) << phi;
    worst = std::max(worst, error);
  }
  print_error("case f", worst);
}

// Bias and bending are off, and the ends of every warp yarn are held. With H the horizontal pull, tan
// theta_{i+1} - tan theta_i = m g/H at node i. The motion is damped to rest: at c t = 80, e^-40 of the start
// remains.
TEST(Catenary, IsTheDiscreteChain) {
  scene::FabricSpec fabric = reference::threads(20);
  fabric.weft = reference::straight(20);
  Scene scene = reference::rectangle(fabric, 0.02, 0.2, 0.01);
  scene.damping = 20;
  scene.pins = {reference::pin_edges("ends", {0, 2})};
  Assembled a = assemble(scene);
  std::string event;
  ASSERT_EQ(leapfrog_advance(a.system, a.motion, a.state, 4.0, event), Advance::kDone);
  const model::Lattice& l = a.system.lattices[0];
  double worst = 0;
  for (int i = 0; i < l.columns; ++i) {
    const auto tangent = [&](int j) {
      const std::size_t p = l.node(i, j), q = l.node(i, j + 1);
      return (a.state.z[q] - a.state.z[p]) / (a.state.y[q] - a.state.y[p]);
    };
    const auto pull = [&](int j) {  // horizontal
      const std::size_t p = l.node(i, j), q = l.node(i, j + 1);
      const double dy = a.state.y[q] - a.state.y[p], length = std::hypot(dy, a.state.z[q] - a.state.z[p]);
      const double width = i == 0 || i + 1 == l.columns ? l.cell / 2 : l.cell;
      return width * math::curve_value(l.law.warp, length / l.cell - 1) * dy / length;
    };
    ASSERT_LT(tangent(0), -0.3);  // it does sag
    for (int j = 1; j + 1 < l.rows; ++j) {
      const double turn = a.system.mass[l.node(i, j)] * 9.81 / pull(j - 1);
      const double error = std::abs((tangent(j) - tangent(j - 1)) / turn - 1);
      EXPECT_LE(error, 1e-6);
      worst = std::max(worst, error);
    }
  }
  print_error("case d", worst);
}

}  // namespace
}  // namespace drape::dynamics
