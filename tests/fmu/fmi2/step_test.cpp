// fmi2SetupExperiment and fmi2DoStep: impossible times are refused, and the motion does not depend on how a
// master groups the communication intervals (1 ms in the sample).
#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

// From 1 s, for a tenth of a second.
void initialize_with_stop(Slave& slave) {
  ASSERT_EQ(fmi2().SetupExperiment(slave.component, fmi2True, 1e-6, 1, fmi2True, 1.1), fmi2OK)
      << slave.last_message();
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  ASSERT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK);
}

double last_time(Slave& slave) {
  double time = kNan;
  EXPECT_EQ(fmi2().GetRealStatus(slave.component, fmi2LastSuccessfulTime, &time), fmi2OK);
  return time;
}

TEST(Step, RefusedStepsChangeNothing) {
  struct Case {
    double time, length;
    std::vector<std::string> words;
  };
  const Case cases[] = {
      {1, 0, {"communication step is 0 s", "allowed: above 0 s"}},
      {1, -0.01, {"communication step is -0.01 s", "allowed: above 0 s"}},
      {1, kNan, {"communication step is nan s", "allowed: above 0 s"}},
      {1, kInfinity, {"communication step is inf s", "finite"}},
      {1, 0.2, {"1.2 s", "allowed", "stop time, 1.1 s"}},
      {1.001, 0.01, {"communication point is 1.001 s", "expected", "1 s"}},
      {0, 0.01, {"communication point is 0 s", "expected", "1 s"}},
      {kNan, 0.01, {"communication point is nan s", "expected", "1 s"}},
  };
  Slave slave, untouched;
  initialize_with_stop(slave);
  initialize_with_stop(untouched);
  for (const Case& test : cases) {
    SCOPED_TRACE(test.length);
    EXPECT_EQ(slave.step(test.time, test.length), fmi2Discard);
    expect_sentence(slave, fmi2Discard, test.words);
    EXPECT_EQ(last_time(slave), 1);
    EXPECT_EQ(slave.outputs(), untouched.outputs());
  }
  ASSERT_EQ(slave.step(1, 0.01), fmi2OK) << slave.last_message();
  ASSERT_EQ(untouched.step(1, 0.01), fmi2OK);
  EXPECT_EQ(slave.outputs(), untouched.outputs());
}

// 100 additions of 0.001 do not give 0.1 exactly; both the clock and the stop time must accept the sum.
TEST(Step, AMasterMayAddUpItsOwnClock) {
  Slave slave;
  initialize_with_stop(slave);
  double time = 1;
  for (int i = 0; i < 100; ++i, time += 0.001)
    ASSERT_EQ(slave.step(time, 0.001), fmi2OK) << slave.last_message();
  EXPECT_NEAR(last_time(slave), 1.1, 1e-12);
  EXPECT_EQ(slave.step(time, 0.001), fmi2Discard);
}

// Up to a millionth of a step off is rounding; more is another time.
TEST(Step, AMasterMayRoundItsClock) {
  Slave slave;
  slave.initialize();
  ASSERT_EQ(slave.step(0.9e-9, 0.001), fmi2OK) << slave.last_message();
  EXPECT_EQ(slave.step(0.001 + 1.2e-9, 0.001), fmi2Discard);
}

TEST(Step, RefusesWhatTheClockCannotCount) {
  Slave slave;
  slave.initialize();
  EXPECT_EQ(slave.step(0, 1e-18), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"1e-18 s", "allowed: at least 1e-12 s at this time"});
  EXPECT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
}

TEST(Step, SetupRefusesTimesThatMakeNoSense) {
  Slave slave;
  const auto setup = [&](double start, bool stop_defined, double stop) {
    return fmi2().SetupExperiment(slave.component, fmi2False, 0, start, stop_defined, stop);
  };
  EXPECT_EQ(setup(kNan, false, 0), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"start time is nan s", "allowed"});
  EXPECT_EQ(setup(1, true, 1), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"stop time is 1 s", "allowed: above the start time"});
  EXPECT_EQ(setup(1, true, kNan), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"stop time is nan s", "allowed: above the start time"});
  EXPECT_EQ(setup(-1, false, -5), fmi2OK) << slave.last_message();  // the stop time is not defined
}

TEST(Step, GroupingOfIntervalsLeavesTheSameBits) {
  std::vector<std::vector<double>> ends;
  for (const int steps : {1, 10, 100}) {
    Slave slave;
    slave.initialize();
    for (int i = 0; i < steps; ++i)
      ASSERT_EQ(slave.step(0.1 * i / steps, 0.1 / steps), fmi2OK) << slave.last_message();
    ends.push_back(slave.outputs());
    const std::size_t force =
        swatch().reference("pin.bar.force[1]") - swatch().reference("probe.hem.position[1]");
    for (std::size_t k = force; k < force + 6; ++k)  // and torque
      ends.back()[k] = 0;                            // by definition a mean over the last step
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

// At a late time the clock is as strict as at its start: a tenth of a step is not taken for rounding.
TEST(Step, ALateClockIsAsSharpAsAnEarlyOne) {
  Slave slave;
  ASSERT_EQ(fmi2().SetupExperiment(slave.component, fmi2False, 0, 1e6, fmi2True, 1e6 + 0.01), fmi2OK);
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  ASSERT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK);
  EXPECT_EQ(slave.step(1e6 + 1e-4, 0.001), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"communication point is 1000000.0001 s", "expected", "1e+06 s"});
  EXPECT_EQ(slave.step(1e6, 0.0101), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"allowed: up to the stop time"});
  double time = 1e6;
  for (int i = 0; i < 10; ++i, time += 0.001)
    ASSERT_EQ(slave.step(time, 0.001), fmi2OK) << slave.last_message();
}

// 1e9 intervals at most; the clock stays where it was.
TEST(Step, RefusesMoreIntervalsThanCanBeCounted) {
  Slave slave;
  slave.initialize();
  EXPECT_EQ(slave.step(0, 1e20), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"1e+20 s", "allowed: at most 1e+06 s, 1e+09 communication intervals"});
  EXPECT_EQ(last_time(slave), 0);
  EXPECT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
}

bool terminated(Slave& slave) {
  fmi2Boolean value = fmi2True;
  EXPECT_EQ(fmi2().GetBooleanStatus(slave.component, fmi2Terminated, &value), fmi2OK);
  return value;
}

// The motion has made a given step too large: the slave asks to terminate, because every retry would be
// discarded. A refused value is restored, and the next step succeeds.
TEST(Step, AsksForTheEndOnlyWhereEveryRetryWouldBeDiscarded) {
  const Swatch fixed =
      swatch_with("damping = 0.5\nenergy = true", "damping = 0.5\nenergy = true\nstep = 2e-5");
  Slave slave(fixed);
  slave.initialize();
  EXPECT_FALSE(terminated(slave));
  ASSERT_EQ(slave.set("fabric.wool.warp.force[2]", 1), fmi2OK);
  EXPECT_EQ(slave.step(0, 0.001), fmi2Discard);
  EXPECT_FALSE(terminated(slave));
  ASSERT_EQ(slave.set("fabric.wool.areal_density", 1e-4), fmi2OK);
  EXPECT_EQ(slave.step(0, 0.001), fmi2Discard);
  EXPECT_FALSE(terminated(slave));
  EXPECT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
  ASSERT_EQ(slave.set("fabric.wool.warp.force[3]", 20000), fmi2OK);  // stiff beyond 2 %
  ASSERT_EQ(slave.set("gravity[2]", -1e4), fmi2OK);
  slave.log.clear();
  EXPECT_EQ(slave.step(0.001, 0.01), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"scene.step = 2e-05 s is above the step limit", "set by the"});
  EXPECT_TRUE(terminated(slave));
  EXPECT_EQ(last_time(slave), 0.001);
  EXPECT_EQ(slave.step(0.001, 0.01), fmi2Discard);
  EXPECT_TRUE(terminated(slave));
  ASSERT_EQ(slave.set("gravity[2]", 0), fmi2OK);
  EXPECT_EQ(slave.step(0.001, 0.001), fmi2OK) << slave.last_message();
  EXPECT_FALSE(terminated(slave));
}

}  // namespace
}  // namespace drape::fmi2
