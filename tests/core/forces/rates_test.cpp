// Forces that depend on velocity: damping along springs and air. Equations: core/README.md, sections 3 and 4.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "cloth_fixture.h"
#include "cut_pieces.h"
#include "forces/rates.h"
#include "reference/forces.h"
#include "reference/resistance.h"

namespace drape::forces {

using namespace tests;
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

scene::FabricSpec damped_fabric() {
  scene::FabricSpec fabric = reference::curved_fabric();
  fabric.damping = 3e-3;
  return fabric;
}

Scene sheet(bool damping, bool air, Shape shape = Shape::kRectangle) {
  Scene scene = cut_piece(damping ? damped_fabric() : reference::curved_fabric(), shape);
  scene.has_air = air;
  scene.air_normal = 1.1;
  scene.air_tangential = 0.2;
  scene.gravity = {0, 0, 0};
  return scene;
}

void set_velocities(Assembled& a, auto velocity) {
  for (std::size_t n : a.system.particle) {
    const Vector3d v = velocity(Vector3d(a.state.x[n], a.state.y[n], a.state.z[n]));
    a.state.vx[n] = v[0];
    a.state.vy[n] = v[1];
    a.state.vz[n] = v[2];
  }
}

void throw_about(Assembled& a, double speed, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-speed, speed);
  for (std::size_t n : a.system.particle)
    for (Array* v : {&a.state.vx, &a.state.vy, &a.state.vz, &a.state.wx, &a.state.wy, &a.state.wz})
      (*v)[n] = any(random);
}

// What of the kernel's forces depends on velocity.
VectorXd rates_of(Assembled& a) {
  const VectorXd all = forces_by(dynamics::kernel_pick(), a);
  System still = a.system;
  still.air = {};
  for (model::Lattice& l : still.lattices) l.law.damping = 0;
  std::swap(still, a.system);
  const VectorXd elastic = forces_by(dynamics::kernel_pick(), a);
  std::swap(still, a.system);
  return all - elastic;
}

VectorXd velocities(const Assembled& a) { return gathered(a.system, a.state.vx, a.state.vy, a.state.vz); }

struct Totals {
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
  double sizes = 0;
};
Totals totals(const VectorXd& f, const VectorXd& r) {
  Totals t;
  for (Eigen::Index k = 0; k < f.size(); k += 3) {
    const Vector3d force = f.segment<3>(k), at = r.segment<3>(k);
    t.force += force;
    t.torque += at.cross(force);
    t.sizes += force.norm();
  }
  return t;
}

// In a linear law F = w k (e + beta e'): the damping is the elastic force of the strain beta e'.
TEST(Damping, AddsBetaTimesTheRateToTheStrainOfALinearYarn) {
  scene::FabricSpec fabric = reference::threads(300);
  fabric.damping = 2e-3;
  Scene scene = reference::rectangle(fabric, 0.03, 0.04, 0.01);
  scene.gravity = {0, 0, 0};
  Assembled a = assemble(scene);
  set_velocities(a, [](const Vector3d& r) { return Vector3d(0, 0.7 * r[1], 0); });  // e' = 0.7/s everywhere
  const VectorXd moving = forces_by(dynamics::kernel_pick(), a);
  set_velocities(a, [](const Vector3d&) { return Vector3d::Zero().eval(); });
  for (std::size_t n : a.system.particle) a.state.y[n] *= 1 + 2e-3 * 0.7;
  const VectorXd strained = forces_by(dynamics::kernel_pick(), a);
  EXPECT_GT(strained.norm(), 1e-3);
  EXPECT_LE((moving - strained).norm(), 1e-11 * strained.norm());  // a strain of 1e-3 is known to 1e-13
}

TEST(Damping, HasNoNetForceOrTorqueAndOnlyTakesEnergy) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Assembled a = assemble(sheet(true, false, Shape(seed % 5)));
    crumple(a, 0.0015, seed);
    throw_about(a, 1, seed + 50);
    const VectorXd f = rates_of(a);
    const Totals t = totals(f, positions(a));
    EXPECT_LE(t.force.norm(), 1e-14 * t.sizes);
    EXPECT_LE(t.torque.norm(), 1e-14 * t.sizes * 0.1);
    EXPECT_LT(f.dot(velocities(a)), -1e-3 * f.norm());
  }
}

TEST(Damping, DoesNothingToRigidMotion) {
  Assembled a = assemble(sheet(true, false));
  crumple(a, 0.0015, 3);
  throw_about(a, 1, 9);
  const double thrown = rates_of(a).norm();
  const Vector3d spin(3, -2, 5), along(1, 2, 3);
  set_velocities(a, [&](const Vector3d& r) { return (along + spin.cross(r)).eval(); });
  EXPECT_LE(rates_of(a).norm(), 1e-12 * thrown);
}

// A flat plate across the wind: rho/2 C_n A v^2 against it; along the wind rho/2 C_t A v^2. The cut rows
// count with their Core and judge, the elastic forces with those of damping and air: 1e-12 of the largest,
// for the rounding of some fifty terms a node.
TEST(Rates, AreThoseOfTheReference) {
  for (Shape shape : {Shape::kRectangle, Shape::kTriangle, Shape::kDiscWithHole, Shape::kDart, Shape::kSlits})
    for (scene::OutlineModel outline : {scene::OutlineModel::kCutCell, scene::OutlineModel::kPaper})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        Scene scene = sheet(true, true, shape);
        scene.outline = outline;
        scene.wind = {3, -1, 2};
        Assembled a = assemble(scene);
        crumple(a, 0.0015, seed);
        throw_about(a, 2, seed);
        a.state.wx = a.state.vx, a.state.wy = a.state.vy, a.state.wz = a.state.vz;
        const reference::Lattice lattice = reference::lattice_make(scene);
        const VectorXd core = forces_by(dynamics::kernel_pick(), a), r = positions(a), v = velocities(a);
        VectorXd expected = reference::forces(lattice, r);
        reference::add_link_damping(lattice, r, v, expected);
        reference::add_air(lattice, {scene.air_density, 1.1, 0.2}, Vector3d(3, -1, 2), r, v, expected);
        EXPECT_LE((core - expected).lpNorm<Eigen::Infinity>(), 1e-12 * expected.lpNorm<Eigen::Infinity>())
            << shape_name(shape) << ", seed " << seed;
      }
}

// area.
TEST(Air, DragOfAFlatPlateIsItsCoefficient) {
  for (Shape shape : {Shape::kRectangle, Shape::kDiscWithHole, Shape::kDart, Shape::kSlits}) {
    Assembled a = assemble(sheet(false, true, shape));
    double area = 0;
    for (double of_node : a.system.area) area += of_node;
    for (const Vector3d& v :
         {Vector3d(0, 0, 1.7), Vector3d(0, 0, -0.6), Vector3d(2.5, 0, 0), Vector3d(0, -1.3, 0)}) {
      set_velocities(a, [&](const Vector3d&) { return v; });
      const Vector3d drag = totals(rates_of(a), positions(a)).force;
      const Vector3d expected = -1.2 / 2 * (v[2] != 0 ? 1.1 : 0.2) * area * v.norm() * v;
      EXPECT_LE((drag - expected).norm(), 1e-12 * expected.norm()) << shape_name(shape);
    }
  }
}

TEST(Air, IsNothingAtTheWindsVelocityAndOpposesWhatDiffers) {
  Assembled a = assemble(sheet(false, true));
  crumple(a, 0.002, 4);
  a.state.wind = {1, -2, 0.5};
  set_velocities(a, [](const Vector3d&) { return Vector3d(1, -2, 0.5); });
  EXPECT_LE(rates_of(a).norm(), 1e-30);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int k = 0; k < 20; ++k) {
    const Vector3d u(any(random), any(random), any(random));
    set_velocities(a, [&](const Vector3d&) { return (Vector3d(1, -2, 0.5) + u).eval(); });
    EXPECT_LT(totals(rates_of(a), positions(a)).force.dot(u), 0);
  }
}

TEST(Rates, TurnWithTheCloth) {
  Assembled a = assemble(sheet(true, true));
  crumple(a, 0.0015, 5);
  throw_about(a, 1, 6);
  a.state.wind = {0.3, 1, -2};
  const VectorXd before = rates_of(a);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -3).normalized()).matrix();
  const auto turned = [&](double& x, double& y, double& z) {
    const Vector3d r = turn * Vector3d(x, y, z);
    x = r[0], y = r[1], z = r[2];
  };
  State& s = a.state;
  for (std::size_t n : a.system.particle) {
    turned(s.x[n], s.y[n], s.z[n]);
    turned(s.vx[n], s.vy[n], s.vz[n]);
  }
  turned(s.wind[0], s.wind[1], s.wind[2]);
  const VectorXd after = rates_of(a);
  for (Eigen::Index k = 0; k < before.size(); k += 3)
    EXPECT_LE((after.segment<3>(k) - turn * before.segment<3>(k)).norm(),
              1e-12 * before.lpNorm<Eigen::Infinity>());
}

// u_n = v + h_o/(h_o + h_oo) (v - w): with w off by the same, forces are those of the velocity led on.
TEST(Rates, AreTakenAtTheVelocityExtrapolatedToTheirTime) {
  Assembled a = assemble(sheet(true, true));
  crumple(a, 0.0015, 5);
  throw_about(a, 1, 6);
  State& s = a.state;
  s.h_old = 2e-5;
  s.h_older = 3e-5;
  const VectorXd led = rates_of(a);
  for (std::size_t n : a.system.particle)
    for (auto [v, w] : {std::pair{&s.vx, &s.wx}, {&s.vy, &s.wy}, {&s.vz, &s.wz}})
      (*v)[n] += 0.4 * ((*v)[n] - (*w)[n]);
  s.h_old = 0;
  EXPECT_LE((rates_of(a) - led).lpNorm<Eigen::Infinity>(), 1e-13 * led.lpNorm<Eigen::Infinity>());
}

TEST(Rates, AreTheSameBitForBitInEveryLaneAndOneByOne) {
  Assembled a = assemble(sheet(true, true));
  crumple(a, 0.0015, 7);
  throw_about(a, 1, 8);
  a.state.h_old = a.state.h_older = 1e-5;
  a.state.wind = {0.3, 1, -2};
  if (const dynamics::Kernel* scalar = dynamics::kernel_named("scalar")) {
    const VectorXd expected = forces_by(*scalar, a);
    for (const char* name : {"avx2", "avx512"}) {
      const dynamics::Kernel* kernel = dynamics::kernel_named(name);
      EXPECT_TRUE(!kernel || forces_by(*kernel, a) == expected) << name;
    }
  }
  Array fx(a.system.nodes), fy(a.system.nodes), fz(a.system.nodes);
  const Vec3 air = rate_forces(a.system, a.state, 0.5, fx.data(), fy.data(), fz.data());
  const VectorXd alone = gathered(a.system, fx, fy, fz), expected = rates_of(a);
  EXPECT_LE((alone - expected).lpNorm<Eigen::Infinity>(),
            1e-12 * forces_by(dynamics::kernel_pick(), a).lpNorm<Eigen::Infinity>());
  for (model::Lattice& l : a.system.lattices) l.law.damping = 0;
  const Vector3d total = totals(rates_of(a), positions(a)).force;
  EXPECT_LE((total - Vector3d(air[0], air[1], air[2])).norm(), 1e-12 * total.norm());
}

// Steps too: rows, twins and what lies beside the rows.
TEST(Rates, StepTheSameBitsInEveryLane) {
  const dynamics::Kernel* scalar = dynamics::kernel_named("scalar");
  if (!scalar) GTEST_SKIP() << "this processor has no AVX2 with FMA";
  for (Shape shape : kCutShapes)
    for (const bool rates : {false, true}) {
      Assembled a = assemble(sheet(rates, rates, shape));
      if (rates) a.system.lattices[0].law.damping = 3e-5;
      crumple(a, 0.001, 7);
      const State start = a.state;
      const auto stepped = [&](const dynamics::Kernel* kernel) {
        a.state = start;
        a.motion.kernel = kernel;
        for (int k = 0; k < 50; ++k)
          dynamics::leapfrog_step(a.system, a.motion, a.state, k / 10 % 2 ? 1e-6 : 2e-6);
        return a.state;
      };
      const State expected = stepped(scalar);
      EXPECT_TRUE(positions(a).allFinite());
      EXPECT_FALSE(expected.x == start.x);
      for (const char* name : {"avx2", "avx512"}) {
        const dynamics::Kernel* kernel = dynamics::kernel_named(name);
        if (!kernel) continue;
        const State found = stepped(kernel);
        EXPECT_TRUE(found.x == expected.x && found.y == expected.y && found.z == expected.z) << name;
        EXPECT_TRUE(found.vx == expected.vx && found.vy == expected.vy && found.vz == expected.vz) << name;
      }
    }
}

// A level sheet falling through air: v = v_t tanh(g t/v_t), v_t^2 = 2 rho g/(rho_air C_n); order 2 with steps
// that change.
TEST(Rates, KeepTheOrderOfLeapfrog) {
  Scene scene = reference::rectangle(reference::threads(8), 0.03, 0.03, 0.01);
  scene.has_air = true;
  scene.air_normal = 1.5;
  const double terminal = std::sqrt(2 * 0.15 * 9.81 / (1.2 * 1.5)), time = 0.2;
  const double fallen = terminal * terminal / 9.81 * std::log(std::cosh(9.81 * time / terminal));
  double error[3];
  for (int level = 0; level < 3; ++level) {
    Assembled a = assemble(scene);
    const int n = 300 << level;
    const double h = time / (1.5 * n);
    for (int k = 0; k < n; ++k) dynamics::leapfrog_step(a.system, a.motion, a.state, k / 10 % 2 ? h : 2 * h);
    error[level] = -a.state.z[a.system.particle[0]] - fallen;
  }
  std::printf("falling sheet: errors %.2e %.2e %.2e m\n", error[0], error[1], error[2]);
  EXPECT_NEAR(error[0] / error[1], 4, 0.4);
  EXPECT_NEAR(error[1] / error[2], 4, 0.4);
}

}  // namespace
}  // namespace drape::forces
