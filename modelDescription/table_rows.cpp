#include "table_rows.h"

#include "decimal.h"

namespace drape::description {
namespace {

std::string kind_of(const Variable& v) {
  std::string kind = v.causality == Causality::kOutput        ? "output"
                     : v.causality == Causality::kInput       ? "input"
                     : v.variability == Variability::kTunable ? "parameter, tunable"
                                                              : "parameter, fixed";
  if (v.type != Type::kReal) kind += std::string("; ") + kTypeNames[int(v.type)];
  return kind;
}

// A long list shows only its ends: "at 1 % elongation ... at 7 % elongation".
std::string meaning_of(const Variable& first, const Variable& last) {
  if (first.detail.empty()) return first.description;
  return first.description + ", " + first.detail + (&first == &last ? "" : " ... " + last.detail);
}

// A vector in full; of a longer list only the ends.
std::string start_of(const Variable& first, const Variable& last) {
  if (first.causality == Causality::kOutput) return "";
  std::string text = decimal_text(*first.value);
  if (&last - &first > 3) return text + " ... " + decimal_text(*last.value);
  for (const Variable* v = &first + 1; v <= &last; ++v) text += ", " + decimal_text(*v->value);
  return text;
}

}  // namespace

std::vector<TableRow> table_rows_of(const Description& d) {
  std::vector<TableRow> rows;
  for (const Family& f : families_of(d.table)) {
    const Variable &first = d.table[f.first], &last = d.table[f.first + f.count - 1];
    const bool output = first.causality == Causality::kOutput;
    rows.push_back({first.family + f.index, meaning_of(first, last), kind_of(first), first.unit,
                    output ? "" : range_text(first.range), start_of(first, last)});
  }
  return rows;
}

}  // namespace drape::description
