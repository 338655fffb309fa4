// Suggests a known name for a misspelled word.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

// The known name with the smallest edit distance to the word, if that is at most a third of the length of the
// longer one; else "".
std::string spelling_nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace drape::scene
