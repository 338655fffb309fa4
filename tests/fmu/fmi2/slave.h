// The FMU's binary as a master sees it: functions found by name in the loaded library, a log, an instance
// that is freed automatically.
#pragma once
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "fmi2Functions.h"
#include "variables.h"

namespace drape::fmi2 {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                 kInfinity = std::numeric_limits<double>::infinity();

// Every function of FMI 2.0, by its own name.
struct Fmi2 {
  fmi2GetTypesPlatformTYPE* GetTypesPlatform;
  fmi2GetVersionTYPE* GetVersion;
  fmi2SetDebugLoggingTYPE* SetDebugLogging;
  fmi2InstantiateTYPE* Instantiate;
  fmi2FreeInstanceTYPE* FreeInstance;
  fmi2SetupExperimentTYPE* SetupExperiment;
  fmi2EnterInitializationModeTYPE* EnterInitializationMode;
  fmi2ExitInitializationModeTYPE* ExitInitializationMode;
  fmi2TerminateTYPE* Terminate;
  fmi2ResetTYPE* Reset;
  fmi2GetRealTYPE* GetReal;
  fmi2GetIntegerTYPE* GetInteger;
  fmi2GetBooleanTYPE* GetBoolean;
  fmi2GetStringTYPE* GetString;
  fmi2SetRealTYPE* SetReal;
  fmi2SetIntegerTYPE* SetInteger;
  fmi2SetBooleanTYPE* SetBoolean;
  fmi2SetStringTYPE* SetString;
  fmi2GetFMUstateTYPE* GetFMUstate;
  fmi2SetFMUstateTYPE* SetFMUstate;
  fmi2FreeFMUstateTYPE* FreeFMUstate;
  fmi2SerializedFMUstateSizeTYPE* SerializedFMUstateSize;
  fmi2SerializeFMUstateTYPE* SerializeFMUstate;
  fmi2DeSerializeFMUstateTYPE* DeSerializeFMUstate;
  fmi2GetDirectionalDerivativeTYPE* GetDirectionalDerivative;
  fmi2SetRealInputDerivativesTYPE* SetRealInputDerivatives;
  fmi2GetRealOutputDerivativesTYPE* GetRealOutputDerivatives;
  fmi2DoStepTYPE* DoStep;
  fmi2CancelStepTYPE* CancelStep;
  fmi2GetStatusTYPE* GetStatus;
  fmi2GetRealStatusTYPE* GetRealStatus;
  fmi2GetIntegerStatusTYPE* GetIntegerStatus;
  fmi2GetBooleanStatusTYPE* GetBooleanStatus;
  fmi2GetStringStatusTYPE* GetStringStatus;
  fmi2EnterEventModeTYPE* EnterEventMode;
  fmi2NewDiscreteStatesTYPE* NewDiscreteStates;
  fmi2EnterContinuousTimeModeTYPE* EnterContinuousTimeMode;
  fmi2CompletedIntegratorStepTYPE* CompletedIntegratorStep;
  fmi2SetTimeTYPE* SetTime;
  fmi2SetContinuousStatesTYPE* SetContinuousStates;
  fmi2GetDerivativesTYPE* GetDerivatives;
  fmi2GetEventIndicatorsTYPE* GetEventIndicators;
  fmi2GetContinuousStatesTYPE* GetContinuousStates;
  fmi2GetNominalsOfContinuousStatesTYPE* GetNominalsOfContinuousStates;
};
const Fmi2& fmi2();

struct LogEntry {
  fmi2Status status;
  std::string category, message;
};

// The sample cloth: its guid, the names of its table, and a folder with its resources.
struct Swatch {
  std::string guid, resources;  // resources as a file: URI
  std::vector<std::string> names;

  fmi2ValueReference reference(const std::string& name) const;
};
const Swatch& swatch(description::Nodes nodes = description::Nodes::kNone);

// The sample with inputs: a driven clamp, a driven point and wind.
const Swatch& flag();

// The sample with another text in place of one of its own. The variables must stay the same.
Swatch swatch_with(const std::string& from, const std::string& to);

// The sample with a warp that yields up to 2 % and hardly beyond: no step is short enough there.
const Swatch& swatch_brittle();

struct Slave {
  std::vector<LogEntry> log;
  fmi2CallbackFunctions callbacks{};
  fmi2Component component = nullptr;
  const Swatch* cloth;  // the cloth whose names are used

  explicit Slave(const Swatch& of = swatch(), bool logging_on = false);
  Slave(const std::string& guid, const std::string& resources);
  ~Slave();
  Slave(const Slave&) = delete;
  Slave& operator=(const Slave&) = delete;

  void initialize() const;  // from instantiated to step complete; no stop time
  fmi2Status step(double time, double length) const {
    return fmi2().DoStep(component, time, length, fmi2True);
  }
  fmi2Status set(const std::string& name, double value) const;
  double get(const std::string& name) const;
  fmi2Status set_rate(const std::string& name, double value, fmi2Integer order = 1) const;
  std::vector<double> outputs() const;  // all of them
  std::string last_message() const { return log.empty() ? "" : log.back().message; }
};

// Expects that a refused call leaves one sentence, which contains these words.
void expect_sentence(Slave& slave, fmi2Status status, const std::vector<std::string>& words);

// Expects that the value is refused with such a sentence, and that the variable keeps its value.
void expect_refused(Slave& slave, const std::string& name, double value,
                    const std::vector<std::string>& words);

}  // namespace drape::fmi2
