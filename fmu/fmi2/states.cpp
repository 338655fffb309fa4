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

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t* size) {
  return gate(c, rule_of("fmi2SerializedFMUstateSize"), [&](Component& k) {
    if (!size) return component_discard(k, "fmi2SerializedFMUstateSize: the place for the size is missing");
    return status_fmi2(
        instance::instance_bytes_size(*k.instance, static_cast<const instance::Saved*>(state), size));
  });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  return gate(c, rule_of("fmi2SerializeFMUstate"), [&](Component& k) {
    if (!bytes) return component_discard(k, "fmi2SerializeFMUstate: the place for the bytes is missing");
    return status_fmi2(instance::instance_write(*k.instance, static_cast<const instance::Saved*>(state),
                                                reinterpret_cast<unsigned char*>(bytes), size));
  });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate* state) {
  return gate(c, rule_of("fmi2DeSerializeFMUstate"), [&](Component& k) {
    if (!bytes || !state)
      return component_discard(k,
                               "fmi2DeSerializeFMUstate: the bytes or the place for the state are missing");
    instance::Saved* read =
        instance::instance_read(*k.instance, reinterpret_cast<const unsigned char*>(bytes), size);
    if (!read) return fmi2Discard;
    *state = read;
    return fmi2OK;
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
