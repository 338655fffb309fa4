#include "state/bulk.h"

#include <bit>
#include <cstring>

namespace drape::state {

// Four lanes of words w, each h <- (rotate(h) xor w) P with P odd: a bijection of h for any w, and of w for
// any h. So a single word that differs leaves its lane, and with it the end, different.
std::uint64_t bytes_hash(const void* bytes, std::size_t size, std::uint64_t seed) {
  constexpr std::uint64_t kPrime = 0x9e3779b97f4a7c15;
  constexpr std::size_t kLanes = 4, kWord = sizeof(std::uint64_t);
  const auto mix = [](std::uint64_t h, std::uint64_t word) { return (std::rotl(h, 29) ^ word) * kPrime; };
  std::uint64_t lane[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) lane[k] = mix(seed, k + 1);
  const auto* at = static_cast<const unsigned char*>(bytes);
  std::size_t left = size;
  for (; left >= kLanes * kWord; left -= kLanes * kWord)
    for (std::uint64_t& h : lane) {
      std::uint64_t word;
      std::memcpy(&word, at, kWord);
      h = mix(h, word);
      at += kWord;
    }
  for (std::size_t k = 0; left > 0; ++k) {
    const std::size_t part = left < kWord ? left : kWord;
    std::uint64_t word = 0;
    std::memcpy(&word, at, part);
    lane[k] = mix(lane[k], word);
    at += part, left -= part;
  }
  std::uint64_t hash = mix(seed, size);
  for (const std::uint64_t h : lane) hash = mix(hash, h ^ (h >> 32));
  return hash ^ (hash >> 32);
}

bool numbers_within(const double* value, std::size_t count, double min, double max) {
  bool within = true;
  for (std::size_t k = 0; k < count; ++k) within &= value[k] >= min && value[k] <= max;
  return within;
}

bool flags_within(const bool* flag, std::size_t count) {
  const auto* byte = reinterpret_cast<const unsigned char*>(flag);  // other bytes are no bool
  for (std::size_t k = 0; k < count; ++k)
    if (byte[k] > 1) return false;
  return true;
}

}  // namespace drape::state
