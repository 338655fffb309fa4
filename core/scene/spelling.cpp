#include "scene/spelling.h"

#include <algorithm>

namespace drape::scene {

namespace {

// The number of edits that turn a into b: insert, delete or replace a letter, or exchange two neighbours
// (optimal string alignment). The distance d(i, j) of the first i and j letters is the minimum of
//
//   d(i-1, j) + 1,   d(i, j-1) + 1,   d(i-1, j-1) + [a_i != b_j],
//   d(i-2, j-2) + 1   where a_i a_{i-1} = b_{j-1} b_j.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> last(b.size() + 1), row(b.size() + 1), next(b.size() + 1);  // d(i-2), d(i-1), d(i)
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        next[j] = std::min(next[j], last[j - 2] + 1);
    }
    last.swap(row);
    row.swap(next);
  }
  return row[b.size()];
}

}  // namespace

bool name_fits(const std::string& name) {
  constexpr std::size_t kMaxLength = 64;
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto inner = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name.size() <= kMaxLength && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), inner);
}

std::string spelling_nearest(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t smallest = std::string::npos;
  for (const std::string& name : known) {
    const auto [shorter, longer] = std::minmax({word.size(), name.size()});
    const auto near = [&](std::size_t distance) { return distance < smallest && 3 * distance <= longer; };
    if (!near(longer - shorter)) continue;  // no edits are fewer than the letters to add
    const std::size_t distance = edit_distance(word, name);
    if (near(distance)) smallest = distance, nearest = name;
  }
  return nearest;
}

}  // namespace drape::scene
