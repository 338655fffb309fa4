// Names: which are allowed, and suggestions for misspelled ones.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

// Names of objects become part of the names of FMU variables.
bool name_fits(const std::string& name);
constexpr const char* kNameRule =
    "is no name; wanted: a letter, then letters, digits or underscores, at most 64 characters in all";

// The known name with the smallest edit distance to the word, if that is at most a third of the length of the
// longer one; else "".
std::string spelling_nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace drape::scene
