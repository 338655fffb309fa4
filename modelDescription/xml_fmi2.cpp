#include <algorithm>
#include <cmath>
#include <iterator>
#include <pugixml.hpp>
#include <sstream>
#include <utility>

#include "decimal.h"
#include "description.h"
#include "units.h"

namespace drape::description {
namespace {

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

const char* text_of(Causality causality) {
  return causality == Causality::kParameter ? "parameter"
         : causality == Causality::kInput   ? "input"
                                            : "output";
}

const char* text_of(Variability variability) {
  switch (variability) {
    case Variability::kFixed:
      return "fixed";
    case Variability::kTunable:
      return "tunable";
    case Variability::kDiscrete:
      return "discrete";
    case Variability::kContinuous:
      return "continuous";
  }
  return "";
}

// The capabilities of the FMU. A flag becomes true together with the test that shows it.
void print_capabilities(pugi::xml_node root, const Description& d) {
  pugi::xml_node node = root.append_child("CoSimulation");
  set(node, "modelIdentifier", d.identifier);
  for (const auto& [flag, value] : {std::pair{"needsExecutionTool", "false"},
                                    {"canHandleVariableCommunicationStepSize", "true"},
                                    {"canInterpolateInputs", "true"},
                                    {"maxOutputDerivativeOrder", "0"},
                                    {"canRunAsynchronuously", "false"},  // the standard's own spelling
                                    {"canBeInstantiatedOnlyOncePerProcess", "false"},
                                    {"canNotUseMemoryManagementFunctions", "true"},
                                    {"canGetAndSetFMUstate", "true"},
                                    {"canSerializeFMUstate", "true"},
                                    {"providesDirectionalDerivative", "false"}})
    set(node, flag, value);
}

void print_units(pugi::xml_node root, const Description& d) {
  pugi::xml_node definitions = root.append_child("UnitDefinitions");
  for (const Unit& unit : kUnits) {
    const auto uses = [&](const Variable& v) { return v.unit == std::string_view(unit.name); };
    if (std::none_of(d.table.begin(), d.table.end(), uses)) continue;
    pugi::xml_node node = definitions.append_child("Unit");
    set(node, "name", unit.name);
    pugi::xml_node base = node.append_child("BaseUnit");
    for (const auto& [name, exponent] :
         {std::pair{"kg", unit.kg}, {"m", unit.m}, {"s", unit.s}, {"rad", unit.rad}})
      if (exponent != 0) set(base, name, std::to_string(exponent));
  }
}

void print_log_categories(pugi::xml_node root) {
  pugi::xml_node categories = root.append_child("LogCategories");
  for (const auto& [name, description] :
       {std::pair{"logStatusError", "why a call was refused or the run ended"},
        {"logStatusWarning", "what may not be as intended"},
        {"logEvents", "what happens in the course of a run"},
        {"logStability", "changes of the time step and the link that sets it"}}) {
    pugi::xml_node category = categories.append_child("Category");
    set(category, "name", name);
    set(category, "description", description);
  }
}

void print_variables(pugi::xml_node root, const Description& d) {
  pugi::xml_node variables = root.append_child("ModelVariables");
  for (std::size_t i = 0; i < d.table.size(); ++i) {
    const Variable& v = d.table[i];
    pugi::xml_node scalar = variables.append_child("ScalarVariable");
    set(scalar, "name", v.name());
    set(scalar, "valueReference", std::to_string(i + 1));
    std::string description = v.description + (v.detail.empty() ? "" : ", " + v.detail);
    if (v.range.min_open || v.range.max_open)
      description += "; " + range_text(v.range);  // FMI's bounds are closed
    set(scalar, "description", description);
    set(scalar, "causality", text_of(v.causality));
    set(scalar, "variability", text_of(v.variability));
    if (v.causality != Causality::kInput)  // an input's value is implied
      set(scalar, "initial", v.causality == Causality::kParameter ? "exact" : "calculated");
    pugi::xml_node real = scalar.append_child("Real");
    set(real, "unit", v.unit);
    if (std::isfinite(v.range.min)) set(real, "min", decimal_text(v.range.min));
    if (std::isfinite(v.range.max)) set(real, "max", decimal_text(v.range.max));
    if (v.causality != Causality::kOutput) set(real, "start", decimal_text(*v.value));
  }
}

// Every output may depend on all known variables, and is calculated at initialization.
void print_structure(pugi::xml_node root, const Description& d) {
  pugi::xml_node structure = root.append_child("ModelStructure");
  for (const char* list : {"Outputs", "InitialUnknowns"}) {
    pugi::xml_node unknowns = structure.append_child(list);
    for (std::size_t i = 0; i < d.table.size(); ++i)
      if (d.table[i].causality == Causality::kOutput)
        set(unknowns.append_child("Unknown"), "index", std::to_string(i + 1));
  }
}

}  // namespace

std::string description_xml_fmi2(const Description& d) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("fmiModelDescription");
  set(root, "fmiVersion", "2.0");
  set(root, "modelName", d.name);
  set(root, "guid", d.guid);
  set(root, "description", "Woven cloth");
  set(root, "generationTool", "Drape " + d.version);
  set(root, "variableNamingConvention", "structured");
  set(root, "numberOfEventIndicators", "0");
  print_capabilities(root, d);
  print_units(root, d);
  print_log_categories(root);
  pugi::xml_node experiment = root.append_child("DefaultExperiment");
  set(experiment, "startTime", "0");
  set(experiment, "stopTime", decimal_text(d.stop_time));
  set(experiment, "stepSize", decimal_text(d.step_size));
  print_variables(root, d);
  print_structure(root, d);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace drape::description
