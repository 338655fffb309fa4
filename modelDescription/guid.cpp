#include "guid.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace drape::description {
namespace {

// NOLINTNEXTLINE(modernize-use-using): __extension__ goes before a typedef only
__extension__ typedef unsigned __int128 Hash;

constexpr Hash kStart = (Hash(0x6c62272e07bb0142) << 64) + 0x62b821756295c58d;

// FNV-1a with 128 bits: h <- (h xor byte) (2^88 + 2^8 + 0x3b).
Hash hash_append(Hash hash, std::string_view text) {
  constexpr Hash kPrime = (Hash(1) << 88) + 0x13b;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash * kPrime;  // a zero byte ends each text, which keeps the parts distinct
}

char hex_digit(Hash hash, int digit) { return "0123456789abcdef"[unsigned(hash >> (4 * (31 - digit))) & 15]; }

}  // namespace

std::string guid_content(const drape_cloth* cloth) {
  std::string content = drape_scene_text(cloth);
  for (int k = 0; k < drape_file_count(cloth); ++k) {
    const std::string_view file = drape_file_path(cloth, k);  // UTF-8
    std::ifstream mesh(std::filesystem::path(std::u8string(file.begin(), file.end())), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(mesh), {}};
    const Hash hash = hash_append(kStart, bytes);
    for (int digit = 0; digit < 32; ++digit) content += hex_digit(hash, digit);
  }
  return content;
}

std::string guid_of(std::string_view content, Nodes nodes) {
  Hash hash = kStart;
  for (const std::string_view part :
       {std::string_view(drape_version()), std::string_view(kNodesNames[int(nodes)]), content})
    hash = hash_append(hash, part);
  std::string guid = "{";
  for (int digit = 0; digit < 32; ++digit) {
    if (digit == 8 || digit == 12 || digit == 16 || digit == 20) guid += '-';
    guid += hex_digit(hash, digit);
  }
  return guid + "}";
}

}  // namespace drape::description
