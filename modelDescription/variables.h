// The variable table: one row per variable of a cloth. The XML, get and set, range checks, CSV headers and
// the documentation are loops over this table, and nothing else lists variables. A new variable is one line
// in variables.cpp. All variables are Real.
#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "drape/drape.h"

namespace drape::description {

enum class Causality { kParameter, kInput, kOutput };
enum class Variability { kFixed, kTunable, kDiscrete, kContinuous };

// Which particles have variables of their own; `outline`: those at fewer than four cells.
enum class Nodes { kNone, kOutline, kAll };
inline constexpr const char* kNodesNames[] = {"none", "outline", "all"};

// Finite numbers from min to max; an open end is itself not allowed.
struct Range {
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool min_open = false, max_open = false;
  bool whole = false;
};

struct Variable {
  std::string family;       // "fabric.wool.warp.force": rows of one family are neighbours
  std::string index;        // "[3]", "[17,2]", or empty
  std::string description;  // of the family
  std::string detail;       // what sets this row apart in its family, or empty
  Causality causality;
  Variability variability;
  const char* unit;  // a name in units.h
  Range range;
  const double* value;  // in the cloth's drape_parameters, drape_inputs or drape_outputs
  double* setting;      // the same place, writable; null for an output
  double* rate;         // of an input: its time derivative, in the cloth's input rates; else null
  int needs;            // of an output: bits that drape_get_outputs must have filled; else 0

  std::string name() const { return family + index; }
};

// The table of a cloth. The value reference of a row is its index + 1; 0 names nothing.
std::vector<Variable> variables_of(drape_cloth* cloth, Nodes nodes);

// Row of a name, or null.
const Variable* variable_find(const std::vector<Variable>& table, std::string_view name);

// The closest name in the table, for messages about names that are not in it; empty where none is near.
std::string variable_nearest(const std::vector<Variable>& table, std::string_view name);

// "above 0", "0 to 1", "any finite number".
std::string range_text(const Range& range);

// Empty if the variable may take the value, else one sentence with what, value, allowed range and unit.
std::string range_problem(const Variable& variable, double value);

// Rows that differ in their index only, as one: "[1..8]", "[1..160,1..3]".
struct Family {
  std::size_t first, count;
  std::string index;
};
std::vector<Family> families_of(const std::vector<Variable>& table);

}  // namespace drape::description
