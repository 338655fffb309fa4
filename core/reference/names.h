// Names of variables as FMI's structured naming wants them: parts that are no identifiers stand in quotes.
#pragma once
#include <string>

namespace drape::reference {

std::string variable_prefix(const std::string& kind, const std::string& name);  // "pin.bar."

}  // namespace drape::reference
