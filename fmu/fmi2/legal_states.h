// The phases in which each function of FMI 2.0 may be called, as data (section 4.2.4 of the standard,
// co-simulation). A refused step leaves the instance as it was, so "step failed" and "step canceled" are not
// phases of their own.
#pragma once
#include <string_view>

#include "instance/instance.h"

namespace drape::fmi2 {

constexpr unsigned phases() { return 0; }
template <class... Rest>
constexpr unsigned phases(instance::Phase phase, Rest... rest) {
  return 1u << unsigned(phase) | phases(rest...);
}

inline constexpr const char* kPhaseNames[] = {"instantiated", "initialization mode", "step complete",
                                              "terminated", "error"};

inline constexpr unsigned kInstantiated = phases(instance::Phase::kInstantiated);
inline constexpr unsigned kInitialization = phases(instance::Phase::kInitialization);
inline constexpr unsigned kStepComplete = phases(instance::Phase::kStepComplete);
inline constexpr unsigned kTerminated = phases(instance::Phase::kTerminated);
inline constexpr unsigned kError = phases(instance::Phase::kError);
inline constexpr unsigned kSettable = kInstantiated | kInitialization | kStepComplete;
inline constexpr unsigned kReadable = kInitialization | kStepComplete | kTerminated | kError;
inline constexpr unsigned kAlways = kInstantiated | kReadable;

struct Rule {
  std::string_view call;
  unsigned legal;            // a bit per phase
  std::string_view absence;  // for a function legal in no phase: what modelDescription.xml states about it
};

inline constexpr Rule kRules[] = {
    {"fmi2SetDebugLogging", kAlways, ""},
    {"fmi2SetupExperiment", kInstantiated, ""},
    {"fmi2EnterInitializationMode", kInstantiated, ""},
    {"fmi2ExitInitializationMode", kInitialization, ""},
    {"fmi2Terminate", kStepComplete, ""},
    {"fmi2Reset", kAlways, ""},
    {"fmi2GetReal", kReadable, ""},
    {"fmi2GetInteger", kReadable, ""},
    {"fmi2GetBoolean", kReadable, ""},
    {"fmi2GetString", kReadable, ""},
    {"fmi2SetReal", kSettable, ""},
    {"fmi2SetInteger", kSettable, ""},
    {"fmi2SetBoolean", kSettable, ""},
    {"fmi2SetString", kSettable, ""},
    {"fmi2SetRealInputDerivatives", kSettable, ""},
    {"fmi2GetRealOutputDerivatives", kStepComplete | kTerminated | kError, ""},
    {"fmi2GetFMUstate", kAlways, ""},
    {"fmi2SetFMUstate", kAlways, ""},
    {"fmi2FreeFMUstate", kAlways, ""},
    {"fmi2SerializedFMUstateSize", kAlways, ""},
    {"fmi2SerializeFMUstate", kAlways, ""},
    {"fmi2DeSerializeFMUstate", kAlways, ""},
    {"fmi2DoStep", kStepComplete, ""},
    {"fmi2GetStatus", kStepComplete | kTerminated, ""},
    {"fmi2GetRealStatus", kStepComplete | kTerminated, ""},
    {"fmi2GetIntegerStatus", kStepComplete | kTerminated, ""},
    {"fmi2GetBooleanStatus", kStepComplete | kTerminated, ""},
    {"fmi2GetStringStatus", kStepComplete | kTerminated, ""},
    {"fmi2GetDirectionalDerivative", 0, "providesDirectionalDerivative is false"},
    {"fmi2CancelStep", 0, "canRunAsynchronuously is false"},
    {"fmi2EnterEventMode", 0, "there is no model exchange"},
    {"fmi2NewDiscreteStates", 0, "there is no model exchange"},
    {"fmi2EnterContinuousTimeMode", 0, "there is no model exchange"},
    {"fmi2CompletedIntegratorStep", 0, "there is no model exchange"},
    {"fmi2SetTime", 0, "there is no model exchange"},
    {"fmi2SetContinuousStates", 0, "there is no model exchange"},
    {"fmi2GetDerivatives", 0, "there is no model exchange"},
    {"fmi2GetEventIndicators", 0, "there is no model exchange"},
    {"fmi2GetContinuousStates", 0, "there is no model exchange"},
    {"fmi2GetNominalsOfContinuousStates", 0, "there is no model exchange"},
};

// Fails to compile for a call that has no rule.
consteval const Rule& rule_of(std::string_view call) {
  for (const Rule& rule : kRules)
    if (rule.call == call) return rule;
  // NOLINTNEXTLINE(bugprone-std-exception-baseclass): never thrown, only read by the compiler
  throw "no rule for this call";
}

}  // namespace drape::fmi2
