// Derivatives of outputs: the velocity of a position, the slope of everything else.
#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

double derivative(Slave& slave, const std::string& name) {
  const fmi2ValueReference reference = swatch().reference(name);
  const fmi2Integer order = 1;
  double value = kNan;
  EXPECT_EQ(fmi2().GetRealOutputDerivatives(slave.component, &reference, 1, &order, &value), fmi2OK)
      << slave.last_message();
  return value;
}

TEST(Derivatives, OfAPositionIsItsVelocity) {
  Slave slave;
  slave.initialize();
  for (int k = 0; k < 3; ++k) {
    for (const char* index : {"[1]", "[2]", "[3]"})
      EXPECT_EQ(derivative(slave, std::string("probe.hem.position") + index),
                slave.get(std::string("probe.hem.velocity") + index));
    ASSERT_EQ(slave.step(0.01 * k, 0.01), fmi2OK);
  }
}

// Whether or not the outputs were read before the step.
TEST(Derivatives, OfOtherOutputsIsTheSlopeOfTheLastStep) {
  for (const bool reads : {false, true}) {
    SCOPED_TRACE(reads);
    Slave slave;
    slave.initialize();
    const std::string name = "strain.warp.max";
    EXPECT_EQ(derivative(slave, name), 0);  // there is only one point so far
    double before = slave.get(name);
    for (int k = 0; k < 3; ++k) {
      const double length = 0.01 + 0.005 * k, time = 0.01 * k + 0.0025 * k * (k - 1);
      ASSERT_EQ(slave.step(time, length), fmi2OK) << slave.last_message();
      const double now = reads || k == 2 ? slave.get(name) : 0;
      if (reads) {
        EXPECT_EQ(derivative(slave, name), (now - before) / length);
        before = now;
      }
    }
    EXPECT_NE(derivative(slave, name), 0);
  }
}

TEST(Derivatives, OfWhatJumpsIsZero) {
  Slave slave;
  slave.initialize();
  ASSERT_EQ(slave.step(0, 0.01), fmi2OK);
  ASSERT_EQ(slave.step(0.01, 0.01), fmi2OK);
  EXPECT_EQ(derivative(slave, "step.count"), 0);
}

TEST(Derivatives, TravelWithASavedState) {
  Slave slave;
  slave.initialize();
  derivative(slave, "tension.max");
  ASSERT_EQ(slave.step(0, 0.01), fmi2OK);
  ASSERT_EQ(slave.step(0.01, 0.01), fmi2OK);
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2OK);
  const double there = derivative(slave, "tension.max");
  ASSERT_EQ(slave.step(0.02, 0.02), fmi2OK);
  const double later = derivative(slave, "tension.max");
  EXPECT_NE(later, there);
  ASSERT_EQ(fmi2().SetFMUstate(slave.component, state), fmi2OK);
  EXPECT_EQ(derivative(slave, "tension.max"), there);
  ASSERT_EQ(slave.step(0.02, 0.02), fmi2OK);
  EXPECT_EQ(derivative(slave, "tension.max"), later);
}

TEST(Derivatives, BadRequestsAreRefused) {
  Slave slave;
  slave.initialize();
  const auto refuse = [&](fmi2ValueReference reference, fmi2Integer order,
                          const std::vector<std::string>& words) {
    double value = 7;
    EXPECT_EQ(fmi2().GetRealOutputDerivatives(slave.component, &reference, 1, &order, &value), fmi2Discard);
    expect_sentence(slave, fmi2Discard, words);
    EXPECT_EQ(value, 7);
  };
  const fmi2ValueReference tension = swatch().reference("tension.max");
  refuse(0, 1, {"value reference 0", "no Real output"});
  refuse(~0u, 1, {"no Real output"});
  refuse(swatch().reference("damping"), 1, {"damping", "no Real output"});
  refuse(swatch().reference("strain.beyond_test.count"), 1, {"strain.beyond_test.count", "no Real output"});
  for (const fmi2Integer order : {0, 2, -1})
    refuse(tension, order, {"tension.max", std::to_string(order), "allowed: 1"});
  const fmi2Integer order = 1;
  EXPECT_EQ(fmi2().GetRealOutputDerivatives(slave.component, &tension, 1, &order, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fmi2GetRealOutputDerivatives", "missing"});
}

}  // namespace
}  // namespace drape::fmi2
