// The variable table: one row for each variable of a cloth. The XML, get and set, range checks, CSV headers
// and the documentation are loops over this table, and nothing else lists variables. A new variable is one
// line in variables.cpp. All values are kept as numbers, whatever type they have for a master.
#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "drape/drape.h"
#include "scene/limits.h"

namespace drape::description {

enum class Causality { kParameter, kInput, kOutput };
enum class Variability { kFixed, kTunable, kDiscrete, kContinuous };

// What a variable is for a master. A Boolean is 0 or 1 here.
enum class Type { kReal, kInteger, kBoolean, kMode };
inline constexpr const char* kTypeNames[] = {"Real", "Integer", "Boolean", "Enumeration"};
using scene::kModeNames;  // items 1 and 2 of the enumeration `mode`

// What a variable does before the first step: a parameter or input acts on the outputs, or an output depends
// on the parameters that act, or on the wind too.
enum class AtStart { kNothing, kActs, kOfParameters, kOfForces };

// The particles that have variables of their own; `outline`: those at fewer than four cells.
enum class Nodes { kNone, kOutline, kAll };
inline constexpr const char* kNodesNames[] = {"none", "outline", "all"};

// Finite numbers from min to max. An open end is excluded.
struct Range {
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool min_open = false, max_open = false;
  bool whole = false;
};

struct Variable {
  std::string family;       // "fabric.wool.warp.force": rows of one family are neighbours
  std::string index;        // "[3]", "[17,2]", or empty
  std::string description;  // of the family
  std::string detail;       // what distinguishes this row in its family, or empty
  Causality causality;
  Variability variability;
  const char* unit;  // a name in units.h
  Range range;
  const double* value;  // in the cloth's drape_parameters, drape_inputs or drape_outputs
  double* setting;      // the same place, writable; null for an output
  double* rate;         // of an input: its time derivative, in the cloth's input rates; else null
  int needs;            // of an output: bits that drape_get_outputs must have filled; else 0
  Type type = Type::kReal;
  const char* display_unit = nullptr;  // a name in units.h; null: the unit itself
  AtStart at_start = AtStart::kNothing;
  const double* derivative = nullptr;  // of a position: its velocity, which needs the next bits
  int derivative_needs = 0;

  std::string name() const { return family + index; }
};

// The table of a cloth. The value reference of a row is its index + 1; 0 refers to nothing. The rows point
// into the cloth, and are valid while it is open.
std::vector<Variable> variables_of(drape_cloth* cloth, Nodes nodes);

// The row with a name, or null.
const Variable* variable_find(const std::vector<Variable>& table, std::string_view name);

// The closest name in the table, for messages about unknown names; empty where none is near.
std::string variable_nearest(const std::vector<Variable>& table, std::string_view name);

// "above 0", "0 to 1", "any finite number".
std::string range_text(const Range& range);

// Empty if the variable may take the value; else one sentence with name, value, allowed range and unit.
std::string range_problem(const Variable& variable, double value);

// Rows that differ only in their index, as one: "[1..8]", "[1..160,1..3]".
struct Family {
  std::size_t first, count;
  std::string index;
};
std::vector<Family> families_of(const std::vector<Variable>& table);

}  // namespace drape::description
