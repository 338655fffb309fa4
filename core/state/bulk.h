// Hashes and checks of whole arrays.
#pragma once
#include <cstddef>
#include <cstdint>

namespace drape::state {

// A hash that any change of up to eight consecutive bytes changes. `seed`: of what came before.
std::uint64_t bytes_hash(const void* bytes, std::size_t size, std::uint64_t seed);

// Whether all numbers are from min to max. NaN is not.
bool numbers_within(const double* value, std::size_t count, double min, double max);

// Whether all bytes are 0 or 1, as those of a bool must be.
bool flags_within(const bool* flag, std::size_t count);

}  // namespace drape::state
