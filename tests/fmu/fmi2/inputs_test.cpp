// Inputs and their derivatives through FMI: which are refused, which act, which a saved state contains.
#include <cmath>

#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

constexpr double kQ = 1.0 / 1024;

TEST(Inputs, OutOfRange) {
  Slave slave(flag());
  slave.initialize();
  expect_refused(slave, "wind[2]", kNan, {"wind[2]", "nan", "allowed: -1000 to 1000 m/s"});
  expect_refused(slave, "wind[1]", 2000, {"wind[1]", "2000", "allowed: -1000 to 1000 m/s"});
  expect_refused(slave, "pin.pole.position[3]", kInfinity,
                 {"pin.pole.position[3]", "inf", "allowed: -10000 to 10000 m"});
  expect_refused(slave, "pin.pole.velocity[1]", -1e5,
                 {"pin.pole.velocity[1]", "-1e+05", "allowed: -10000 to 10000 m/s"});
  expect_refused(slave, "pin.pole.orientation[4]", kNan, {"pin.pole.orientation[4]", "nan", "allowed"});
  expect_refused(slave, "pin.pole.angular_velocity[2]", 1e6,
                 {"pin.pole.angular_velocity[2]", "1e+06", "rad/s"});
}

TEST(Inputs, AreReadBackInEveryPhaseThatTakesThem) {
  Slave slave(flag());
  EXPECT_EQ(slave.set("wind[1]", 2), fmi2OK);
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  EXPECT_EQ(slave.get("wind[1]"), 2);
  EXPECT_EQ(slave.set("wind[1]", 3), fmi2OK);
  ASSERT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK);
  EXPECT_EQ(slave.get("wind[1]"), 3);
  for (const std::string& name : flag().names) {
    if (name.starts_with("probe.")) break;
    if (!name.starts_with("pin.")) continue;
    const double value = slave.get(name) + 0.0009765625;
    EXPECT_EQ(slave.set(name, value), fmi2OK) << slave.last_message();
    EXPECT_EQ(slave.get(name), value);
  }
  EXPECT_EQ(slave.step(0, kQ), fmi2OK) << slave.last_message();
  EXPECT_EQ(slave.get("pin.hand.position[1]"), 0.06 + 0.0009765625);
}

TEST(Inputs, DerivativesThatAreRefused) {
  Slave slave(flag());
  slave.initialize();
  EXPECT_EQ(slave.set_rate("wind[1]", 1, 2), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"order", "wind[1]", "is 2", "allowed: 1"});
  EXPECT_EQ(slave.set_rate("wind[1]", 1, 0), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"order", "wind[1]", "is 0", "allowed: 1"});
  EXPECT_EQ(slave.set_rate("wind[1]", kNan), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"wind[1]", "nan", "m/s/s", "any finite number"});
  EXPECT_EQ(slave.set_rate("damping", 1), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"damping", "no input"});
  EXPECT_EQ(slave.set_rate("tension.max", 1), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"tension.max", "no input"});
  const fmi2Integer one = 1;
  const double value = 1;
  for (const fmi2ValueReference reference : {0u, unsigned(flag().names.size()) + 1, ~0u}) {
    EXPECT_EQ(fmi2().SetRealInputDerivatives(slave.component, &reference, 1, &one, &value), fmi2Discard);
    expect_sentence(slave, fmi2Discard, {std::to_string(reference), "allowed: 1 to"});
  }
  EXPECT_EQ(fmi2().SetRealInputDerivatives(slave.component, nullptr, 1, &one, &value), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fmi2SetRealInputDerivatives", "missing"});
}

// A call with one bad derivative changes none: the step is that of a cloth without derivatives.
TEST(Inputs, OneBadDerivativeRefusesTheWholeCall) {
  Slave slave(flag()), untouched(flag());
  slave.initialize();
  untouched.initialize();
  const fmi2ValueReference references[] = {flag().reference("wind[1]"), flag().reference("wind[2]")};
  const fmi2Integer orders[] = {1, 2};
  const double values[] = {100, 100};
  EXPECT_EQ(fmi2().SetRealInputDerivatives(slave.component, references, 2, orders, values), fmi2Discard);
  ASSERT_EQ(slave.step(0, kQ), fmi2OK);
  ASSERT_EQ(untouched.step(0, kQ), fmi2OK);
  EXPECT_EQ(slave.outputs(), untouched.outputs());
}

TEST(Inputs, ADerivativeThatLeadsOutOfRangeIsRefusedAtTheStep) {
  Slave slave(flag());
  slave.initialize();
  ASSERT_EQ(slave.step(0, kQ), fmi2OK);
  ASSERT_EQ(slave.set("wind[1]", 999), fmi2OK);
  ASSERT_EQ(slave.set_rate("wind[1]", 2048), fmi2OK);
  const std::vector<double> before = slave.outputs();
  EXPECT_EQ(slave.step(kQ, kQ), fmi2Discard);
  expect_sentence(slave, fmi2Discard,
                  {"wind[1]", "derivative", "= 1001 m/s", "allowed: from -1000 to 1000 m/s"});
  EXPECT_EQ(slave.outputs(), before);
  EXPECT_EQ(slave.get("wind[1]"), 1);  // its present position
  EXPECT_EQ(slave.step(kQ, kQ), fmi2OK) << slave.last_message();
}

// Some masters write 0 to what is not connected.
TEST(Inputs, AnOrientationOfZerosKeepsTheOldOneWithAWarning) {
  Slave slave(flag()), untouched(flag());
  slave.initialize();
  untouched.initialize();
  for (const fmi2Status expected : {fmi2Warning, fmi2OK}) {  // told once
    const double time = expected == fmi2Warning ? 0 : kQ;
    slave.log.clear();
    ASSERT_EQ(slave.set("pin.pole.orientation[1]", 0), fmi2OK);
    EXPECT_EQ(slave.step(time, kQ), expected) << slave.last_message();
    EXPECT_EQ(slave.log.size(), expected == fmi2Warning ? 1u : 0u);
    if (!slave.log.empty()) {
      EXPECT_EQ(slave.log[0].category, "logStatusWarning");
      EXPECT_EQ(slave.log[0].status, fmi2Warning);
      EXPECT_NE(slave.log[0].message.find("pin.pole.orientation is four zeros"), std::string::npos);
    }
    EXPECT_EQ(slave.get("pin.pole.orientation[1]"), 1);
    ASSERT_EQ(untouched.step(time, kQ), fmi2OK);
    EXPECT_EQ(slave.outputs(), untouched.outputs());
  }
}

// u + H u' with binary fractions is exact, so both ways give the same path.
TEST(Inputs, ADerivativeLeadsToTheValueAtTheEnd) {
  Slave with(flag()), without(flag());
  with.initialize();
  without.initialize();
  ASSERT_EQ(with.set_rate("pin.pole.position[3]", 1), fmi2OK);
  ASSERT_EQ(with.set_rate("pin.pole.velocity[3]", 16), fmi2OK);
  const double pole = without.get("pin.pole.position[3]");
  ASSERT_EQ(without.set("pin.pole.position[3]", pole + 4 * kQ), fmi2OK);
  ASSERT_EQ(without.set("pin.pole.velocity[3]", 0.0625), fmi2OK);
  ASSERT_EQ(with.step(0, 4 * kQ), fmi2OK) << with.last_message();
  ASSERT_EQ(without.step(0, 4 * kQ), fmi2OK) << without.last_message();
  EXPECT_EQ(with.outputs(), without.outputs());
  ASSERT_EQ(with.set_rate("wind[2]", 256), fmi2OK);
  ASSERT_EQ(without.set("wind[2]", 1), fmi2OK);  // 0 before
  for (Slave* slave : {&with, &without}) {
    ASSERT_EQ(slave->set("pin.pole.position[3]", pole + 4 * kQ), fmi2OK);
    ASSERT_EQ(slave->set("pin.pole.velocity[3]", 0.0625), fmi2OK);
    ASSERT_EQ(slave->step(4 * kQ, 4 * kQ), fmi2OK) << slave->last_message();
  }
  EXPECT_EQ(with.outputs(), without.outputs());
}

// A derivative applies only to the step that follows. In the next one, the wind goes back from 3 to the
// value set, 2.
TEST(Inputs, ADerivativeIsForOneStep) {
  Slave once(flag()), twice(flag());
  once.initialize();
  twice.initialize();
  for (Slave* slave : {&once, &twice}) {
    ASSERT_EQ(slave->step(0, kQ), fmi2OK);
    ASSERT_EQ(slave->set("wind[1]", 2), fmi2OK);
    ASSERT_EQ(slave->set_rate("wind[1]", 1024), fmi2OK);
    ASSERT_EQ(slave->step(kQ, kQ), fmi2OK);
  }
  ASSERT_EQ(twice.set_rate("wind[1]", 0), fmi2OK);
  ASSERT_EQ(once.step(2 * kQ, kQ), fmi2OK);
  ASSERT_EQ(twice.step(2 * kQ, kQ), fmi2OK);
  EXPECT_EQ(once.outputs(), twice.outputs());
}

// Held points are where the pin's motion puts them at the end of the step: X -> p + R (X - p_0).
TEST(Inputs, HeldPointsAreWhereTheyWereSent) {
  Slave slave(flag());
  slave.initialize();
  ASSERT_EQ(slave.set("pin.hand.position[2]", 0.001), fmi2OK);
  ASSERT_EQ(slave.set("pin.pole.position[1]", -0.002), fmi2OK);
  const double half = 0.05;  // rad, half the turn about x
  ASSERT_EQ(slave.set("pin.pole.orientation[1]", 3 * std::cos(half)), fmi2OK);
  ASSERT_EQ(slave.set("pin.pole.orientation[2]", 3 * std::sin(half)), fmi2OK);
  ASSERT_EQ(slave.step(0, 8 * kQ), fmi2OK) << slave.last_message();
  EXPECT_NEAR(slave.get("probe.held.position[1]"), 0.06, 1e-14);
  EXPECT_NEAR(slave.get("probe.held.position[2]"), 0.001, 1e-14);
  EXPECT_NEAR(slave.get("probe.held.position[3]"), 1, 1e-14);
  // The corner is 0.02 m below the pole's middle.
  EXPECT_NEAR(slave.get("probe.corner.position[1]"), -0.002, 1e-14);
  EXPECT_NEAR(slave.get("probe.corner.position[2]"), 0.02 * std::sin(2 * half), 1e-14);
  EXPECT_NEAR(slave.get("probe.corner.position[3]"), 1.02 - 0.02 * std::cos(2 * half), 1e-14);
  EXPECT_NE(slave.get("pin.pole.torque[1]"), 0);
}

void drive(Slave& slave, double wind, double reach) {
  ASSERT_EQ(slave.set("wind[2]", wind), fmi2OK);
  ASSERT_EQ(slave.set("pin.hand.position[2]", reach), fmi2OK);
  ASSERT_EQ(slave.set_rate("pin.pole.velocity[1]", reach), fmi2OK);
}

TEST(Inputs, ASavedStateKeepsThemAndAResetForgetsThem) {
  Slave slave(flag());
  slave.initialize();
  const std::vector<double> start = slave.outputs();
  ASSERT_EQ(slave.step(0, 2 * kQ), fmi2OK);
  const std::vector<double> undriven = slave.outputs();
  drive(slave, 3, 0.002);
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2OK);
  ASSERT_EQ(slave.step(2 * kQ, 2 * kQ), fmi2OK) << slave.last_message();
  const std::vector<double> end = slave.outputs();
  drive(slave, -5, -0.003);
  ASSERT_EQ(slave.step(4 * kQ, 2 * kQ), fmi2OK);
  ASSERT_EQ(fmi2().SetFMUstate(slave.component, state), fmi2OK);
  EXPECT_EQ(slave.get("wind[2]"), 3);
  EXPECT_EQ(slave.get("pin.hand.position[2]"), 0.002);
  EXPECT_EQ(slave.outputs(), undriven);
  ASSERT_EQ(slave.step(2 * kQ, 2 * kQ), fmi2OK);
  EXPECT_EQ(slave.outputs(), end);

  ASSERT_EQ(fmi2().Reset(slave.component), fmi2OK);
  slave.initialize();
  EXPECT_EQ(slave.get("wind[2]"), 0);
  EXPECT_EQ(slave.outputs(), start);
  ASSERT_EQ(slave.step(0, 2 * kQ), fmi2OK);
  EXPECT_EQ(slave.outputs(), undriven);
  EXPECT_EQ(fmi2().FreeFMUstate(slave.component, &state), fmi2OK);
}

}  // namespace
}  // namespace drape::fmi2
