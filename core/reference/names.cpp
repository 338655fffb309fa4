#include "reference/names.h"

namespace drape::reference {

std::string variable_prefix(const std::string& kind, const std::string& name) {
  bool plain = !name.empty() && !(name[0] >= '0' && name[0] <= '9');
  std::string quoted;
  for (const char c : name) {
    const bool letter =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    plain = plain && letter;
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return kind + "." + (plain ? name : "'" + quoted + "'") + ".";
}

}  // namespace drape::reference
