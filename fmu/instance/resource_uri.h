// The resource location that a master passes: file:///path, file:/path, file://localhost/path or a plain
// path.
#pragma once
#include <string>

namespace drape::instance {

// The folder that it names, without a slash at the end. On a fault it returns an empty path and puts a
// sentence in `problem`.
std::string resource_path(const std::string& location, std::string& problem);

}  // namespace drape::instance
