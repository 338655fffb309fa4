// Files that appear whole under their names, or not at all.
#pragma once
#include <filesystem>
#include <string>

namespace drape::command {

struct Written {
  std::string problem;  // a sentence; empty if the file has been written
  bool full = false;    // the place could be written to, but did not take all
};

// Writes the file beside its place, under a name of its own, and renames it when it is complete; keeps the
// permissions of the file that it replaces, and links to it. After a problem the old file is as it was.
// Written to directly are devices and pipes, such as /dev/stdout, and a file in a folder that takes no new
// one.
Written file_write(const std::filesystem::path& file, const std::string& text);

// Why a file could not be written there, as far as that shows beforehand; empty if it probably could.
std::string place_problem(const std::filesystem::path& file);

// "cannot write FILE: No space left on device", from errno.
std::string cannot_write(const std::filesystem::path& file);

}  // namespace drape::command
