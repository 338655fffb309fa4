#include <algorithm>
#include <cmath>

#include "decimal.h"
#include "scene/spelling.h"
#include "variables.h"

namespace drape::description {
namespace {

// "[1..8]" from "[1]" and "[8]", for each dimension.
std::string index_span(const std::string& first, const std::string& last) {
  std::string span;
  for (std::size_t i = 0, j = 0; i < first.size();) {
    const std::size_t i_end = first.find_first_of(",]", i + 1), j_end = last.find_first_of(",]", j + 1);
    const std::string from = first.substr(i, i_end - i), to = last.substr(j + 1, j_end - j - 1);
    span += from.substr(1) == to ? from : from + ".." + to;
    i = i_end, j = j_end;
    if (first[i] == ']') return span + "]";
  }
  return span;
}

}  // namespace

const Variable* variable_find(const std::vector<Variable>& table, std::string_view name) {
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const Variable& v) { return v.name() == name; });
  return row == table.end() ? nullptr : &*row;
}

std::string variable_nearest(const std::vector<Variable>& table, std::string_view name) {
  std::vector<std::string> names;
  for (const Variable& v : table) names.push_back(v.name());
  return scene::spelling_nearest(name, names);
}

std::string range_text(const Range& r) {
  const bool from = std::isfinite(r.min), to = std::isfinite(r.max);
  if (!from && !to) return "any finite number";
  if (r.min == r.max) return "only " + decimal_text(r.min);
  if (!to) return r.min_open ? "above " + decimal_text(r.min) : decimal_text(r.min) + " or more";
  if (!from) return r.max_open ? "below " + decimal_text(r.max) : decimal_text(r.max) + " or less";
  return (r.min_open ? "above "
          : r.whole  ? "a whole number from "
                     : "") +
         decimal_text(r.min) + (r.max_open ? " to below " : " to ") + decimal_text(r.max);
}

std::string range_problem(const Variable& v, double value) {
  const Range& r = v.range;
  const bool low = r.min_open ? value > r.min : value >= r.min,
             high = r.max_open ? value < r.max : value <= r.max;
  if (std::isfinite(value) && low && high && (!r.whole || value == std::floor(value))) return "";
  const std::string unit = v.unit == std::string_view("1") ? "" : std::string(" ") + v.unit;
  return v.name() + " is " + decimal_text(value) + unit + "; allowed: " + range_text(r) + unit;
}

std::vector<Family> families_of(const std::vector<Variable>& table) {
  std::vector<Family> families;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (!families.empty() && !table[i].index.empty() &&
        table[families.back().first].family == table[i].family)
      ++families.back().count;
    else families.push_back({i, 1, ""});
  }
  for (Family& f : families) f.index = index_span(table[f.first].index, table[f.first + f.count - 1].index);
  return families;
}

}  // namespace drape::description
