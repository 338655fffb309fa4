// The header of saved states: what they are, of which scene, and whether they are whole.
//
//   0   8   magic      "drapest" and a byte 0xd5, no text
//   8   8   layout     of the format, and hash of the names and types of all fields
//   16  8   size       of all bytes, header included
//   24  8   scene      hash of the scene and its meshes
//   32  8   checksum   of all bytes but these
//   40      the fields
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace drape::state {

inline constexpr std::size_t kHeaderSize = 40;

// What a reader expects.
struct Seal {
  std::uint64_t layout = 0, scene = 0;
};

// Writes the header in front of the fields, which are in place already.
void seal_write(unsigned char* bytes, std::size_t size, const Seal& seal);

// Empty where the bytes are whole and as expected, else what is wrong with them.
std::string seal_problem(const unsigned char* bytes, std::size_t size, const Seal& expected,
                         const std::string& scene_name);

}  // namespace drape::state
