#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <pugixml.hpp>
#include <sstream>
#include <utility>

#include "decimal.h"
#include "description.h"
#include "units.h"

namespace drape::description {
namespace {

constexpr char kModeType[] = "Mode";

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
                                    {"maxOutputDerivativeOrder", "1"},
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
    const auto uses = [&](const Variable& v) {
      return v.type == Type::kReal && v.unit == std::string_view(unit.name);
    };
    if (std::none_of(d.table.begin(), d.table.end(), uses)) continue;
    pugi::xml_node node = definitions.append_child("Unit");
    set(node, "name", unit.name);
    pugi::xml_node base = node.append_child("BaseUnit");
    for (const auto& [name, exponent] :
         {std::pair{"kg", unit.kg}, {"m", unit.m}, {"s", unit.s}, {"rad", unit.rad}})
      if (exponent != 0) set(base, name, std::to_string(exponent));
    for (const DisplayUnit& display : kDisplayUnits) {
      const auto shows = [&](const Variable& v) {
        return v.display_unit && v.display_unit == std::string_view(display.name);
      };
      if (display.unit != std::string_view(unit.name) || std::none_of(d.table.begin(), d.table.end(), shows))
        continue;
      pugi::xml_node shown = node.append_child("DisplayUnit");
      set(shown, "name", display.name);
      set(shown, "factor", decimal_text(display.factor));
    }
  }
}

// The items of the enumeration `mode`.
void print_types(pugi::xml_node root) {
  pugi::xml_node type = root.append_child("TypeDefinitions").append_child("SimpleType");
  set(type, "name", kModeType);
  pugi::xml_node items = type.append_child("Enumeration");
  for (std::size_t k = 0; k < std::size(kModeNames); ++k) {
    pugi::xml_node item = items.append_child("Item");
    set(item, "name", kModeNames[k]);
    set(item, "value", std::to_string(k + 1));
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

void print_type(pugi::xml_node scalar, const Variable& v) {
  pugi::xml_node node = scalar.append_child(kTypeNames[int(v.type)]);
  const auto number_of = [&](double value) {
    return v.type == Type::kReal ? decimal_text(value) : std::to_string(std::int64_t(value));
  };
  if (v.type == Type::kReal) {
    const Unit* unit = std::find_if(std::begin(kUnits), std::end(kUnits),
                                    [&](const Unit& u) { return v.unit == std::string_view(u.name); });
    set(node, "unit", v.unit);
    if (v.display_unit) set(node, "displayUnit", v.display_unit);
    if (unit != std::end(kUnits) && unit->nominal != 1) set(node, "nominal", decimal_text(unit->nominal));
  }
  if (v.type == Type::kMode) set(node, "declaredType", kModeType);
  if (v.type != Type::kBoolean && std::isfinite(v.range.min)) set(node, "min", number_of(v.range.min));
  if (v.type != Type::kBoolean && std::isfinite(v.range.max)) set(node, "max", number_of(v.range.max));
  if (v.causality == Causality::kOutput) return;
  set(node, "start", v.type == Type::kBoolean ? (*v.value != 0 ? "true" : "false") : number_of(*v.value));
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
    print_type(scalar, v);
  }
}

// The indices of the parameters that act before the first step, and with `inputs` of the inputs too.
std::string acting_list(const Description& d, bool inputs) {
  std::string list;
  for (std::size_t i = 0; i < d.table.size(); ++i)
    if (d.table[i].at_start == AtStart::kActs && (inputs || d.table[i].causality == Causality::kParameter))
      list += (list.empty() ? "" : " ") + std::to_string(i + 1);
  return list;
}

// Inputs act within the next step, so no output depends on them at a communication point. Before the first
// step the forces of the start do, on the parameters and the wind.
void print_structure(pugi::xml_node root, const Description& d) {
  pugi::xml_node structure = root.append_child("ModelStructure");
  const std::string parameters = acting_list(d, false), all = acting_list(d, true);
  for (const char* list : {"Outputs", "InitialUnknowns"}) {
    pugi::xml_node unknowns = structure.append_child(list);
    const bool at_start = list == std::string_view("InitialUnknowns");
    for (std::size_t i = 0; i < d.table.size(); ++i) {
      const Variable& v = d.table[i];
      if (v.causality != Causality::kOutput) continue;
      pugi::xml_node unknown = unknowns.append_child("Unknown");
      set(unknown, "index", std::to_string(i + 1));
      set(unknown, "dependencies",
          !at_start                              ? ""
          : v.at_start == AtStart::kOfForces     ? all
          : v.at_start == AtStart::kOfParameters ? parameters
                                                 : "");
    }
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
  set(root, "description", d.about);
  set(root, "author", d.author);
  set(root, "version", d.model_version);
  set(root, "copyright", d.copyright);
  set(root, "license", d.license);
  set(root, "generationTool", "Drape " + d.version);
  if (!d.date.empty()) set(root, "generationDateAndTime", d.date);
  set(root, "variableNamingConvention", "structured");
  set(root, "numberOfEventIndicators", "0");
  print_capabilities(root, d);
  print_units(root, d);
  print_types(root);
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
