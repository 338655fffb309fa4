#include "fmi2/component.h"

namespace drape::fmi2 {

fmi2Status status_fmi2(drape_status status) {
  switch (status) {
    case DRAPE_OK:
      return fmi2OK;
    case DRAPE_DISCARD:
      return fmi2Discard;
    case DRAPE_ERROR:
      return fmi2Error;
  }
  return fmi2Error;
}

void component_log(const Component& component, fmi2Status status, const char* category,
                   const std::string& message) {
  if (!component.callbacks.logger) return;
  std::string format;  // the logger takes a printf format
  for (const char c : message) format += c == '%' ? "%%" : std::string(1, c);
  component.callbacks.logger(component.callbacks.componentEnvironment, component.name.c_str(), status,
                             category, format.c_str());
}

fmi2Status component_discard(Component& component, const std::string& sentence) {
  return status_fmi2(instance::instance_refuse(*component.instance, DRAPE_DISCARD, sentence));
}

fmi2Status component_illegal(Component& component, const Rule& rule) {
  std::string message = std::string(rule.call) + " is not legal in the phase '" +
                        kPhaseNames[unsigned(component.instance->phase)] + "'; ";
  if (rule.legal == 0) {
    message += "expected: never, as " + std::string(rule.absence);
  } else {
    const char* separator = "expected: '";
    for (unsigned phase = 0; phase < std::size(kPhaseNames); ++phase)
      if (rule.legal & 1u << phase)
        message += std::string(separator) + kPhaseNames[phase], separator = "', '";
    message += '\'';
  }
  component_log(component, fmi2Error, "logStatusError", message);
  return fmi2Error;
}

}  // namespace drape::fmi2
