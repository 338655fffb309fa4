// Names of variables in FMI's structured naming convention: parts that are not identifiers are in quotes.
#pragma once
#include <string>

namespace drape::reference {

std::string variable_prefix(const std::string& kind, const std::string& name);  // "pin.bar."

}  // namespace drape::reference
