// Driven pins: their paths, and the motion of the cloth along them. Equations: core/README.md, section 4,
// "Inputs" and "Pins".
#include <gtest/gtest.h>

#include "driven_pin_fixture.h"

namespace drape::dynamics {

using namespace tests;
namespace {

math::RigidMotion frame_somewhere() {
  math::RigidMotion f;
  f.position = {0.1, -0.2, 0.3};
  f.orientation = turn_about({1, 2, -1}, 0.8);
  f.velocity = {1, 2, -0.5};
  f.angular_velocity = {3, -1, 2};
  return f;
}

// The path of a pin from the start, or from frame_somewhere.
PinPath path_to(scene::Drive drive, const math::RigidMotion& to, double length, bool from_rest = false) {
  Assembled a = assemble(rigid(drive));
  if (!from_rest) a.state.pin_motion[0] = frame_somewhere();
  a.motion.inputs.pin[0] = to;
  return path_make(a.system, a.state, a.motion.inputs, length).pins.at(0);
}

math::RigidMotion frame_asked() {
  math::RigidMotion f;
  f.position = {0.15, -0.1, 0.2};
  f.orientation = turn_about({-1, 1, 2}, 1.5);
  f.velocity = {0.5, 1, 1};
  f.angular_velocity = {-2, 1, 4};
  return f;
}

// At z = 1 the values themselves; at z = 0 where the pin was.
TEST(PrescribedMotion, BeginsAndEndsExactly) {
  const math::RigidMotion from = frame_somewhere(), to = frame_asked();
  for (const scene::Drive drive : {scene::Drive::kPosition, scene::Drive::kVelocity, scene::Drive::kBoth}) {
    const PinPath path = path_to(drive, to, 0.05);
    const math::RigidMotion begin = path_frame(path, 0), end = path_frame(path, 1);
    EXPECT_EQ(begin.position, from.position);
    EXPECT_EQ(begin.orientation, from.orientation);
    if (drive != scene::Drive::kVelocity) {
      EXPECT_EQ(end.position, to.position);
      EXPECT_EQ(end.orientation, math::quaternion_normalised(to.orientation));
    }
    if (drive != scene::Drive::kPosition) {
      EXPECT_NEAR((vec(begin.velocity) - vec(from.velocity)).norm(), 0, 1e-14);
      EXPECT_NEAR((vec(begin.angular_velocity) - vec(from.angular_velocity)).norm(), 0, 1e-14);
      EXPECT_EQ(end.velocity, to.velocity);
      EXPECT_EQ(end.angular_velocity, to.angular_velocity);
    }
    // What the path says of its end is what it comes to.
    const math::RigidMotion near = path_frame(path, 1 - 1e-12);
    EXPECT_NEAR((vec(near.position) - vec(end.position)).norm(), 0, 1e-11);
    EXPECT_NEAR(quat(near.orientation).angularDistance(quat(end.orientation)), 0, 1e-7);  // acos near 1
    EXPECT_NEAR((vec(near.velocity) - vec(end.velocity)).norm(), 0, 1e-9);
    EXPECT_NEAR((vec(near.angular_velocity) - vec(end.angular_velocity)).norm(), 0, 1e-9);
    EXPECT_NEAR((vec(near.angular_acceleration) - vec(end.angular_acceleration)).norm(), 0, 1e-6);
  }
}

// Velocities and accelerations are the derivatives of the path: central differences over d, whose error is
// d^2 times the third derivative over 6 (at most about (50/H)^3 d^2 here), and rounding over d.
TEST(PrescribedMotion, GivesTheDerivativesOfItsPath) {
  const double length = 0.5, d = 1e-5;
  for (const scene::Drive drive : {scene::Drive::kPosition, scene::Drive::kVelocity, scene::Drive::kBoth}) {
    const PinPath path = path_to(drive, frame_asked(), length);
    for (const double z : {0.1, 0.45, 0.8}) {
      const math::RigidMotion before = path_frame(path, z - d / length), now = path_frame(path, z),
                              after = path_frame(path, z + d / length);
      EXPECT_NEAR(((vec(after.position) - vec(before.position)) / (2 * d) - vec(now.velocity)).norm(), 0,
                  1e-8);
      EXPECT_NEAR(((vec(after.velocity) - vec(before.velocity)) / (2 * d) - vec(now.acceleration)).norm(), 0,
                  1e-8);
      const Eigen::AngleAxisd between(quat(after.orientation) * quat(before.orientation).conjugate());
      EXPECT_NEAR((between.axis() * between.angle() / (2 * d) - vec(now.angular_velocity)).norm(), 0, 1e-7);
      EXPECT_NEAR(((vec(after.angular_velocity) - vec(before.angular_velocity)) / (2 * d) -
                   vec(now.angular_acceleration))
                      .norm(),
                  0, 1e-6);
    }
  }
}

// A turning velocity along a line, in one advance and in two: the rotation is of order 4, so halves agree
// with the whole to a fraction 2^-4 of its error, and three halvings show the order.
TEST(PrescribedMotion, TurnsByItsAngularVelocityToTheFourthOrder) {
  const auto turned = [](int parts) {
    Assembled a = assemble(rigid(scene::Drive::kVelocity));
    const V w0{3, -1, 2}, w1{-2, 5, 4};
    a.state.pin_motion[0].angular_velocity = arr(w0);
    for (int k = 1; k <= parts; ++k) {
      a.motion.inputs.pin[0].angular_velocity = arr(w0 + (w1 - w0) * k / parts);
      const Path path = path_make(a.system, a.state, a.motion.inputs, 0.4 / parts);
      a.state.pin_motion[0] = path_frame(path.pins[0], 1);
    }
    return quat(a.state.pin_motion[0].orientation);
  };
  const Eigen::Quaterniond fine = turned(1024);
  double last = 0;
  for (const int parts : {4, 8, 16}) {
    const double error = (turned(parts).coeffs() - fine.coeffs()).norm();
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 4, 0.3) << parts;
    }
    last = error;
  }
}

// A constant velocity v from rest: over the first advance the line from 0 to v, p = v H/2; then v H each. The
// same bits however an advance at constant velocity is cut.
TEST(PrescribedMotion, IntegratesVelocity) {
  const auto run = [](int calls) {
    Assembled a = assemble(sheet(scene::Drive::kVelocity));
    math::RigidMotion& to = a.motion.inputs.pin[0];
    to.velocity = {0.1, -0.2, 0.05};
    to.angular_velocity = {1, 2, 3};
    advance(a, 0.005);
    for (int k = 0; k < calls; ++k) advance(a, 0.05 / calls);
    return a;
  };
  const Assembled one = run(1), ten = run(10);
  const V p0 = vec(one.system.constraints.pins[0].centre), v{0.1, -0.2, 0.05};
  EXPECT_NEAR((vec(one.state.pin_motion[0].position) - p0 - v * 0.0525).norm(), 0, 1e-16 * 50);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.0525 * std::sqrt(14.0), V(1, 2, 3).normalized()));
  EXPECT_NEAR((quat(one.state.pin_motion[0].orientation).coeffs() - turn.coeffs()).norm(), 0, 1e-14);
  EXPECT_TRUE(one.state.x == ten.state.x && one.state.y == ten.state.y && one.state.z == ten.state.z);
  EXPECT_TRUE(one.state.vx == ten.state.vx && one.state.vy == ten.state.vy && one.state.vz == ten.state.vz);
  EXPECT_EQ(one.state.pin_motion[0].position, ten.state.pin_motion[0].position);
  EXPECT_EQ(one.state.pin_motion[0].orientation, ten.state.pin_motion[0].orientation);
}

// A position at rest gives the same bits in one call or ten; one that goes along a line the same but for
// rounding, which a smooth motion of 20 ms multiplies by less than a thousand.
TEST(PrescribedMotion, DoesNotDependOnHowAnAdvanceIsCut) {
  const auto run = [](int calls, double reach) {
    Assembled a = assemble(sheet(scene::Drive::kPosition));
    const V p0 = vec(a.system.constraints.pins[0].centre);
    for (int k = 1; k <= calls; ++k) {
      a.motion.inputs.pin[0].position = arr(p0 + V(1, 2, -1) * (reach * k / calls));
      advance(a, 0.02 / calls);
    }
    return a.state;
  };
  const State rest = run(1, 0), rests = run(20, 0);
  EXPECT_TRUE(rest.x == rests.x && rest.y == rests.y && rest.z == rests.z);
  EXPECT_TRUE(rest.vx == rests.vx && rest.vy == rests.vy && rest.vz == rests.vz);
  const State one = run(1, 0.001), ten = run(10, 0.001);
  for (std::size_t n = 0; n < one.x.size(); ++n) {
    EXPECT_NEAR(one.x[n], ten.x[n], 1e-13);
    EXPECT_NEAR(one.y[n], ten.y[n], 1e-13);
    EXPECT_NEAR(one.z[n], ten.z[n], 1e-13);
  }
}

// 35 turns of 10 degrees come to 350 degrees, exactly where the input says; each goes the short way round.
TEST(PrescribedMotion, TurnsOnBeyondHalfATurn) {
  Assembled a = assemble(rigid(scene::Drive::kPosition));
  for (int k = 1; k <= 35; ++k) {
    a.motion.inputs.pin[0].orientation = turn_about({0, 0, 1}, k * kPi / 18);
    advance(a, 0.005);
    EXPECT_NEAR(vec(a.state.pin_motion[0].angular_velocity)[2], kPi / 18 / 0.005, 1e-10) << k;
  }
  EXPECT_NEAR(
      (quat(a.state.pin_motion[0].orientation).coeffs() - quat(turn_about({0, 0, 1}, 35 * kPi / 18)).coeffs())
          .norm(),
      0, 1e-15);
}

// A node held by a point pin moves along the cubic of "both": order 2 of the free cloth in the step.
TEST(PrescribedMotion, KeepsTheSecondOrder) {
  const auto run = [](double step, bool jumps) {
    Scene scene = sheet(jumps ? scene::Drive::kPosition : scene::Drive::kBoth);
    scene.step = step;
    scene.damping = 2;
    Assembled a = assemble(scene);
    const V p0 = vec(a.system.constraints.pins[0].centre);
    for (int k = 1; k <= 10; ++k) {
      const double t = 0.002 * k;
      math::RigidMotion& to = a.motion.inputs.pin[0];
      to.position = arr(p0 + V(0.3 * t * t, 4 * t * t, 0.01 * std::sin(50 * t)));
      to.velocity = arr(V(0.6 * t, 8 * t, 0.5 * std::cos(50 * t)));
      to.orientation = turn_about({1, 2, 0}, 20 * t * t);
      to.angular_velocity = arr(V(1, 2, 0).normalized() * 40 * t);
      advance(a, 0.002);
    }
    return positions(a);
  };
  for (const bool jumps : {false, true}) {
    const double h = 4e-5;
    const Eigen::VectorXd fine = run(h / 16, jumps);
    const double coarse = (run(h, jumps) - fine).norm(), half = (run(h / 2, jumps) - fine).norm();
    // The reference itself is off by 1/256 of the coarse error: the order read is 2 + log2((1 - 1/64)/(1 -
    // 1/256)) within 0.02.
    EXPECT_NEAR(std::log2(coarse / half), 2, 0.15) << (jumps ? "position" : "both");
    std::printf("driven clamp, %s: order %.3f\n", jumps ? "position" : "both", std::log2(coarse / half));
  }
}

}  // namespace
}  // namespace drape::dynamics
