// Values by reference: when each may be set, and that a refused call changes nothing.
#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

TEST(Values, OutOfRange) {
  Slave slave;
  slave.initialize();
  const std::string density = "fabric.wool.areal_density";
  expect_refused(slave, density, kNan, {density, "nan", "allowed: 1e-04 to 100 kg/m2"});
  expect_refused(slave, density, kInfinity, {density, "inf", "allowed: 1e-04 to 100 kg/m2"});
  expect_refused(slave, density, -0.25, {density, "-0.25", "allowed: 1e-04 to 100 kg/m2"});
  expect_refused(slave, density, 0, {density, "is 0 ", "allowed: 1e-04 to 100 kg/m2"});
  expect_refused(slave, "fabric.wool.poisson", 1, {"poisson", "is 1;", "allowed: 0 to 0.999"});
  expect_refused(slave, "fabric.wool.compression", 1.5, {"compression", "1.5", "allowed: 0 to 1"});
  expect_refused(slave, "fabric.wool.bending.warp", -1e-6,
                 {"bending.warp", "-1e-06", "allowed: 0 to 1000 N.m"});
  expect_refused(slave, "fabric.wool.warp.force[2]", -1, {"warp.force[2]", "-1", "allowed: 0 to 1e+06 N"});
  expect_refused(slave, "damping", -1, {"damping", "-1", "allowed: 0 to 1e+06 1/s"});
  expect_refused(slave, "gravity[2]", kNan, {"gravity[2]", "nan", "allowed: -10000 to 10000 m/s2"});
}

TEST(Values, EveryTunableParameterIsTakenAndReadBack) {
  Slave slave;
  slave.initialize();
  for (const std::string& name : swatch().names) {
    if (name == "step.max") break;  // the first that is not tunable
    SCOPED_TRACE(name);
    const double value =
        name.find("compression") != std::string::npos ? 0.5 : slave.get(name) * 1.0625 + 0.001;
    EXPECT_EQ(slave.set(name, value), fmi2OK) << slave.last_message();
    EXPECT_EQ(slave.get(name), value);
  }
  EXPECT_EQ(slave.step(0, 0.001), fmi2Warning) << "damping of 0.001 s along the springs is slow";
  EXPECT_EQ(slave.get("fabric.wool.compression"), 0.5);
}

TEST(Values, OneBadValueRefusesTheWholeCall) {
  Slave slave;
  slave.initialize();
  const fmi2ValueReference references[] = {swatch().reference("damping"),
                                           swatch().reference("fabric.wool.poisson")};
  const double values[] = {3, -1};
  EXPECT_EQ(fmi2().SetReal(slave.component, references, 2, values), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fabric.wool.poisson"});
  EXPECT_EQ(slave.get("damping"), 0.5);
}

TEST(Values, OutputsAndUnknownReferencesCannotBeSet) {
  Slave slave;
  slave.initialize();
  EXPECT_EQ(slave.set("tension.max", 1), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"tension.max", "output"});
  const double value = 1;
  for (const fmi2ValueReference reference : {0u, unsigned(swatch().names.size()) + 1, ~0u}) {
    double read = 0;
    EXPECT_EQ(fmi2().SetReal(slave.component, &reference, 1, &value), fmi2Discard);
    expect_sentence(slave, fmi2Discard, {std::to_string(reference), "allowed: 1 to"});
    EXPECT_EQ(fmi2().GetReal(slave.component, &reference, 1, &read), fmi2Discard);
    expect_sentence(slave, fmi2Discard, {std::to_string(reference), "allowed: 1 to"});
  }
}

TEST(Values, MissingArraysAndOtherTypes) {
  Slave slave;
  slave.initialize();
  const fmi2ValueReference reference = 1;
  EXPECT_EQ(fmi2().GetReal(slave.component, &reference, 1, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fmi2GetReal", "missing"});
  EXPECT_EQ(fmi2().SetReal(slave.component, nullptr, 1, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fmi2SetReal", "missing"});
  fmi2Integer integer = 0;
  EXPECT_EQ(fmi2().GetInteger(slave.component, &reference, 1, &integer), fmi2Discard);
  expect_sentence(slave, fmi2Discard,
                  {"value reference 1", "names no Integer variable; allowed: threads, mode"});
  EXPECT_EQ(fmi2().SetBoolean(slave.component, &reference, 1, &integer), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"value reference 1", "names no Boolean variable; allowed: none"});
  EXPECT_EQ(fmi2().GetInteger(slave.component, &reference, 1, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fmi2GetInteger", "missing"});
  EXPECT_EQ(fmi2().SetInteger(slave.component, nullptr, 1, &integer), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fmi2SetInteger", "missing"});
  EXPECT_EQ(fmi2().SetString(slave.component, &reference, 1, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"value reference 1", "String"});
}

TEST(Values, IntegersAreReadAndSetAsSuch) {
  Slave slave;
  const fmi2ValueReference references[] = {swatch().reference("threads"), swatch().reference("mode")};
  fmi2Integer values[] = {2, 1};
  ASSERT_EQ(fmi2().SetInteger(slave.component, references, 2, values), fmi2OK) << slave.last_message();
  slave.initialize();
  values[0] = values[1] = 0;
  ASSERT_EQ(fmi2().GetInteger(slave.component, references, 2, values), fmi2OK);
  EXPECT_EQ(values[0], 2);
  EXPECT_EQ(values[1], 1);
  EXPECT_EQ(slave.get("threads"), 2) << "as Real, any variable is a number";
  const fmi2ValueReference count = swatch().reference("strain.beyond_test.count");
  EXPECT_EQ(fmi2().GetInteger(slave.component, &count, 1, values), fmi2OK);
  EXPECT_EQ(values[0], 0);
}

TEST(Values, TheModeIsThatOfTheScene) {
  Slave slave;
  const fmi2ValueReference mode = swatch().reference("mode");
  for (const fmi2Integer value : {0, 2, 3, -1}) {
    EXPECT_EQ(fmi2().SetInteger(slave.component, &mode, 1, &value), fmi2Discard);
    expect_sentence(slave, fmi2Discard, {"mode is " + std::to_string(value), "allowed: only 1"});
  }
}

TEST(Values, FixedParametersUntilInitializationEnds) {
  Slave slave;
  ASSERT_EQ(slave.set("step.max", 2e-5), fmi2OK) << slave.last_message();
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  ASSERT_EQ(slave.set("step.max", 1e-5), fmi2OK) << slave.last_message();
  ASSERT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK);
  EXPECT_EQ(slave.set("step.max", 3e-5), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"step.max", "fixed"});
  ASSERT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
  EXPECT_LE(slave.get("step.size"), 1e-5);
}

TEST(Values, ThreadsAreWholeAndFixed) {
  Slave slave;
  for (const double threads : {0.0, 1.5, 65.0}) {
    EXPECT_EQ(slave.set("threads", threads), fmi2Discard);
    expect_sentence(slave, fmi2Discard, {"threads", "a whole number from 1 to 64"});
  }
  ASSERT_EQ(slave.set("threads", 3), fmi2OK) << slave.last_message();
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  ASSERT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK);
  EXPECT_EQ(slave.get("threads"), 3);
  EXPECT_EQ(slave.set("threads", 2), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"threads", "fixed"});
  ASSERT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
}

// The sample's warp diagram is 2, 6, 30 N. Each value alone is in range; together they fall.
TEST(Values, FallingDiagramIsRefusedAtTheEndOfInitialization) {
  Slave slave;
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  ASSERT_EQ(slave.set("fabric.wool.warp.force[2]", 1), fmi2OK);
  EXPECT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fabric.wool.warp", "fall"});
  EXPECT_EQ(slave.get("fabric.wool.warp.force[2]"), 6);
  EXPECT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK) << slave.last_message();
}

TEST(Values, FallingDiagramIsRefusedAtTheStep) {
  Slave slave, untouched;
  slave.initialize();
  untouched.initialize();
  ASSERT_EQ(slave.set("fabric.wool.warp.force[2]", 31), fmi2OK);
  EXPECT_EQ(slave.step(0, 0.001), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"fabric.wool.warp", "fall"});
  EXPECT_EQ(slave.get("fabric.wool.warp.force[2]"), 6);
  EXPECT_EQ(slave.outputs(), untouched.outputs());
  ASSERT_EQ(slave.step(0, 0.01), fmi2OK) << slave.last_message();
  ASSERT_EQ(untouched.step(0, 0.01), fmi2OK);
  EXPECT_EQ(slave.outputs(), untouched.outputs());
}

// r = v_0 t + g t^2/2 at the free end, until the wave from the bar arrives: gravity acts from the step in
// which it is set.
TEST(Values, TunedGravityActs) {
  Slave slave, other;
  slave.initialize();
  other.initialize();
  ASSERT_EQ(other.set("gravity[3]", 0), fmi2OK);
  ASSERT_EQ(slave.step(0, 0.02), fmi2OK);
  ASSERT_EQ(other.step(0, 0.02), fmi2OK);
  EXPECT_LT(slave.get("probe.hem.position[3]"), 1 - 1e-4);
  EXPECT_EQ(other.get("probe.hem.position[3]"), 1);
}

}  // namespace
}  // namespace drape::fmi2
