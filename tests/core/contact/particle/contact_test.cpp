// Contact in motion: cases h and h' of the model, momentum, and what must never happen.
#include "contact/particle/contact.h"

#include <gtest/gtest.h>

#include <random>

#include "body_fixture.h"
#include "contact/particle/contact_pass.h"
#include "dynamics/potential_energy.h"
#include "math/vector3.h"
#include "outputs/outputs.h"
#include "reference/run.h"

namespace drape::contact {

using namespace tests;
namespace {

using namespace math::vector3;

// The depth e at which the penalty balances the acceleration g: omega^2 phi(e) = g.
double depth_under(const model::ContactLaw& law, double g) {
  const double blend = kContactBlend * law.distance;
  double low = 0, high = law.distance;
  for (int k = 0; k < 200; ++k) {
    const double e = (low + high) / 2, t = std::min(e / blend, 1.0);
    const double phi = blend * t * t * t * (1 - t / 2) + std::max(e - blend, 0.0);
    (law.omega2 * phi < g ? low : high) = e;
  }
  return low;
}

// A square at rest on a table by its penalty. Gravity is inclined by the angle.
Assembled on_incline(const SceneFolder& folder, double mu, double angle) {
  Scene scene = reference::rectangle(linen(), 0.05, 0.05, 0.01);
  scene.fabrics[0].friction = {mu, mu};
  scene.gravity = {9.81 * std::sin(angle), 0, -9.81 * std::cos(angle)};
  scene.pieces[0].place.origin = {-0.5, 0, 0.0005};
  body_add(scene, folder, "table", box(2, 2, 0.1)).position = {0, 0, -0.05};
  State state;
  std::vector<Problem> problems;
  const System system = assembly::system_assemble(scene, state, problems);
  scene.pieces[0].place.origin[2] -= depth_under(system.lattices[0].contact_law, 9.81 * std::cos(angle));
  return assemble(scene);
}

// Case h: the cloth sticks iff tan a <= mu.
TEST(Contact, SticksOnAnInclineUpToTheCoefficient) {
  const SceneFolder folder;
  const double mu = 0.4;
  Assembled below = on_incline(folder, mu, std::atan(0.999 * mu)),
            above = on_incline(folder, mu, std::atan(1.001 * mu));
  const Eigen::VectorXd start = positions(below);
  advance(below, 0.5);
  advance(above, 0.5);
  EXPECT_LT((positions(below) - start).cwiseAbs().maxCoeff(), 1e-9);
  const double a = std::atan(1.001 * mu), way = 9.81 * (std::sin(a) - mu * std::cos(a)) * 0.125;
  EXPECT_GT((positions(above) - start).maxCoeff(), 0.9 * way);
}

// Case h: x = g (sin a - mu cos a) t^2/2.
TEST(Contact, SlidesDownAnIncline) {
  const SceneFolder folder;
  const double mu = 0.4, a = 0.6, t = 0.4;
  Assembled cloth = on_incline(folder, mu, a);
  const Eigen::VectorXd start = positions(cloth);
  advance(cloth, t);
  const double way = 9.81 * (std::sin(a) - mu * std::cos(a)) * t * t / 2;
  for (Eigen::Index k = 0; k < start.size(); k += 3)
    EXPECT_NEAR(positions(cloth)[k] - start[k], way, 1e-3 * way);
}

// A sticking cloth does not creep.
TEST(Contact, SticksForTenSeconds) {
  const SceneFolder folder;
  Assembled cloth = on_incline(folder, 0.4, std::atan(0.35));
  advance(cloth, 0.1);
  const Eigen::VectorXd start = positions(cloth);
  advance(cloth, 10);
  EXPECT_LT((positions(cloth) - start).cwiseAbs().maxCoeff(), 1e-6);
}

// A static coefficient of 0.5 and a kinetic one of 0.3: once the cloth slides, the kinetic one acts.
TEST(Contact, KineticFrictionActsOnceItSlides) {
  const SceneFolder folder;
  Assembled cloth = on_incline(folder, 0.5, std::atan(0.4));
  for (model::Lattice& l : cloth.system.lattices) l.contact_law.friction = {0.5, 0.3};
  const Eigen::VectorXd start = positions(cloth);
  advance(cloth, 0.2);
  EXPECT_LT((positions(cloth) - start).cwiseAbs().maxCoeff(), 1e-9);
  for (std::size_t n : cloth.system.particle) cloth.state.vx[n] += 0.01;
  advance(cloth, 0.2);
  const double a = std::atan(0.4), way = 0.01 * 0.2 + 9.81 * (std::sin(a) - 0.3 * std::cos(a)) * 0.04 / 2;
  EXPECT_NEAR((positions(cloth) - start)[0], way, 0.02 * way);
}

// Case h': a strip pulled round a cylinder. At each sliding node T2/T1 = (1 + mu tan(D/2))/(1 - mu
// tan(D/2)), D the angle of the yarn there. The facets' normals are off by up to pi/1440, and the ratio by
// twice that times tan(D/2).
TEST(Contact, TensionGrowsRoundACapstan) {
  const SceneFolder folder;
  const double mu = 0.3, radius = 0.05, cell = 0.005;
  scene::FabricSpec fabric = linen();
  fabric.bias = {};
  fabric.bending_warp = fabric.bending_weft = 0;
  fabric.friction = {mu, mu};
  Scene scene = reference::rectangle(fabric, 16 * cell, cell, cell);
  scene.gravity = {0, 0, 0};
  scene.damping = 200;
  scene.bias_model = scene::BiasModel::kOdd;
  const double contact_distance = fabric.thickness / 2, r = radius + contact_distance;
  scene::PlaceSpec& place = scene.pieces[0].place;
  place.origin = {-8 * cell, 0, r};
  place.radius = {r, r};
  place.axis_point = {0, 0, 0};
  place.axis = {0, 1, 0};
  scene::PinSpec first = reference::pin_edges("first", {3}), last = reference::pin_edges("last", {1});
  last.drive = scene::Drive::kPosition;
  scene.pins = {first, last};
  body_add(scene, folder, "capstan", cylinder(radius, 0.1, 720));
  Assembled a = assemble(scene);
  // The last edge moves along its tangent until everything slides.
  const Vec3 start = a.state.pin_motion[1].position;
  const double angle = 8 * cell / r;
  // The strip vibrates as it slides, so means over the last advances are compared.
  const int advances = 300, measured = 100;
  std::array<double, 17> strain{}, turn{};
  const auto node = [&](int i) {
    const std::size_t n = a.system.lattices[0].node(i, 0);
    return Vec3{a.state.x[n], a.state.y[n], a.state.z[n]};
  };
  for (int k = 1; k <= advances; ++k) {
    const double way = 0.002 * cell * k;
    a.motion.inputs.pin[1].position = start + way * Vec3{std::cos(angle), 0, -std::sin(angle)};
    advance(a, 1e-3);
    for (int i = 1; i < 16 && k > advances - measured; ++i) {
      const Vec3 before = node(i) - node(i - 1), after = node(i + 1) - node(i);
      strain[std::size_t(i)] += (norm(before) / cell - 1) / measured;
      turn[std::size_t(i)] += std::acos(dot(before, after) / (norm(before) * norm(after))) / measured;
    }
  }
  for (std::size_t i = 3; i <= 12; ++i) {
    const double t = std::tan(turn[i] / 2);
    EXPECT_NEAR(strain[i + 1] / strain[i], (1 + mu * t) / (1 - mu * t), 1e-3)
        << "node " << i << ", turn " << turn[i];
  }
}

struct Synchronous {
  Array v[3];
  std::vector<math::Wrench> pins;
};
Synchronous synchronous(Assembled& a) {
  Synchronous s;
  for (Array& v : s.v) v.assign(a.system.nodes, 0.0);
  dynamics::leapfrog_synchronous(a.system, a.motion, a.state, {s.v[0].data(), s.v[1].data(), s.v[2].data()},
                                 s.pins);
  return s;
}

// A cloth falls, meets a moving ball with friction and slides off. Over every advance, the momentum gained
// by the cloth is the weight's impulse less the impulse reported to the ball.
TEST(Contact, MomentumIsBalancedOverEveryAdvance) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(), 0.2, 0.2, 0.01);
  scene.pieces[0].place.origin = {-0.07, -0.1, 0.052};
  scene.pieces[0].velocity = {0.1, 0, -1};
  scene::BodySpec& spec = body_add(scene, folder, "ball", ball(0.05, 40));
  spec.moves = true;
  Assembled a = assemble(scene);
  double worst = 0, largest = 0, mass = 0;
  for (std::size_t n : a.system.particle) mass += a.system.mass[n];
  Synchronous at_start = synchronous(a);
  Vec3 before = momentum(a, at_start.v);
  for (int k = 1; k <= 60; ++k) {
    math::RigidMotion& to = a.motion.inputs.body[0];
    to.position = {0, 0, 0.02 * std::sin(0.05 * k)};
    to.velocity = {0, 0, 0.02 * 50 * std::cos(0.05 * k)};
    to.angular_velocity = {0, 3, 0};
    to.orientation = math::rotation_exp({0, 3 * 1e-3 * k, 0});
    advance(a, 1e-3);
    Synchronous now = synchronous(a);
    const Vec3 after = momentum(a, now.v), gained = after - before;
    const Vec3 reported =
        a.state.body[0].impulse.force + (any_near(a.state) ? a.motion.contact.load[0].force : Vec3{});
    const Vec3 weight{0, 0, -9.81e-3 * mass};
    worst = std::max(worst, norm(gained - (weight - reported)));
    largest = std::max(largest, norm(reported));
    before = after;
  }
  EXPECT_GT(largest, 1e-4 * mass);
  EXPECT_LT(worst, 1e-9 * largest);
}

// At 50 m/s against a thin plate and against a sharp edge, with the automatic step.
TEST(Contact, NothingGetsThroughAtFiftyMetresPerSecond) {
  const SceneFolder folder;
  Mesh feature;  // a roof of 20 degrees, closed below
  feature.point = {{-1, 0, 0},       {1, 0, 0},        {1, 0.1763, -1},
                   {-1, 0.1763, -1}, {1, -0.1763, -1}, {-1, -0.1763, -1}};
  feature.corner = {{0, 1, 2}, {0, 2, 3}, {1, 0, 5}, {1, 5, 4}, {3, 2, 4}, {3, 4, 5}, {1, 4, 2}, {0, 3, 5}};
  for (const bool plate : {true, false}) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-1, 1);
    scene::FabricSpec dust = linen();
    dust.warp = dust.weft = dust.bias = {};
    dust.bending_warp = dust.bending_weft = 0;
    dust.friction = {0, 0};
    Scene scene = reference::rectangle(dust, 0.09, 0.09, 0.01);
    scene.gravity = {0, 0, 0};
    scene.pieces[0].place.origin = {-0.045, -0.045, 0.05};
    scene.pieces[0].velocity = {0, 0, -50};
    if (plate) body_add(scene, folder, "plate", box(2, 2, 0.001));
    else body_add(scene, folder, "ridge", feature);
    Assembled a = assemble(scene);
    for (std::size_t n : a.system.particle) a.state.y[n] += 0.004 * shift(random);
    begin(a.system, a.motion.kernel->contact, a.motion.contact, a.state);
    advance(a, 0.01);
    for (std::size_t n : a.system.particle) {
      const double z = a.state.z[n], y = a.state.y[n];
      if (plate) EXPECT_GT(z, 0.0005);
      else EXPECT_GT(std::abs(y) * std::cos(0.1745) + z * std::sin(0.1745), 0.0) << y << " " << z;
    }
  }
}

// Nor through a body of small triangles that is reached from afar, in steps chosen for free flight: a ball
// of 0.05 m, whose facets lie within 1e-4 m of it.
TEST(Contact, NothingGetsThroughFromAfar) {
  const SceneFolder folder;
  scene::FabricSpec dust = linen();
  dust.warp = dust.weft = dust.bias = {};
  dust.bending_warp = dust.bending_weft = 0;
  dust.friction = {0, 0};
  for (const double start : {0.27, 0.333, 0.354, 0.417, 0.48}) {
    Scene scene = reference::rectangle(dust, 0.02, 0.02, 0.01);
    scene.gravity = {0, 0, 0};
    scene.pieces[0].place.origin = {-0.01, -0.01, start};
    scene.pieces[0].velocity = {0, 0, -50};
    body_add(scene, folder, "ball", ball(0.05, 100));
    Assembled a = assemble(scene);
    for (int k = 0; k < 30; ++k) {
      advance(a, 1.6 * (start - 0.04) / 50 / 30);
      for (std::size_t n : a.system.particle)
        ASSERT_GT(std::hypot(a.state.x[n], a.state.y[n], a.state.z[n]), 0.0499) << start;
    }
  }
}

// A frictionless cloth pressed onto a table by inclined gravity stays in contact: order 2 against the
// reference solver.
TEST(Contact, OrderIsTwoWhileNoContactOpensOrCloses) {
  const SceneFolder folder;
  Scene scene = reference::smooth_scene();
  scene.fabrics[0].thickness = 1e-3;
  scene.fabrics[0].friction = {0, 0};
  scene.pins.clear();
  scene.gravity = {1, 0.5, -9.81};
  scene.pieces[0].place.origin = {0, 0, 0.0004};
  scene.pieces[0].velocity = {0.2, 0.1, 0};
  body_add(scene, folder, "table", box(2, 2, 0.1)).position = {0, 0, -0.05};
  const double time = 0.02;
  const reference::ReferenceState exact = reference::reference_state_at(scene, {}, time, 1e-12);
  std::vector<double> errors;
  for (double h : {1e-4, 5e-5, 2.5e-5}) {
    scene.step = h;
    Assembled a = assemble(scene);
    advance(a, time);
    EXPECT_EQ(contact_summary(a.system, a.state, {}).count, a.system.particle.size());
    errors.push_back((positions(a) - exact.r).cwiseAbs().maxCoeff());
  }
  for (std::size_t k = 1; k < errors.size(); ++k)
    EXPECT_NEAR(std::log2(errors[k - 1] / errors[k]), 2, 0.1) << errors[k];
  EXPECT_LT(errors.back(), 1e-8);
}

// The same bits for every kernel, thread count and grouping of advances.
TEST(Contact, BitsAreThoseOfEveryKernelAndGrouping) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(), 0.2, 0.2, 0.01);
  scene.pieces[0].place.origin = {-0.07, -0.1, 0.0507};
  body_add(scene, folder, "ball", ball(0.05, 40));
  const auto run = [&](const char* kernel, int advances) {
    Assembled a = assemble(scene);
    if (kernel) a.motion.kernel = dynamics::kernel_named(kernel);
    if (!a.motion.kernel) return Eigen::VectorXd();
    for (int k = 0; k < advances; ++k) advance(a, 0.06 / advances);
    return positions(a);
  };
  const Eigen::VectorXd whole = run("scalar", 1);
  if (whole.size() == 0) GTEST_SKIP() << "no kernel with fused arithmetic";
  for (const char* kernel : {"avx2", "avx512"}) {
    const Eigen::VectorXd other = run(kernel, 6);
    if (other.size() == 0) continue;  // not on this processor
    EXPECT_EQ((other - whole).cwiseAbs().maxCoeff(), 0.0) << kernel;
  }
  EXPECT_LT((run("portable", 1) - whole).cwiseAbs().maxCoeff(), 1e-6);
}

// A load reported while something touches a body is not reported again once nothing does.
TEST(Contact, PastLoadsAreNotReportedAgain) {
  const SceneFolder folder;
  Assembled a = on_incline(folder, 0.4, 0.1);
  advance(a, 0.01);
  synchronous(a);
  EXPECT_LT(a.motion.contact.load[0].force[2], 0);
  for (std::size_t n : a.system.particle) a.state.z[n] += 0.1;
  begin(a.system, a.motion.kernel->contact, a.motion.contact, a.state);
  ASSERT_FALSE(any_near(a.state));
  a.state.body[0].impulse = {};
  a.state.advance_begins = false;
  dynamics::leapfrog_complete(a.system, a.motion, a.state);
  EXPECT_EQ(a.state.body[0].impulse.force, (Vec3{0, 0, 0}));
}

// A restored state continues with the same bits.
TEST(Contact, StateGoesOnAsItWas) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(), 0.2, 0.2, 0.01);
  scene.pieces[0].place.origin = {-0.07, -0.1, 0.0507};
  body_add(scene, folder, "ball", ball(0.05, 40));
  Assembled a = assemble(scene);
  advance(a, 0.03);
  expect_goes_on(a, 0.03);
}

// The balance counts all energies, friction and the motion of the body: it closes with order 2 of the step.
TEST(Contact, EnergyIsBalanced) {
  const SceneFolder folder;
  Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.01);
  scene.energy = true;
  scene.pieces[0].place.origin = {-0.05, -0.05, 0.0005};
  scene.pieces[0].velocity = {1, 0, 0};
  scene::BodySpec& spec = body_add(scene, folder, "table", box(2, 2, 0.1));
  spec.position = {0, 0, -0.05};
  Assembled a = assemble(scene);
  const drape_energy e = energies_after(a, 0.2);
  const double kinetic = 0.5 * 0.2 * 0.01;  // of 1 m/s
  EXPECT_GT(e.dissipated, 0.5 * kinetic);
  EXPECT_LT(std::abs(e.balance_error), 1e-3 * kinetic) << a.state.energy_start;
}

// Sheets fall flat on a table and rebound a little: where damping holds back what the penalty gives, that is
// dissipated, and the balance closes with order 2.
TEST(Contact, EnergyOfALandingSheetIsBalanced) {
  const SceneFolder folder;
  std::vector<double> errors;
  for (const double step : {1e-4, 5e-5}) {
    Scene scene = reference::rectangle(linen(), 0.1, 0.1, 0.025);
    scene.pieces[0].place.origin = {-0.05, -0.05, 0.055};
    body_add(scene, folder, "table", box(0.3, 0.3, 0.1));
    scene.energy = true;
    scene.damping = 1;
    scene.step = step;
    Assembled a = assemble(scene);
    const drape_energy e = energies_after(a, 0.1);
    errors.push_back(std::abs(e.balance_error) / e.dissipated);
  }
  EXPECT_LT(errors[0], 0.02);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.3);
}

}  // namespace
}  // namespace drape::contact
