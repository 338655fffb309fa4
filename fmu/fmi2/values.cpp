// FMI 2.0: values by reference.
#include <string>
#include <vector>

#include "fmi2/component.h"

namespace drape::fmi2 {
namespace {

// There are no variables of type String.
fmi2Status no_string(Component& k, const fmi2ValueReference references[], size_t count) {
  if (count == 0) return fmi2OK;
  return component_discard(
      k, (references ? "value reference " + std::to_string(references[0]) : std::string("the reference")) +
             " names no String variable; allowed: none, as no variable is a String");
}

bool lists_given(size_t count, const void* references, const void* values) {
  return count == 0 || (references && values);
}
fmi2Status no_lists(Component& k, const char* call) {
  return component_discard(k, std::string(call) + ": the list of references or values is missing");
}

// Integers and Booleans, which are both int, through the numbers of the instance.
fmi2Status numbers_get(Component& k, instance::As as, const char* call, const fmi2ValueReference vr[],
                       size_t count, int values[]) {
  if (!lists_given(count, vr, values)) return no_lists(k, call);
  std::vector<double> numbers(count);
  const fmi2Status status = status_fmi2(instance::instance_get(*k.instance, as, vr, count, numbers.data()));
  for (size_t i = 0; i < count && status == fmi2OK; ++i) values[i] = int(numbers[i]);
  return status;
}
fmi2Status numbers_set(Component& k, instance::As as, const char* call, const fmi2ValueReference vr[],
                       size_t count, const int values[]) {
  if (!lists_given(count, vr, values)) return no_lists(k, call);
  const std::vector<double> numbers(values, values + count);
  return status_fmi2(instance::instance_set(*k.instance, as, vr, count, numbers.data()));
}

}  // namespace
}  // namespace drape::fmi2

using namespace drape;
using namespace drape::fmi2;

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[]) {
  return gate(c, rule_of("fmi2GetReal"), [&](Component& k) {
    if (!lists_given(nvr, vr, value)) return no_lists(k, "fmi2GetReal");
    return status_fmi2(instance::instance_get(*k.instance, instance::As::kReal, vr, nvr, value));
  });
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Real value[]) {
  return gate(c, rule_of("fmi2SetReal"), [&](Component& k) {
    if (!lists_given(nvr, vr, value)) return no_lists(k, "fmi2SetReal");
    return status_fmi2(instance::instance_set(*k.instance, instance::As::kReal, vr, nvr, value));
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

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                                        const fmi2Integer order[], fmi2Real value[]) {
  return gate(c, rule_of("fmi2GetRealOutputDerivatives"), [&](Component& k) {
    if (nvr > 0 && (!vr || !order || !value))
      return component_discard(
          k, "fmi2GetRealOutputDerivatives: the list of references, orders or values is missing");
    return status_fmi2(instance::instance_get_derivatives(*k.instance, vr, nvr, order, value));
  });
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Integer value[]) {
  return gate(c, rule_of("fmi2GetInteger"), [&](Component& k) {
    return numbers_get(k, instance::As::kInteger, "fmi2GetInteger", vr, nvr, value);
  });
}
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Boolean value[]) {
  return gate(c, rule_of("fmi2GetBoolean"), [&](Component& k) {
    return numbers_get(k, instance::As::kBoolean, "fmi2GetBoolean", vr, nvr, value);
  });
}
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2String[]) {
  return gate(c, rule_of("fmi2GetString"), [&](Component& k) { return no_string(k, vr, nvr); });
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                          const fmi2Integer value[]) {
  return gate(c, rule_of("fmi2SetInteger"), [&](Component& k) {
    return numbers_set(k, instance::As::kInteger, "fmi2SetInteger", vr, nvr, value);
  });
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr,
                          const fmi2Boolean value[]) {
  return gate(c, rule_of("fmi2SetBoolean"), [&](Component& k) {
    return numbers_set(k, instance::As::kBoolean, "fmi2SetBoolean", vr, nvr, value);
  });
}
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2String[]) {
  return gate(c, rule_of("fmi2SetString"), [&](Component& k) { return no_string(k, vr, nvr); });
}
