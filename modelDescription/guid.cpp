#include "guid.h"

namespace drape::description {
namespace {

// NOLINTNEXTLINE(modernize-use-using): __extension__ goes before a typedef only
__extension__ typedef unsigned __int128 Hash;

// FNV-1a with 128 bits: h <- (h xor byte) (2^88 + 2^8 + 0x3b).
Hash hash_append(Hash hash, std::string_view text) {
  constexpr Hash kPrime = (Hash(1) << 88) + 0x13b;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash * kPrime;  // a zero byte ends each text, which keeps the parts distinct
}

}  // namespace

std::string guid_of(std::string_view scene_text, Nodes nodes) {
  Hash hash = (Hash(0x6c62272e07bb0142) << 64) + 0x62b821756295c58d;
  for (const std::string_view part :
       {std::string_view(drape_version()), std::string_view(kNodesNames[int(nodes)]), scene_text})
    hash = hash_append(hash, part);
  std::string guid = "{";
  for (int digit = 0; digit < 32; ++digit) {
    if (digit == 8 || digit == 12 || digit == 16 || digit == 20) guid += '-';
    guid += "0123456789abcdef"[unsigned(hash >> (4 * (31 - digit))) & 15];
  }
  return guid + "}";
}

}  // namespace drape::description
