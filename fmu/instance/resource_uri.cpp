#include "instance/resource_uri.h"

#include <cctype>
#include <cstdlib>

namespace drape::instance {
namespace {

// "%20" -> " ". False where a percent sign is not followed by two hexadecimal digits, or by 00.
bool percent_decode(std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const std::string digits = text.substr(i + 1, 2);
    if (digits.size() < 2 || !std::isxdigit(static_cast<unsigned char>(digits[0])) ||
        !std::isxdigit(static_cast<unsigned char>(digits[1])) || digits == "00")
      return false;
    decoded += static_cast<char>(std::strtol(digits.c_str(), nullptr, 16));
    i += 2;
  }
  text = decoded;
  return true;
}

// Whether the bytes are the shortest forms of characters: no half of a pair (surrogate), none beyond 10FFFF.
bool is_utf8(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(i);
    const std::size_t more = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    if ((first >= 0x80 && first < 0xC2) || first > 0xF4 || text.size() - i <= more) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if (byte(i + k) >> 6 != 2) return false;
    const unsigned second = more ? byte(i + 1) : 0;
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F))
      return false;
    i += 1 + more;
  }
  return true;
}

#ifdef _WIN32
// "/C:/folder" -> "C:/folder"
void drive_first(std::string& path) {
  if (path.size() > 2 && path[0] == '/' && std::isalpha(static_cast<unsigned char>(path[1])) &&
      path[2] == ':')
    path.erase(0, 1);
}
#else
void drive_first(std::string&) {}
#endif

}  // namespace

std::string resource_path(const std::string& location, std::string& problem) {
  const auto refuse = [&](const char* allowed) {
    problem = "the resource location is '" + location + "'; allowed: " + allowed;
    return std::string();
  };
  std::string path = location;
  if (path.starts_with("file:")) {
    path.erase(0, 5);
    if (path.starts_with("//")) {
      const std::size_t host_end = path.find('/', 2);
      const std::string host =
          path.substr(2, host_end == std::string::npos ? std::string::npos : host_end - 2);
      if (host_end == std::string::npos || (!host.empty() && host != "localhost"))
        return refuse("a folder of this machine, as in file:///path");
      path.erase(0, host_end);
    }
    if (path.empty() || path[0] != '/') return refuse("an absolute path after file:");
    if (!percent_decode(path)) return refuse("two hexadecimal digits, not 00, after each % sign");
    drive_first(path);
  } else if (path.find("://") != std::string::npos || path.empty()) {
    return refuse("a file: URI or a path");
  }
  if (!is_utf8(path)) return refuse("UTF-8");
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

}  // namespace drape::instance
