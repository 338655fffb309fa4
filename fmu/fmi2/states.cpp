// FMI 2.0: saved states, and the status after a step.
#include <string>

#include "fmi2/component.h"

namespace drape::fmi2 {
namespace {

// fmi2Pending is never returned, so there is no pending step to ask about.
fmi2Status no_status(Component& k, const char* type) {
  return component_discard(k, std::string("there is no ") + type +
                                  " status of this kind; allowed: fmi2LastSuccessfulTime (Real) " +
                                  "and fmi2Terminated (Boolean), as no step is ever pending");
}

}  // namespace
}  // namespace drape::fmi2

using namespace drape;
using namespace drape::fmi2;

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return gate(c, rule_of("fmi2GetFMUstate"), [&](Component& k) {
    if (!state) return component_discard(k, "fmi2GetFMUstate: the place for the state is missing");
    instance::Saved* saved = instance::instance_save(*k.instance, static_cast<instance::Saved*>(*state));
    if (!saved) return fmi2Discard;
    *state = saved;
    return fmi2OK;
  });
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  return gate(c, rule_of("fmi2SetFMUstate"), [&](Component& k) {
    return status_fmi2(instance::instance_restore(*k.instance, static_cast<const instance::Saved*>(state)));
  });
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return gate(c, rule_of("fmi2FreeFMUstate"), [&](Component& k) {
    if (!state || !*state) return fmi2OK;  // the standard: freeing null is ignored
    const drape_status status =
        instance::instance_forget(*k.instance, static_cast<const instance::Saved*>(*state));
    if (status == DRAPE_OK) *state = nullptr;
    return status_fmi2(status);
  });
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
  return gate(c, rule_of("fmi2GetRealStatus"), [&](Component& k) {
    if (kind != fmi2LastSuccessfulTime || !value) return no_status(k, "Real");
    *value = drape_time(k.instance->cloth);
    return fmi2OK;
  });
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* value) {
  return gate(c, rule_of("fmi2GetBooleanStatus"), [&](Component& k) {
    if (kind != fmi2Terminated || !value) return no_status(k, "Boolean");
    *value = drape_step_above_limit(k.instance->cloth)
                 ? fmi2True
                 : fmi2False;  // the same step would be discarded again and again
    return fmi2OK;
  });
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind, fmi2Status*) {
  return gate(c, rule_of("fmi2GetStatus"), [](Component& k) { return no_status(k, "step"); });
}
fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind, fmi2Integer*) {
  return gate(c, rule_of("fmi2GetIntegerStatus"), [](Component& k) { return no_status(k, "Integer"); });
}
fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind, fmi2String*) {
  return gate(c, rule_of("fmi2GetStringStatus"), [](Component& k) { return no_status(k, "String"); });
}
