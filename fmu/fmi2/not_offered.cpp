// FMI 2.0: functions that modelDescription.xml declares absent. They exist for masters that look up every
// name. The rules make each call of them an error with a reason.
#include "fmi2/component.h"

using namespace drape;
using namespace drape::fmi2;

namespace {
fmi2Status not_offered(Component&) { return fmi2Error; }
}  // namespace

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference[], size_t,
                                        const fmi2ValueReference[], size_t, const fmi2Real[], fmi2Real[]) {
  return gate(c, rule_of("fmi2GetDirectionalDerivative"), not_offered);
}
fmi2Status fmi2CancelStep(fmi2Component c) { return gate(c, rule_of("fmi2CancelStep"), not_offered); }

// Model exchange.
fmi2Status fmi2EnterEventMode(fmi2Component c) { return gate(c, rule_of("fmi2EnterEventMode"), not_offered); }
fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo*) {
  return gate(c, rule_of("fmi2NewDiscreteStates"), not_offered);
}
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
  return gate(c, rule_of("fmi2EnterContinuousTimeMode"), not_offered);
}
fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean, fmi2Boolean*, fmi2Boolean*) {
  return gate(c, rule_of("fmi2CompletedIntegratorStep"), not_offered);
}
fmi2Status fmi2SetTime(fmi2Component c, fmi2Real) { return gate(c, rule_of("fmi2SetTime"), not_offered); }
fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real[], size_t) {
  return gate(c, rule_of("fmi2SetContinuousStates"), not_offered);
}
fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real[], size_t) {
  return gate(c, rule_of("fmi2GetDerivatives"), not_offered);
}
fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real[], size_t) {
  return gate(c, rule_of("fmi2GetEventIndicators"), not_offered);
}
fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real[], size_t) {
  return gate(c, rule_of("fmi2GetContinuousStates"), not_offered);
}
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real[], size_t) {
  return gate(c, rule_of("fmi2GetNominalsOfContinuousStates"), not_offered);
}
