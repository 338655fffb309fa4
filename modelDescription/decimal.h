// Numbers as text: the shortest digits that read back to the same bits.
#pragma once
#include <charconv>
#include <string>

namespace drape::description {

inline std::string decimal_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace drape::description
