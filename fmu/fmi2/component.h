// The object behind an fmi2Component, and the check that every call passes through.
#pragma once
#include <exception>
#include <string>

#include "fmi2/legal_states.h"
#include "fmi2Functions.h"
#include "instance/instance.h"
#include "math/plain_environment.h"

namespace drape::fmi2 {

struct Component {
  instance::Instance* instance = nullptr;
  std::string name;
  fmi2CallbackFunctions callbacks{};
};

fmi2Status status_fmi2(drape_status status);

// Sends a message to the master.
void component_log(const Component& component, fmi2Status status, const char* category,
                   const std::string& message);

// Logs the sentence and returns fmi2Discard.
fmi2Status component_discard(Component& component, const std::string& sentence);

// Logs that the call is not legal in the instance's phase, with that phase. Returns fmi2Error.
fmi2Status component_illegal(Component& component, const Rule& rule);

// Runs `body(component)` if the rule allows it now. A call out of order changes nothing.
template <class Body>
fmi2Status gate(fmi2Component c, const Rule& rule, Body body) {
  if (!c) return fmi2Error;
  const math::PlainEnvironment plain;
  Component& component = *static_cast<Component*>(c);
  if (!(rule.legal & phases(component.instance->phase))) return component_illegal(component, rule);
  try {
    return body(component);
  } catch (const std::exception& e) {
    component.instance->phase = instance::Phase::kError;
    component_log(component, fmi2Error, "logStatusError", std::string(rule.call) + " failed: " + e.what());
    return fmi2Error;
  }
}

}  // namespace drape::fmi2
