// Saved states, reset, several instances: the same bits each time.
#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

void advance(Slave& slave, double from, double to) {
  ASSERT_EQ(slave.step(from, to - from), fmi2OK) << slave.last_message();
}

TEST(States, ARestoredStateContinuesWithTheSameBits) {
  Slave slave;
  slave.initialize();
  advance(slave, 0, 0.05);
  ASSERT_EQ(slave.set("fabric.wool.bending.warp", 2e-6),
            fmi2OK);  // not yet committed: a saved state contains it too
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2OK);
  const std::vector<double> there = slave.outputs();
  advance(slave, 0.05, 0.1);
  const std::vector<double> first = slave.outputs();
  EXPECT_NE(first, there);

  ASSERT_EQ(slave.set("fabric.wool.bending.warp", 5e-5), fmi2OK);
  ASSERT_EQ(slave.set("damping", 20), fmi2OK);
  advance(slave, 0.1, 0.15);
  ASSERT_EQ(fmi2().SetFMUstate(slave.component, state), fmi2OK) << slave.last_message();
  EXPECT_EQ(slave.get("fabric.wool.bending.warp"), 2e-6);
  EXPECT_EQ(slave.get("damping"), 0.5);
  EXPECT_EQ(slave.outputs(), there);
  advance(slave, 0.05, 0.1);
  EXPECT_EQ(slave.outputs(), first);
  EXPECT_EQ(fmi2().FreeFMUstate(slave.component, &state), fmi2OK);
}

TEST(States, AStateCanBeOverwrittenAndOutliveAReset) {
  Slave slave;
  slave.initialize();
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2OK);
  advance(slave, 0, 0.03);
  fmi2FMUstate same = state;
  ASSERT_EQ(fmi2().GetFMUstate(slave.component, &same), fmi2OK);
  EXPECT_EQ(same, state);
  const std::vector<double> there = slave.outputs();
  ASSERT_EQ(fmi2().Reset(slave.component), fmi2OK);
  ASSERT_EQ(fmi2().SetFMUstate(slave.component, state), fmi2OK) << slave.last_message();
  EXPECT_EQ(slave.outputs(), there);
  advance(slave, 0.03, 0.04);
}

TEST(States, StatesOfOthersAreRefused) {
  Slave slave, other;
  slave.initialize();
  other.initialize();
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().GetFMUstate(other.component, &state), fmi2OK);
  EXPECT_EQ(fmi2().SetFMUstate(slave.component, state), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  EXPECT_EQ(fmi2().SetFMUstate(slave.component, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  EXPECT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  EXPECT_EQ(fmi2().FreeFMUstate(slave.component, &state), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  EXPECT_EQ(fmi2().GetFMUstate(slave.component, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"missing"});
}

std::vector<fmi2Byte> bytes_of(Slave& slave) {
  fmi2FMUstate state = nullptr;
  std::size_t size = 0;
  EXPECT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2OK);
  EXPECT_EQ(fmi2().SerializedFMUstateSize(slave.component, state, &size), fmi2OK);
  std::vector<fmi2Byte> bytes(size);
  EXPECT_EQ(fmi2().SerializeFMUstate(slave.component, state, bytes.data(), size), fmi2OK);
  EXPECT_EQ(fmi2().FreeFMUstate(slave.component, &state), fmi2OK);
  return bytes;
}

TEST(States, BytesContinueInAnotherInstance) {
  Slave slave, other;
  slave.initialize();
  advance(slave, 0, 0.05);
  ASSERT_EQ(slave.set("parameter_ramp", 0.02), fmi2OK);
  ASSERT_EQ(slave.set("damping", 7), fmi2OK);
  advance(slave, 0.05, 0.06);  // within the ramp
  const std::vector<double> there = slave.outputs();
  const std::vector<fmi2Byte> bytes = bytes_of(slave);
  advance(slave, 0.06, 0.1);
  fmi2FMUstate state = nullptr;  // the other has not even been initialized
  ASSERT_EQ(fmi2().DeSerializeFMUstate(other.component, bytes.data(), bytes.size(), &state), fmi2OK)
      << other.last_message();
  ASSERT_EQ(fmi2().SetFMUstate(other.component, state), fmi2OK);
  EXPECT_EQ(other.outputs(), there);
  EXPECT_EQ(bytes_of(other), bytes);
  EXPECT_EQ(other.step(0.05, 0.01), fmi2Discard) << "its clock is at 0.06 s";
  advance(other, 0.06, 0.1);
  EXPECT_EQ(other.outputs(), slave.outputs());
  EXPECT_EQ(other.get("damping"), 7);
  EXPECT_EQ(fmi2().FreeFMUstate(other.component, &state), fmi2OK);
}

TEST(States, TheStopTimeTravels) {
  Slave slave, other;
  ASSERT_EQ(fmi2().SetupExperiment(slave.component, fmi2False, 0, 0, fmi2True, 0.02), fmi2OK);
  ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  ASSERT_EQ(fmi2().ExitInitializationMode(slave.component), fmi2OK);
  const std::vector<fmi2Byte> bytes = bytes_of(slave);
  other.initialize();  // without one
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().DeSerializeFMUstate(other.component, bytes.data(), bytes.size(), &state), fmi2OK);
  ASSERT_EQ(fmi2().SetFMUstate(other.component, state), fmi2OK);
  EXPECT_EQ(other.step(0, 0.03), fmi2Discard);
  expect_sentence(other, fmi2Discard, {"up to the stop time, 0.02 s"});
  advance(other, 0, 0.02);
  EXPECT_EQ(fmi2().FreeFMUstate(other.component, &state), fmi2OK);
}

TEST(States, DamagedBytesAreRefused) {
  Slave slave;
  slave.initialize();
  advance(slave, 0, 0.02);
  std::vector<fmi2Byte> bytes = bytes_of(slave);
  const std::vector<double> there = slave.outputs();
  fmi2FMUstate state = nullptr;
  const auto read = [&](std::size_t size) {
    return fmi2().DeSerializeFMUstate(slave.component, bytes.data(), size, &state);
  };
  EXPECT_EQ(read(bytes.size() - 1), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"bytes; expected:"});
  EXPECT_EQ(read(0), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"0 bytes; expected: at least"});
  for (const std::size_t at :
       {std::size_t(0), std::size_t(9), std::size_t(33), bytes.size() / 2, bytes.size() - 1}) {
    bytes[at] = fmi2Byte(bytes[at] ^ 1);
    EXPECT_EQ(read(bytes.size()), fmi2Discard) << at;
    expect_sentence(slave, fmi2Discard, {"saved state"});
    bytes[at] = fmi2Byte(bytes[at] ^ 1);
  }
  EXPECT_EQ(state, nullptr);
  EXPECT_EQ(slave.outputs(), there);
  EXPECT_EQ(read(bytes.size()), fmi2OK);
}

TEST(States, MissingPlacesForBytesAreRefused) {
  Slave slave, other;
  slave.initialize();
  other.initialize();
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2().GetFMUstate(other.component, &state), fmi2OK);
  std::size_t size = 0;
  std::vector<fmi2Byte> bytes(100);
  EXPECT_EQ(fmi2().SerializedFMUstateSize(slave.component, state, &size), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  EXPECT_EQ(fmi2().SerializeFMUstate(slave.component, state, bytes.data(), 100), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  EXPECT_EQ(fmi2().SerializedFMUstateSize(slave.component, nullptr, &size), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"none of this instance's"});
  ASSERT_EQ(fmi2().GetFMUstate(slave.component, &(state = nullptr)), fmi2OK);
  EXPECT_EQ(fmi2().SerializedFMUstateSize(slave.component, state, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"place for the size"});
  EXPECT_EQ(fmi2().SerializeFMUstate(slave.component, state, nullptr, 100), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"place for the bytes"});
  EXPECT_EQ(fmi2().SerializeFMUstate(slave.component, state, bytes.data(), 100), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"has 100 bytes; allowed: at least its size"});
  EXPECT_EQ(fmi2().DeSerializeFMUstate(slave.component, nullptr, 100, &state), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"are missing"});
  EXPECT_EQ(fmi2().DeSerializeFMUstate(slave.component, bytes.data(), 100, nullptr), fmi2Discard);
  expect_sentence(slave, fmi2Discard, {"are missing"});
}

TEST(States, ResetStartsAgain) {
  Slave slave;
  slave.initialize();
  const std::vector<double> start = slave.outputs();
  advance(slave, 0, 0.05);
  const std::vector<double> first = slave.outputs();
  ASSERT_EQ(slave.set("gravity[3]", -1.62), fmi2OK);
  advance(slave, 0.05, 0.06);
  ASSERT_EQ(fmi2().Terminate(slave.component), fmi2OK);
  ASSERT_EQ(fmi2().Reset(slave.component), fmi2OK);
  slave.initialize();
  EXPECT_EQ(slave.get("gravity[3]"), -9.81);
  EXPECT_EQ(slave.outputs(), start);
  advance(slave, 0, 0.05);
  EXPECT_EQ(slave.outputs(), first);
}

TEST(States, TwoInstancesAtOnceDoNotMeet) {
  Slave alone;
  alone.initialize();
  for (int i = 0; i < 5; ++i) advance(alone, 0.01 * i, 0.01 * (i + 1));
  Slave one, two;
  one.initialize();
  two.initialize();
  ASSERT_EQ(two.set("gravity[3]", 5), fmi2OK);
  for (int i = 0; i < 5; ++i) {
    advance(one, 0.01 * i, 0.01 * (i + 1));
    advance(two, 0.01 * i, 0.01 * (i + 1));
  }
  EXPECT_EQ(one.outputs(), alone.outputs());
  EXPECT_GT(two.get("probe.hem.position[3]"), 1);
  EXPECT_EQ(one.get("gravity[3]"), -9.81);
}

}  // namespace
}  // namespace drape::fmi2
