// Which known name a word was meant to be.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

// The nearest of the known names if no more than a third of its letters are wrong, else "".
std::string spelling_nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace drape::scene
