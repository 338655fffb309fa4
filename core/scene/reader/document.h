// Loads a scene file and the fabric files that it names into one TOML table. The meaning of the keys is not
// known here.
#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

// Numbers are printed as the shortest decimals that give the same bits when read back. Assertions inside the
// parser are off: toml++ 3.3 asserts on some invalid texts that it should report, such as `[ =`, and with
// NDEBUG it would turn the assertions into assumptions of the compiler.
#define TOML_FLOAT_CHARCONV 1
#define TOML_ASSERT(condition) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "scene/diagnostics.h"

namespace drape::scene {

struct Document {
  bool loaded = false;  // false: the scene file itself could not be read
  toml::table root;     // each fabric.<f> has the keys of its file, overridden by its own
  std::vector<std::filesystem::path> files;  // the scene file and the fabric files that it names
  std::set<std::string> unread;              // fabrics whose file could not be read
};

// Loads a scene file with its fabric files; adds faults of files and syntax.
Document document_load(const std::filesystem::path& file, Faults& faults);

// Removes what a calibration has written from the table of a fabric.
void calibration_drop(toml::table& fabric);

// Loads one file, without the files that it names.
Document document_load_file(const std::filesystem::path& file, Faults& faults);

}  // namespace drape::scene
