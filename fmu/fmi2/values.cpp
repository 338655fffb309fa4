// FMI 2.0: values by reference.
#include <string>

#include "fmi2/component.h"

namespace drape::fmi2 {
namespace {

// Integer, Boolean and String: there are no variables of these types.
fmi2Status no_variable(Component& k, const fmi2ValueReference references[], size_t count, const char* type) {
  if (count == 0) return fmi2OK;
  return component_discard(
      k, (references ? "value reference " + std::to_string(references[0]) : std::string("the reference")) +
             " names no " + type + " variable; allowed: none, as all variables are Real");
}

}  // namespace
}  // namespace drape::fmi2

using namespace drape;
using namespace drape::fmi2;

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[]) {
  return gate(c, rule_of("fmi2GetReal"), [&](Component& k) {
    if (nvr > 0 && (!vr || !value))
      return component_discard(k, "fmi2GetReal: the list of references or values is missing");
    return status_fmi2(instance::instance_get(*k.instance, vr, nvr, value));
  });
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Real value[]) {
  return gate(c, rule_of("fmi2SetReal"), [&](Component& k) {
    if (nvr > 0 && (!vr || !value))
      return component_discard(k, "fmi2SetReal: the list of references or values is missing");
    return status_fmi2(instance::instance_set(*k.instance, vr, nvr, value));
  });
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  return gate(c, rule_of("fmi2SetRealInputDerivatives"), [&](Component& k) {
    if (nvr > 0 && (!vr || !order || !value))
      return component_discard(
          k, "fmi2SetRealInputDerivatives: the list of references, orders or values is missing");
    return status_fmi2(instance::instance_set_rates(*k.instance, vr, nvr, order, value));
  });
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Integer[]) {
  return gate(c, rule_of("fmi2GetInteger"), [&](Component& k) { return no_variable(k, vr, nvr, "Integer"); });
}
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Boolean[]) {
  return gate(c, rule_of("fmi2GetBoolean"), [&](Component& k) { return no_variable(k, vr, nvr, "Boolean"); });
}
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2String[]) {
  return gate(c, rule_of("fmi2GetString"), [&](Component& k) { return no_variable(k, vr, nvr, "String"); });
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer[]) {
  return gate(c, rule_of("fmi2SetInteger"), [&](Component& k) { return no_variable(k, vr, nvr, "Integer"); });
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Boolean[]) {
  return gate(c, rule_of("fmi2SetBoolean"), [&](Component& k) { return no_variable(k, vr, nvr, "Boolean"); });
}
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2String[]) {
  return gate(c, rule_of("fmi2SetString"), [&](Component& k) { return no_variable(k, vr, nvr, "String"); });
}
