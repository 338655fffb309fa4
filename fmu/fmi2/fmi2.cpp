// FMI 2.0 for co-simulation. Each function checks the phase, translates its arguments, and calls the
// instance.
#include <cmath>
#include <memory>
#include <string>

#include "fmi2/component.h"
#include "instance/resource_uri.h"

namespace drape::fmi2 {
namespace {

struct Category {
  const char* name;
  bool instance::LogFilter::* filter;  // null: always logged
};
constexpr Category kCategories[] = {
    // in the order of drape_log_kind
    {"logStatusError", nullptr},
    {"logStatusWarning", &instance::LogFilter::warnings},
    {"logEvents", &instance::LogFilter::events},
    {"logStability", &instance::LogFilter::stability},
};

void log_fmi2(void* user, drape_status status, drape_log_kind kind, const std::string& message) {
  const fmi2Status fmi_status = kind == DRAPE_LOG_ERROR     ? status_fmi2(status)
                                : kind == DRAPE_LOG_WARNING ? fmi2Warning
                                                            : fmi2OK;
  component_log(*static_cast<Component*>(user), fmi_status, kCategories[kind].name, message);
}

instance::LogFilter filter_of(bool logging_on) {
  return {.warnings = true, .events = logging_on, .stability = logging_on};
}

fmi2Component instantiate(std::unique_ptr<Component> k, fmi2Type type, fmi2String guid, fmi2String location,
                          fmi2Boolean logging_on) {
  const auto refuse = [&](const std::string& sentence) {
    component_log(*k, fmi2Error, "logStatusError", sentence);
    return nullptr;
  };
  if (k->name.empty()) return refuse("the instance has no name; allowed: any name that is not empty");
  if (type != fmi2CoSimulation) return refuse("the FMU type is not co-simulation; allowed: fmi2CoSimulation");
  if (!guid) return refuse("the guid is missing; expected: the one of modelDescription.xml");
  if (!location)
    return refuse("the resource location is missing; expected: the URI of the FMU's resources folder");
  std::string problem;
  const std::string folder = instance::resource_path(location, problem);
  if (!problem.empty()) return refuse(problem);
  k->instance =
      instance::instance_open(folder + "/scene.toml", guid, filter_of(logging_on), log_fmi2, k.get());
  return k->instance ? k.release() : nullptr;
}

fmi2Status set_logging(Component& k, bool on, size_t count, const fmi2String names[]) {
  if (count > 0 && !names) return component_discard(k, "the list of log categories is missing");
  instance::LogFilter filter = count == 0 ? filter_of(on) : k.instance->filter;
  if (count > 0 && on) filter = {.warnings = false, .events = false, .stability = false};
  for (size_t i = 0; i < count; ++i) {
    const std::string name = names[i] ? names[i] : "";
    const Category* known = nullptr;
    for (const Category& category : kCategories)
      if (name == category.name) known = &category;
    if (!known)
      return component_discard(k,
                               "the log category is '" + name +
                                   "'; allowed: logStatusError, logStatusWarning, logEvents, logStability");
    if (known->filter) filter.*known->filter = on;
  }
  k.instance->filter = filter;
  return fmi2OK;
}

// The status of what was done as asked, with a warning where a value may surprise.
fmi2Status done(const Component& k, drape_status status) {
  return status == DRAPE_OK && k.instance->surprised ? fmi2Warning : status_fmi2(status);
}

}  // namespace
}  // namespace drape::fmi2

using namespace drape;
using namespace drape::fmi2;

const char* fmi2GetTypesPlatform() { return fmi2TypesPlatform; }
const char* fmi2GetVersion() { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String location,
                              const fmi2CallbackFunctions* functions, fmi2Boolean /*visible*/,
                              fmi2Boolean logging_on) {
  if (!functions) return nullptr;
  const math::PlainEnvironment plain;
  try {
    auto k = std::make_unique<Component>();
    k->name = name ? name : "";
    k->callbacks = *functions;
    return instantiate(std::move(k), type, guid, location, logging_on);
  } catch (const std::exception& e) {
    if (functions->logger)
      functions->logger(functions->componentEnvironment, name, fmi2Error, "logStatusError",
                        "fmi2Instantiate failed: %s", e.what());
    return nullptr;
  }
}

void fmi2FreeInstance(fmi2Component c) {
  if (!c) return;
  Component* k = static_cast<Component*>(c);
  instance::instance_close(k->instance);
  delete k;
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]) {
  return gate(c, rule_of("fmi2SetDebugLogging"),
              [&](Component& k) { return set_logging(k, on, count, categories); });
}

// The tolerance is for integrators with error control; here the step limit sets the step.
fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean /*tolerance_defined*/, fmi2Real /*tolerance*/,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  return gate(c, rule_of("fmi2SetupExperiment"), [&](Component& k) {
    return status_fmi2(instance::instance_setup(*k.instance, start, stop_defined ? stop : INFINITY));
  });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  return gate(c, rule_of("fmi2EnterInitializationMode"), [](Component& k) {
    k.instance->phase = instance::Phase::kInitialization;
    return fmi2OK;
  });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  return gate(c, rule_of("fmi2ExitInitializationMode"),
              [](Component& k) { return done(k, instance::instance_exit_initialization(*k.instance)); });
}

fmi2Status fmi2Terminate(fmi2Component c) {
  return gate(c, rule_of("fmi2Terminate"), [](Component& k) {
    instance::instance_terminate(*k.instance);
    return fmi2OK;
  });
}

fmi2Status fmi2Reset(fmi2Component c) {
  return gate(c, rule_of("fmi2Reset"), [](Component& k) {
    instance::instance_reset(*k.instance);
    return fmi2OK;
  });
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real length, fmi2Boolean /*no_state_set_before*/) {
  return gate(c, rule_of("fmi2DoStep"),
              [&](Component& k) { return done(k, instance::instance_step(*k.instance, time, length)); });
}
