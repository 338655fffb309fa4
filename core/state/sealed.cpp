#include "state/sealed.h"

#include <cstring>

#include "state/bulk.h"

namespace drape::state {
namespace {

constexpr unsigned char kMagic[8] = {'d', 'r', 'a', 'p', 'e', 's', 't', 0xd5};
constexpr std::size_t kLayoutAt = 8, kSizeAt = 16, kSceneAt = 24, kChecksumAt = 32;

void word_write(unsigned char* bytes, std::size_t at, std::uint64_t word) {
  std::memcpy(bytes + at, &word, sizeof word);
}

std::uint64_t word_read(const unsigned char* bytes, std::size_t at) {
  std::uint64_t word;
  std::memcpy(&word, bytes + at, sizeof word);
  return word;
}

std::uint64_t checksum_of(const unsigned char* bytes, std::size_t size) {
  return bytes_hash(bytes + kHeaderSize, size - kHeaderSize, bytes_hash(bytes, kChecksumAt, 0));
}

}  // namespace

void seal_write(unsigned char* bytes, std::size_t size, const Seal& seal) {
  std::memcpy(bytes, kMagic, sizeof kMagic);
  word_write(bytes, kLayoutAt, seal.layout);
  word_write(bytes, kSizeAt, size);
  word_write(bytes, kSceneAt, seal.scene);
  word_write(bytes, kChecksumAt, checksum_of(bytes, size));
}

std::string seal_problem(const unsigned char* bytes, std::size_t size, const Seal& expected,
                         const std::string& scene_name) {
  if (size < kHeaderSize)
    return "the saved state has " + std::to_string(size) + " bytes; expected: at least " +
           std::to_string(kHeaderSize);
  if (std::memcmp(bytes, kMagic, sizeof kMagic) != 0)
    return "these bytes are no saved state of Drape: they do not begin as one does";
  if (word_read(bytes, kLayoutAt) != expected.layout)
    return "the saved state is of another version of Drape, whose states have other fields";
  if (word_read(bytes, kSizeAt) != size)
    return "the saved state has " + std::to_string(size) +
           " bytes; expected: " + std::to_string(word_read(bytes, kSizeAt)) + ", as its header says";
  if (word_read(bytes, kChecksumAt) != checksum_of(bytes, size))
    return "the bytes of the saved state have changed since they were written";
  if (word_read(bytes, kSceneAt) != expected.scene)
    return "the saved state is of another scene than '" + scene_name + "', or of other meshes";
  return "";
}

}  // namespace drape::state
