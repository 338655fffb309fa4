// The resource location that a master hands over: file:///path, file:/path, file://localhost/path or a plain
// path.
#pragma once
#include <string>

namespace drape::instance {

// The folder it names, without a slash at its end. On a fault: empty, and a sentence in `problem`.
std::string resource_path(const std::string& location, std::string& problem);

}  // namespace drape::instance
