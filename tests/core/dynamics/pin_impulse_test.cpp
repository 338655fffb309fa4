// Driven pins: the cloth they move, and the impulses they pass to the outside world. Equations:
// core/README.md, section 4, "Inputs" and "Pins".
#include <gtest/gtest.h>

#include "driven_pin_fixture.h"

namespace drape::dynamics {

using namespace tests;
namespace {

// The impulse of a pin on the outside world in the last advance, and its moment about the pin.
math::Wrench impulse_of(Assembled& a, std::size_t pin) {
  std::vector<math::Wrench> load;
  Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
  leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, load);
  const double half = a.system.integrator == scene::Integrator::kPaper ? 0 : a.state.h_old / 2;
  return {arr(vec(a.state.pin_impulse[pin].force) + half * vec(load[pin].force)),
          arr(vec(a.state.pin_impulse[pin].torque) + half * vec(load[pin].torque))};
}

// Linear momentum, and angular momentum about `at`, of the synchronous velocities.
std::pair<V, V> momenta(Assembled& a, const V& at = V::Zero()) {
  std::vector<math::Wrench> load;
  Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
  leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, load);
  V linear = V::Zero(), angular = V::Zero();
  for (std::size_t n : a.system.particle) {
    const V p = a.system.mass[n] * V(vx[n], vy[n], vz[n]);
    linear += p;
    angular += (V(a.state.x[n], a.state.y[n], a.state.z[n]) - at).cross(p);
  }
  return {linear, angular};
}

double total_mass(const Assembled& a) {
  double mass = 0;
  for (std::size_t n : a.system.particle) mass += a.system.mass[n];
  return mass;
}

// r = p + R (X - p_0) for every node, at any position of the pin. The piece's centroid obeys F = M (v' - g),
// and in the mean over an advance the force on the outside world is -M (v_1 - v_0)/H + M g. With g = 0 and
// about a point at rest the torque is -(L_1 - L_0)/H, L = I w of a rigid body.
TEST(PinImpulse, MovesAPieceAsARigidBody) {
  for (const bool turns : {false, true}) {
    Scene scene = rigid(scene::Drive::kBoth);
    if (turns) scene.gravity = {0, 0, 0};
    Assembled a = assemble(scene);
    const State start = a.state;
    const V p0 = vec(a.system.constraints.pins[0].centre);
    const double length = 0.02, mass = total_mass(a);
    V last = V::Zero();
    for (int k = 1; k <= 5; ++k) {
      math::RigidMotion& to = a.motion.inputs.pin[0];
      const double t = k * length, acceleration = 30;
      if (turns) {
        to.orientation = turn_about({1, 1, 3}, acceleration * t * t / 2);
        to.angular_velocity = arr(V(1, 1, 3).normalized() * acceleration * t);
      } else {
        to.position = arr(p0 + V(1, -2, 0.5) * acceleration * t * t / 2);
        to.velocity = arr(V(1, -2, 0.5) * acceleration * t);
      }
      advance(a, length);
      const math::Wrench impulse = impulse_of(a, 0);
      const math::RigidMotion& now = a.state.pin_motion[0];
      Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
      V centroid = V::Zero();
      for (std::size_t n : a.system.particle) {
        const V arm = quat(now.orientation) * (V(start.x[n], start.y[n], start.z[n]) - p0);
        const V r = vec(now.position) + arm;
        EXPECT_NEAR((V(a.state.x[n], a.state.y[n], a.state.z[n]) - r).norm(), 0, 1e-15);
        inertia +=
            a.system.mass[n] * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
        centroid += a.system.mass[n] / mass * arm;
      }
      if (turns) {
        const V angular = inertia * vec(now.angular_velocity);
        EXPECT_NEAR((vec(impulse.torque) + angular - last).norm(), 0, 1e-12 * angular.norm());
        last = angular;
      } else {
        const V expected = mass * (V(0, 0, -9.81) * length - (vec(now.velocity) - last));
        EXPECT_NEAR((vec(impulse.force) - expected).norm(), 0, 1e-12 * expected.norm());
        EXPECT_NEAR((vec(impulse.torque) - centroid.cross(expected)).norm(), 0, 1e-12 * expected.norm());
        last = vec(now.velocity);
      }
    }
  }
}

// The impulse of all pins is weight x H less the change of the cloth's momentum, in every advance, also
// where velocities jump; for pins at rest and moving, on nodes and in cut cells.
TEST(PinImpulse, ImpulsesBalanceTheMomentum) {
  for (const scene::Drive drive : {scene::Drive::kPosition, scene::Drive::kVelocity, scene::Drive::kBoth})
    for (const bool cut : {false, true}) {
      Assembled a = assemble(sheet(drive, cut));
      V before = momenta(a).first;
      const V weight = total_mass(a) * V(0, 0, -9.81);
      for (int k = 1; k <= 12; ++k) {
        math::RigidMotion& to = a.motion.inputs.pin[0];
        to.position =
            arr(vec(a.system.constraints.pins[0].centre) + V(2e-4, 1e-3, -5e-4) * k * std::sin(0.5 * k));
        to.orientation = turn_about({0, 1, 0.3 * k}, 0.05 * k);
        to.velocity = {0.1 * std::sin(k), -0.1, 0.05};
        to.angular_velocity = {5, 2.0 * std::cos(k), -3};
        advance(a, k % 3 ? 0.002 : 0.0013);
        V given = V::Zero();
        for (std::size_t p = 0; p < a.state.pin_impulse.size(); ++p) given += vec(impulse_of(a, p).force);
        const V now = momenta(a).first;
        const double scale = weight.norm() * 0.01 + now.norm();
        EXPECT_NEAR((given - weight * a.state.advance_length + now - before).norm(), 0, 1e-12 * scale)
            << int(drive) << " cut " << cut << " advance " << k;
        before = now;
      }
    }
}

// Without gravity, the moment of a pin that rotates about a point at rest is minus the change of angular
// momentum about that point.
TEST(PinImpulse, MomentsBalanceTheAngularMomentum) {
  Scene scene = sheet(scene::Drive::kPosition, false);
  scene.gravity = {0, 0, 0};
  Assembled a = assemble(scene);
  const V at = vec(a.system.constraints.pins[0].centre);
  V before = momenta(a, at).second;
  for (int k = 1; k <= 12; ++k) {
    a.motion.inputs.pin[0].orientation = turn_about({0, 1, 0.1 * k}, 0.03 * k);
    advance(a, 0.002);
    const V moment = vec(impulse_of(a, 0).torque), now = momenta(a, at).second;
    EXPECT_NEAR((moment + now - before).norm(), 0, 1e-12 * (now.norm() + moment.norm())) << k;
    before = now;
  }
}

// The paper's scheme kicks whole steps: the momentum of its own velocities is balanced.
TEST(PinImpulse, ImpulsesBalanceTheMomentumOfThePapersScheme) {
  for (const bool cut : {false, true}) {
    Assembled a = assemble(sheet(scene::Drive::kVelocity, cut, scene::Integrator::kPaper));
    const auto momentum = [&] {
      V sum = V::Zero();
      for (std::size_t n : a.system.particle)
        sum += a.system.mass[n] * V(a.state.vx[n], a.state.vy[n], a.state.vz[n]);
      return sum;
    };
    V before = momentum();
    for (int k = 1; k <= 6; ++k) {
      a.motion.inputs.pin[0].velocity = {0.1 * std::sin(k), -0.1, 0.05};
      a.motion.inputs.pin[0].angular_velocity = {5, 2.0 * std::cos(k), -3};
      advance(a, 0.002);
      V given = V::Zero();
      for (const math::Wrench& load : a.state.pin_impulse) given += vec(load.force);
      const V now = momentum(), weight = total_mass(a) * V(0, 0, -9.81);
      EXPECT_NEAR((given - weight * 0.002 + now - before).norm(), 0,
                  1e-12 * (weight.norm() * 0.01 + now.norm()));
      before = now;
    }
  }
}

// Where a pin's velocity jumps by dv, the cloth gains M^-1 A^T (A M^-1 A^T)^-1 dv at once. For a piece held
// as a whole, the pin receives M dv: the mean force of the next advance contains it beside the weight.
TEST(PinImpulse, IncludesTheImpulseOfAJump) {
  Assembled a = assemble(rigid(scene::Drive::kPosition));
  const V p0 = vec(a.system.constraints.pins[0].centre);
  const double mass = total_mass(a), length = 0.01;
  double last = 0;
  for (const double velocity : {0.2, 0.2, -0.1}) {
    Vec3& to = a.motion.inputs.pin[0].position;
    to[0] = (to[0] == 0 && p0[0] != 0 ? p0[0] : a.state.pin_motion[0].position[0]) + velocity * length;
    advance(a, length);
    const V impulse = vec(impulse_of(a, 0).force);
    EXPECT_NEAR(impulse[0], -mass * (velocity - last), 1e-12 * mass);
    EXPECT_NEAR(impulse[2], -mass * 9.81 * length, 1e-12 * mass);
    last = velocity;
  }
}

}  // namespace
}  // namespace drape::dynamics
