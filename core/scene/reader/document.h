// A scene file and the fabric files it names -> one TOML table. What the keys mean is not known here.
#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

// Shortest decimals: read back, they give the same bits. And no assertions about the text inside the parser
// (3.3 asserts where it should report, `[ =`): NDEBUG would turn them into promises to the compiler.
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
  toml::table root;     // each fabric.<f> holds the keys of its file, its own keys on top
  std::vector<std::filesystem::path> files;  // the scene file and those that it names
  std::set<std::string> unread;              // fabrics whose file could not be read
};

Document document_load(const std::filesystem::path& file, Faults& faults);

// Takes what a calibration has written out of a fabric's table.
void calibration_drop(toml::table& fabric);

// One file alone, whatever it names.
Document document_load_file(const std::filesystem::path& file, Faults& faults);

}  // namespace drape::scene
