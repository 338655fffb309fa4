// Damage to texts and bytes, drawn from a seeded generator.
#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace drape::fuzz {

struct Random {
  std::mt19937_64 engine;
  // 0 to count - 1.
  std::size_t below(std::size_t count) { return count ? std::size_t(engine() % count) : 0; }
  bool chance(std::size_t one_in) { return below(one_in) == 0; }
  template <class List>
  const auto& pick(const List& list) {
    return list[below(std::size(list))];
  }
};

// Texts are damaged by lines, words and numbers, binary files by bytes and words of 4 bytes. Both are cut,
// spliced with another text of the corpus, and struck bit by bit.
enum class Form { kText, kBinary };

// One text of the corpus after one to eight damages; at most kMaxBytes long.
inline constexpr std::size_t kMaxBytes = 1 << 17;
std::string mutate(Random& random, const std::vector<std::string>& corpus, Form form);

// A number that readers tend to get wrong, as text and as a value.
const char* odd_number(Random& random);
double odd_value(Random& random);

}  // namespace drape::fuzz
