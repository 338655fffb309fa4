// Links and cells of the cloth on sharp edges and tips of bodies, in motion. core/README.md, section 7.
#include "contact/edge/edge_contact.h"

#include <gtest/gtest.h>

#include "body_fixture.h"
#include "contact/particle/contact.h"
#include "contact/particle/contact_pass.h"
#include "math/vector3.h"
#include "seam_fixture.h"

namespace drape::contact {

using namespace tests;
namespace {

using namespace math::vector3;

constexpr double kPi = std::numbers::pi;

Scene over_roof(double side, double cell, double height, double angle, const SceneFolder& folder) {
  Scene scene = reference::rectangle(linen(), side, side, cell);
  scene.pieces[0].place.origin = {-side / 2 + 0.31 * cell, -side / 2 + 0.17 * cell, height};
  body_add(scene, folder, "roof", roof(angle));
  return scene;
}

// A cloth falls on a roof that turns and rocks. Over every advance, the momentum gained by the cloth is the
// weight's impulse less the impulse reported to the roof.
TEST(EdgeContact, MomentumIsBalancedOverEveryAdvance) {
  const SceneFolder folder;
  Scene scene = over_roof(0.1, 0.01, 0.002, 0.6, folder);
  scene.pieces[0].velocity = {0.1, 0, -1};
  scene.bodies[0].moves = true;
  Assembled a = assemble(scene);
  double worst = 0, largest = 0, mass = 0;
  for (std::size_t n : a.system.particle) mass += a.system.mass[n];
  Array v[3];
  for (Array& of : v) of.assign(a.system.nodes, 0.0);
  std::vector<math::Wrench> pins;
  const auto now = [&] {
    dynamics::leapfrog_synchronous(a.system, a.motion, a.state, {v[0].data(), v[1].data(), v[2].data()},
                                   pins);
    return momentum(a, v);
  };
  Vec3 before = now();
  std::size_t on_edges = 0;
  for (int k = 1; k <= 60; ++k) {
    math::RigidMotion& to = a.motion.inputs.body[0];
    to.position = {0, 0, 0.02 * std::sin(0.05 * k)};
    to.velocity = {0, 0, 0.02 * 50 * std::cos(0.05 * k)};
    to.angular_velocity = {0, 3, 0};
    to.orientation = math::rotation_exp({0, 3 * 1e-3 * k, 0});
    std::string event;  // every other advance restarts from the synchronous velocities, as with a tuning
    const auto anew = [&](double) {
      if (k % 2 == 0) dynamics::leapfrog_complete(a.system, a.motion, a.state);
      return k % 2 == 0;
    };
    ASSERT_EQ(dynamics::leapfrog_advance(a.system, a.motion, a.state, 1e-3, event, anew),
              dynamics::Advance::kDone);
    on_edges += a.motion.contact.edge_pairs.size();
    const Vec3 after = now(), gained = after - before;
    const Vec3 reported = a.state.body[0].impulse.force + a.motion.contact.load[0].force;
    worst = std::max(worst, norm(gained - (Vec3{0, 0, -9.81e-3 * mass} - reported)));
    largest = std::max(largest, norm(reported));
    before = after;
  }
  std::printf("momentum: off by %.3g of %.3g, touches on ridges %zu\n", worst, largest, on_edges);
  EXPECT_GT(on_edges, 100u);
  EXPECT_GT(largest, 1e-4 * mass);
  EXPECT_LT(worst, 1e-9 * largest);
}

// The height of the cloth's bilinear cells on the line x = y = 0 along z. Returns false if the line does not
// meet the cloth.
bool height_over_tip(const Assembled& a, double& height) {
  const model::Lattice& l = a.system.lattices[0];
  bool met = false;
  for (int j = 0; j + 1 < l.rows; ++j)
    for (int i = 0; i + 1 < l.columns; ++i) {
      const std::size_t c[4] = {l.node(i, j), l.node(i + 1, j), l.node(i, j + 1), l.node(i + 1, j + 1)};
      double u = 0.5, v = 0.5;
      const auto at = [&](const Array& r) {
        return (1 - u) * (1 - v) * r[c[0]] + u * (1 - v) * r[c[1]] + (1 - u) * v * r[c[2]] + u * v * r[c[3]];
      };
      for (int k = 0; k < 20; ++k) {
        const auto du = [&](const Array& r) {
          return (1 - v) * (r[c[1]] - r[c[0]]) + v * (r[c[3]] - r[c[2]]);
        };
        const auto dv = [&](const Array& r) {
          return (1 - u) * (r[c[2]] - r[c[0]]) + u * (r[c[3]] - r[c[1]]);
        };
        const double x = at(a.state.x), y = at(a.state.y), xu = du(a.state.x), xv = dv(a.state.x),
                     yu = du(a.state.y), yv = dv(a.state.y), det = xu * yv - xv * yu;
        u -= (yv * x - xv * y) / det;
        v -= (xu * y - yu * x) / det;
      }
      if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1 && std::hypot(at(a.state.x), at(a.state.y)) < 1e-9))
        continue;
      height = met ? std::min(height, at(a.state.z)) : at(a.state.z);
      met = true;
    }
  return met;
}

// A cloth is thrown at 50 m/s, with the automatic step, onto a pyramid whose tip is between its nodes, and
// onto a roof between its nodes.
TEST(EdgeContact, NoTipOrEdgeGetsThroughAtFiftyMetresPerSecond) {
  const SceneFolder folder;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angles(0.4, 1.25), shift(-0.005, 0.005);
  double nearest = INFINITY;
  for (int run = 0; run < 16; ++run)
    for (const bool tip : {true, false}) {
      const double mu = run % 2 ? 0.5 : 0, angle = run < 2 ? 1 : angles(random);
      Scene scene = over_roof(0.05, 0.01, 0.02, angle, folder);
      if (tip) scene.bodies.clear(), body_add(scene, folder, "pyramid", pyramid(angle));
      scene.fabrics[0].friction = {mu, mu};
      scene.pieces[0].place.origin[0] += shift(random);
      scene.pieces[0].place.origin[1] += shift(random);
      scene.pieces[0].velocity = {0, 0, -50};
      Assembled a = assemble(scene);
      double smallest = INFINITY;
      for (int k = 0; k < 100; ++k) {
        advance(a, 1e-4);
        if (tip) {
          double height = 0;
          if (height_over_tip(a, height)) smallest = std::min(smallest, height);
          continue;
        }
        const model::Lattice& l = a.system.lattices[0];
        for (int j = 0; j < l.rows; ++j)
          for (int i = 0; i + 1 < l.columns; ++i) {
            const std::size_t n = l.node(i, j);
            const double x = a.state.x[n], to = a.state.x[n + 1];
            if (!(x < 0 && to > 0)) continue;
            const double t = x / (x - to);
            smallest = std::min(smallest, (1 - t) * a.state.z[n] + t * a.state.z[n + 1]);
          }
      }
      EXPECT_GT(smallest, 0) << (tip ? "tip" : "ridge") << ", mu " << mu << ", angle " << angle;
      EXPECT_LT(smallest, 0.01);
      nearest = std::min(nearest, smallest);
    }
  std::printf("nearest %.3g m\n", nearest);
}

// At rest by its weight over a roof and over a pyramid: the residual of the fit, and the weight on the body.
TEST(EdgeContact, AClothRestsOnRoofAndTip) {
  const SceneFolder folder;
  for (const bool tip : {false, true}) {
    Scene scene = over_roof(0.1, 0.01, 0.0009, 0.55, folder);
    if (tip) scene.bodies.clear(), body_add(scene, folder, "pyramid", pyramid(0.72));
    scene.fabrics[0].friction = {0.8, 0.8};
    scene.mode = scene::Mode::kFit;
    Assembled a = assemble(scene);
    for (double t = 0; t < 20 && !a.state.relaxation.at_rest; t += 0.1) advance(a, 0.1);
    EXPECT_TRUE(a.state.relaxation.at_rest) << "residual " << a.state.relaxation.residual;
    expect_weight(a);
    EXPECT_FALSE(a.motion.contact.edge_pairs.empty());
  }
}

// The same bits for every kernel and grouping of advances.
TEST(EdgeContact, BitsAreThoseOfEveryKernelAndGrouping) {
  const SceneFolder folder;
  const Scene scene = over_roof(0.1, 0.01, 0.0009, 0.6, folder);
  const auto run = [&](const char* kernel, int advances) {
    Assembled a = assemble(scene);
    if (kernel) a.motion.kernel = dynamics::kernel_named(kernel);
    if (!a.motion.kernel) return Eigen::VectorXd();
    for (int k = 0; k < advances; ++k) advance(a, 0.06 / advances);
    EXPECT_TRUE(edge_any(a.state));
    return positions(a);
  };
  const Eigen::VectorXd whole = run("scalar", 1);
  if (whole.size() == 0) GTEST_SKIP() << "no kernel with fused arithmetic";
  for (const char* kernel : {"scalar", "avx2", "avx512"}) {
    const Eigen::VectorXd other = run(kernel, 6);
    if (other.size() == 0) continue;  // not on this processor
    EXPECT_EQ((other - whole).cwiseAbs().maxCoeff(), 0.0) << kernel;
  }
}

TEST(EdgeContact, StateGoesOnAsItWas) {
  const SceneFolder folder;
  Assembled a = assemble(over_roof(0.1, 0.01, 0.0009, 0.6, folder));
  advance(a, 0.03);
  ASSERT_TRUE(edge_any(a.state));
  expect_goes_on(a, 0.03);
}

// The balance closes with order 2 of the step while a cloth comes to lie over a roof.
TEST(EdgeContact, EnergyIsBalanced) {
  const SceneFolder folder;
  std::vector<double> errors;
  for (const double step : {2e-5, 1e-5}) {
    Scene scene = over_roof(0.05, 0.01, 0.0006, 0.4, folder);
    scene.energy = true;
    scene.step = step;
    scene.pieces[0].velocity = {0, 0, -0.1};
    Assembled a = assemble(scene);
    const drape_energy e = energies_after(a, 0.02);
    EXPECT_GT(e.dissipated, 0);
    EXPECT_GT(e.contact, 0);
    errors.push_back(std::abs(e.balance_error) / (e.kinetic + e.dissipated));
    std::printf("energy: balance off by %.3g of %.3g J\n", e.balance_error, e.kinetic + e.dissipated);
  }
  EXPECT_LT(errors[0], 1e-4);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.7);
}

// A sheet folded along y at x = z = 0, which falls to both sides by 45 degrees.
Mesh fold() {
  Mesh m = roof(kPi / 4);
  m.corner.resize(4);
  return m;
}

// A strip of `links` links along x, one cell wide, at a height over the fold; nothing weighs.
Scene over_fold(const SceneFolder& folder, int links, double left, double height) {
  scene::FabricSpec fabric = linen();
  fabric.bending_warp = fabric.bending_weft = 0;
  Scene scene = reference::rectangle(fabric, links * 0.01, 0.01, 0.01);
  scene.gravity = {0, 0, 0};
  scene.damping = 200;
  scene.communication = 1e-5;  // of one step
  scene.pieces[0].place.origin = {left, -0.0043, height};
  body_add(scene, folder, "fold", fold());
  return scene;
}

// The height over the fold of the links that cross it.
double over_fold_height(const Assembled& a) {
  const model::Lattice& l = a.system.lattices[0];
  const std::size_t n = l.node(0, 0), m = l.node(1, 0);
  const double t = a.state.x[n] / (a.state.x[n] - a.state.x[m]);
  return (1 - t) * a.state.z[n] + t * a.state.z[m];
}

// A link lies 1.3 contact distances over a fold, with one end beyond it by 0.3 of the length. In a single
// step that end jumps down by 5 contact distances, because a pin moves it there or because it is welded to a
// point that a pin holds there. The link then moves by 1.5 contact distances, past the fold. Either the link
// is stopped in that step, or its side was recorded before the step and the contact pushes it out again. In
// a sheet only such links can do this.
TEST(EdgeContact, AJumpMovesNoLinkThroughUndetected) {
  const SceneFolder folder;
  const double contact_distance = 0.0005;
  for (const bool weld : {false, true}) {
    Scene scene = over_fold(folder, weld ? 1 : 2, weld ? -0.003 : -0.007, 1.3 * contact_distance);
    scene.step = scene.communication;
    if (weld) {
      scene.pieces.push_back(scene.pieces[0]);
      scene.pieces[1].name = "right";
      scene.pieces[1].place.origin = {0.007, -0.0043, -3.7 * contact_distance};
      scene.seams = {seam_join()};
      scene.seams[0].gap_tolerance = 6 * contact_distance;
      scene.pins = {{"held", 1, {}, {3}}};
    } else {
      scene.pins = {reference::pin_edges("left", {3}), reference::pin_edges("right", {1})};
      scene.pins[0].drive = scene::Drive::kPosition;
    }
    Assembled a = assemble(scene);
    if (!weld) {
      sewn_advance(a, 1e-3);
      a.motion.inputs.pin[0].position[2] -= 5 * contact_distance;
    }
    const std::int64_t steps = a.state.steps;
    sewn_advance(a, 1e-5);
    EXPECT_EQ(a.state.steps, steps + 1);
    EXPECT_LT(over_fold_height(a), weld ? 0 : 0.1 * contact_distance);
    sewn_advance(a, 0.05);
    EXPECT_GT(over_fold_height(a), 0.1 * contact_distance) << (weld ? "weld" : "pin");
  }
}

// The penalties of pairs add this to omega^2: with k the stiffness of a pair, each row of M^-1/2 W k W^T
// M^-1/2 sums to at most (|W_k|/S) W^2/2, S = sum |W_j|. The link lies over a sharp edge whose closest point
// slides from half a link before its beginning to half a link beyond its end: the weights go from -1/2 to
// 3/2.
TEST(EdgeContact, PenaltyStaysWithinTheBoundOfTheStep) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(0.01), 0.01, 0.01, 0.01);
  scene.pieces[0].place.origin = {0.1, 0, 0.1};
  body_add(scene, folder, "knife", roof(1.3));
  Assembled a = assemble(scene);
  const model::Lattice& l = a.system.lattices[0];
  const double sum = l.contact_law.omega2 / 2;
  double lowest = INFINITY, highest = -INFINITY, largest = 0;
  std::vector<EdgeContactPair> touches;
  for (int at = 0; at < 450; ++at) {
    const double foot = -0.62 + 0.005 * at, tilt = foot < 0.5 ? -1.15 : 1.15;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {  // a plane tilted about y, 0.6 contact distances over the edge
        const double along = (i - foot) * 0.01, up = 0.6 * l.contact_law.distance;
        const std::size_t n = l.node(i, j);
        a.state.x[n] = along * std::cos(tilt) + up * std::sin(tilt);
        a.state.z[n] = -along * std::sin(tilt) + up * std::cos(tilt);
        a.state.y[n] = 0.01 * j;
      }
    begin(a.system, a.motion.kernel->contact, a.motion.contact, a.state);
    edge_store_velocities(a.system, a.state, touches);
    for (const EdgeContactPair& t : touches) {
      ASSERT_EQ(t.element->weights(), 2);
      const double *w = t.gap.weight, spread = std::abs(w[0]) + std::abs(w[1]);
      const double m[2] = {a.system.mass[t.element->node[0]], a.system.mass[t.element->node[1]]};
      EXPECT_NEAR(w[0] + w[1], 1, 1e-12);
      lowest = std::min(lowest, w[1]), highest = std::max(highest, w[1]);
      for (int k = 0; k < 2; ++k) {
        double row = 0;
        for (int j = 0; j < 2; ++j) row += t.stiffness * std::abs(w[k] * w[j]) / std::sqrt(m[k] * m[j]);
        EXPECT_LE(row, std::abs(w[k]) / spread * sum * (1 + 1e-12)) << "foot " << foot;
        largest = std::max(largest, row / sum);
      }
    }
  }
  std::printf("feet from %.2f to %.2f, rows up to %.3f of W^2/2\n", lowest, highest, largest);
  EXPECT_LT(lowest, -0.4);
  EXPECT_GT(highest, 1.4);
  EXPECT_GT(largest, 0.99);
}

// A body without sharp edges has no features, and the cloth no pairs with them.
TEST(EdgeContact, ASmoothBodyCostsNothing) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01);
  scene.pieces[0].place.origin = {-0.05, -0.05, 0.0507};
  body_add(scene, folder, "ball", ball(0.05, 100));
  Assembled a = assemble(scene);
  advance(a, 0.01);
  EXPECT_TRUE(a.system.bodies[0].sharp.feature.empty());
  EXPECT_TRUE(a.system.edge_elements.element.empty());
  EXPECT_TRUE(a.state.body[0].edges.near.empty());
  EXPECT_TRUE(any_near(a.state));
}

// Links that start through a sharp edge, or too deep within its contact distance, give one fault.
TEST(EdgeContact, AStartThroughItIsOneFault) {
  const SceneFolder folder;
  for (const double height : {-0.0005, 0.00003, 0.0002}) {
    Scene scene = over_roof(0.05, 0.01, height, 0.5, folder);
    Assembled a = assemble(scene);
    std::vector<Problem> problems;
    check_start(a.system, a.scene, a.motion.contact, a.state, problems);
    if (height > 0.0001) {
      EXPECT_TRUE(problems.empty());
      continue;
    }
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(scene::problem_text(problems[0]).find("puts 6 links or cells through sharp edges"),
              std::string::npos)
        << scene::problem_text(problems[0]);
  }
}

}  // namespace
}  // namespace drape::contact
