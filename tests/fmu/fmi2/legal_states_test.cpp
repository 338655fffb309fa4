// Calls in and out of order: each function of FMI 2.0 in each phase, against the table of section 4.2.4 of
// the standard. The table is typed here from the standard, not taken from the code.
#include <functional>

#include "fmi2/slave.h"

namespace drape::fmi2 {
namespace {

// Phases: I instantiated, N initialization mode, S step complete, T terminated, E error.
const std::string kPhases = "INSTE";
const char* const kPhaseNames[] = {"instantiated", "initialization mode", "step complete", "terminated",
                                   "error"};

struct Case {
  const char* name;
  const char* legal;  // phases in which the call is legal
  std::function<fmi2Status(fmi2Component)> call;
};

const fmi2ValueReference kReference = 1;
fmi2Integer integer = 1;
fmi2Boolean boolean = fmi2False;
fmi2String string = "";
double real = 0.3;  // a value that variable 1, the areal density, may take
fmi2Status status;
fmi2EventInfo event_info;
std::size_t size;
std::vector<fmi2Byte> bytes;

// The answer to a call about a new saved state.
template <class Call>
fmi2Status with_state(fmi2Component c, Call call) {
  fmi2FMUstate s = nullptr;
  if (const fmi2Status done = fmi2().GetFMUstate(c, &s); done != fmi2OK) return done;
  const fmi2Status answer = call(s);
  EXPECT_EQ(fmi2().FreeFMUstate(c, &s), fmi2OK);
  return answer;
}

// Fills `bytes`.
fmi2Status serialize(fmi2Component c) {
  return with_state(c, [&](fmi2FMUstate s) {
    EXPECT_EQ(fmi2().SerializedFMUstateSize(c, s, &size), fmi2OK);
    bytes.resize(size);
    return fmi2().SerializeFMUstate(c, s, bytes.data(), bytes.size());
  });
}

const Case kCases[] = {
    {"SetDebugLogging", "INSTE",
     [](fmi2Component c) { return fmi2().SetDebugLogging(c, fmi2True, 0, nullptr); }},
    {"SetupExperiment", "I",
     [](fmi2Component c) { return fmi2().SetupExperiment(c, fmi2False, 0, 0, fmi2False, 0); }},
    {"EnterInitializationMode", "I", [](fmi2Component c) { return fmi2().EnterInitializationMode(c); }},
    {"ExitInitializationMode", "N", [](fmi2Component c) { return fmi2().ExitInitializationMode(c); }},
    {"Terminate", "S", [](fmi2Component c) { return fmi2().Terminate(c); }},
    {"Reset", "INSTE", [](fmi2Component c) { return fmi2().Reset(c); }},
    {"GetReal", "NSTE",
     [](fmi2Component c) {
       double value;
       return fmi2().GetReal(c, &kReference, 1, &value);
     }},
    {"GetInteger", "NSTE", [](fmi2Component c) { return fmi2().GetInteger(c, nullptr, 0, nullptr); }},
    {"GetBoolean", "NSTE", [](fmi2Component c) { return fmi2().GetBoolean(c, nullptr, 0, nullptr); }},
    {"GetString", "NSTE", [](fmi2Component c) { return fmi2().GetString(c, nullptr, 0, nullptr); }},
    {"SetReal", "INS", [](fmi2Component c) { return fmi2().SetReal(c, &kReference, 1, &real); }},
    {"SetInteger", "INS", [](fmi2Component c) { return fmi2().SetInteger(c, nullptr, 0, nullptr); }},
    {"SetBoolean", "INS", [](fmi2Component c) { return fmi2().SetBoolean(c, nullptr, 0, nullptr); }},
    {"SetString", "INS", [](fmi2Component c) { return fmi2().SetString(c, nullptr, 0, nullptr); }},
    {"GetFMUstate", "INSTE",
     [](fmi2Component c) {
       fmi2FMUstate s = nullptr;
       return fmi2().GetFMUstate(c, &s);
     }},
    {"FreeFMUstate", "INSTE",
     [](fmi2Component c) {
       fmi2FMUstate s = nullptr;
       return fmi2().FreeFMUstate(c, &s);
     }},
    {"DoStep", "S", [](fmi2Component c) { return fmi2().DoStep(c, 0.001, 0.001, fmi2True); }},
    {"GetRealStatus", "ST",
     [](fmi2Component c) { return fmi2().GetRealStatus(c, fmi2LastSuccessfulTime, &real); }},
    {"GetBooleanStatus", "ST",
     [](fmi2Component c) { return fmi2().GetBooleanStatus(c, fmi2Terminated, &boolean); }},
    {"SerializedFMUstateSize", "INSTE",
     [](fmi2Component c) {
       return with_state(c, [&](fmi2FMUstate s) { return fmi2().SerializedFMUstateSize(c, s, &size); });
     }},
    {"SerializeFMUstate", "INSTE", [](fmi2Component c) { return serialize(c); }},
    {"DeSerializeFMUstate", "INSTE",
     [](fmi2Component c) {
       if (const fmi2Status done = serialize(c); done != fmi2OK) return done;
       fmi2FMUstate s = nullptr;
       return fmi2().DeSerializeFMUstate(c, bytes.data(), bytes.size(), &s);
     }},
    {"GetDirectionalDerivative", "",
     [](fmi2Component c) {
       return fmi2().GetDirectionalDerivative(c, &kReference, 1, &kReference, 1, &real, &real);
     }},
    {"SetRealInputDerivatives", "INS",
     [](fmi2Component c) { return fmi2().SetRealInputDerivatives(c, nullptr, 0, nullptr, nullptr); }},
    {"GetRealOutputDerivatives", "STE",
     [](fmi2Component c) { return fmi2().GetRealOutputDerivatives(c, nullptr, 0, nullptr, nullptr); }},
    {"CancelStep", "", [](fmi2Component c) { return fmi2().CancelStep(c); }},
    {"EnterEventMode", "", [](fmi2Component c) { return fmi2().EnterEventMode(c); }},
    {"NewDiscreteStates", "", [](fmi2Component c) { return fmi2().NewDiscreteStates(c, &event_info); }},
    {"EnterContinuousTimeMode", "", [](fmi2Component c) { return fmi2().EnterContinuousTimeMode(c); }},
    {"CompletedIntegratorStep", "",
     [](fmi2Component c) { return fmi2().CompletedIntegratorStep(c, fmi2True, &boolean, &boolean); }},
    {"SetTime", "", [](fmi2Component c) { return fmi2().SetTime(c, 0); }},
    {"SetContinuousStates", "", [](fmi2Component c) { return fmi2().SetContinuousStates(c, nullptr, 0); }},
    {"GetDerivatives", "", [](fmi2Component c) { return fmi2().GetDerivatives(c, nullptr, 0); }},
    {"GetEventIndicators", "", [](fmi2Component c) { return fmi2().GetEventIndicators(c, nullptr, 0); }},
    {"GetContinuousStates", "", [](fmi2Component c) { return fmi2().GetContinuousStates(c, nullptr, 0); }},
    {"GetNominalsOfContinuousStates", "",
     [](fmi2Component c) { return fmi2().GetNominalsOfContinuousStates(c, nullptr, 0); }},
};

// Legal or not, these two need an answer of their own: see the tests below.
const Case kSetState = {"SetFMUstate", "INSTE", nullptr};
const Case kAskPending[] = {
    {"GetStatus", "ST", [](fmi2Component c) { return fmi2().GetStatus(c, fmi2DoStepStatus, &status); }},
    {"GetIntegerStatus", "ST",
     [](fmi2Component c) { return fmi2().GetIntegerStatus(c, fmi2DoStepStatus, &integer); }},
    {"GetStringStatus", "ST",
     [](fmi2Component c) { return fmi2().GetStringStatus(c, fmi2PendingStatus, &string); }},
};

// A thousand times its weight stretches the brittle warp beyond 2 % within a step.
void lead_to_error(Slave& slave) {
  EXPECT_EQ(slave.set("gravity[2]", -1e4), fmi2OK);
  EXPECT_EQ(slave.step(0.001, 0.001), fmi2Error);
}

void lead_to(Slave& slave, char phase) {
  ASSERT_NE(slave.component, nullptr) << slave.last_message();
  if (phase == 'N') {
    ASSERT_EQ(fmi2().EnterInitializationMode(slave.component), fmi2OK);
  } else if (phase != 'I') {
    slave.initialize();
    ASSERT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
  }
  if (phase == 'E') lead_to_error(slave);
  if (phase == 'T') {
    ASSERT_EQ(fmi2().Terminate(slave.component), fmi2OK);
  }
  slave.log.clear();
}

// The phase is named in the sentence about a call that is never legal.
std::string phase_of(Slave& slave) {
  EXPECT_EQ(fmi2().CancelStep(slave.component), fmi2Error);
  return slave.last_message();
}

void expect_order(const Case& test, fmi2Status in_order) {
  for (std::size_t i = 0; i < kPhases.size(); ++i) {
    SCOPED_TRACE(std::string(test.name) + " while " + kPhaseNames[i]);
    Slave slave(swatch_brittle());
    lead_to(slave, kPhases[i]);
    const fmi2Status answer = test.call(slave.component);
    if (std::string(test.legal).find(kPhases[i]) != std::string::npos) {
      EXPECT_EQ(answer, in_order) << slave.last_message();
      continue;
    }
    EXPECT_EQ(answer, fmi2Error);
    expect_sentence(slave, fmi2Error, {std::string("fmi2") + test.name, kPhaseNames[i], "expected"});
    EXPECT_NE(phase_of(slave).find(kPhaseNames[i]), std::string::npos) << "the phase has changed";
  }
}

TEST(LegalStates, EveryFunctionInEveryPhase) {
  for (const Case& test : kCases) expect_order(test, fmi2OK);
}

TEST(LegalStates, NothingIsEverPending) {
  for (const Case& test : kAskPending) expect_order(test, fmi2Discard);
}

TEST(LegalStates, ASavedStateCanBeSetInEveryPhase) {
  for (const char phase : kPhases) {
    SCOPED_TRACE(phase);
    Slave slave(swatch_brittle());
    fmi2FMUstate state = nullptr;
    ASSERT_EQ(fmi2().GetFMUstate(slave.component, &state), fmi2OK);
    lead_to(slave, phase);
    EXPECT_EQ(fmi2().SetFMUstate(slave.component, state), fmi2OK) << slave.last_message();
    EXPECT_NE(phase_of(slave).find(kPhaseNames[0]), std::string::npos);
    EXPECT_EQ(fmi2().FreeFMUstate(slave.component, &state), fmi2OK);
    EXPECT_EQ(state, nullptr);
  }
}

TEST(LegalStates, NoComponentIsAnError) {
  for (const Case& test : kCases) EXPECT_EQ(test.call(nullptr), fmi2Error) << test.name;
  fmi2().FreeInstance(nullptr);  // ignored, as the standard requires
}

// The run ends with a reason, and the state is the one before the step.
TEST(LegalStates, AfterAnErrorTheLastGoodStateCanBeRead) {
  Slave slave(swatch_brittle());
  slave.initialize();
  ASSERT_EQ(slave.step(0, 0.001), fmi2OK);
  const double height = slave.get("probe.hem.position[3]"), count = slave.get("step.count");
  lead_to_error(slave);
  EXPECT_FALSE(slave.log.empty());
  EXPECT_EQ(slave.get("probe.hem.position[3]"), height);
  EXPECT_EQ(slave.get("step.count"), count);
  ASSERT_EQ(fmi2().Reset(slave.component), fmi2OK);
  slave.initialize();
  EXPECT_EQ(slave.step(0, 0.001), fmi2OK) << slave.last_message();
}

}  // namespace
}  // namespace drape::fmi2
