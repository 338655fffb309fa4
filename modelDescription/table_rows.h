// A family of the variable table as the texts of one row of the documentation.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "description.h"

namespace drape::description {

inline constexpr const char* kColumns[] = {"name", "meaning", "kind", "unit", "allowed", "start"};
using TableRow = std::array<std::string, 6>;  // in the order of kColumns

std::vector<TableRow> table_rows_of(const Description& description);

}  // namespace drape::description
