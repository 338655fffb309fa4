#include "figures/png.h"

#include <zlib.h>

namespace drape::figures {
namespace {

void number_append(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift & 0xff);
}

// Length, type, data, and a checksum of type and data.
void chunk_append(std::string& bytes, const std::string& type, const std::string& data) {
  number_append(bytes, std::uint32_t(data.size()));
  const std::string content = type + data;
  bytes += content;
  number_append(
      bytes, std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(content.data()), uInt(content.size()))));
}

std::string deflated(const std::string& data) {
  uLongf size = compressBound(uLong(data.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
            uLong(data.size()), Z_BEST_COMPRESSION);
  packed.resize(size);
  return packed;
}

}  // namespace

std::string png_bytes(std::uint32_t width, const std::vector<Pixel>& pixels) {
  const auto height = std::uint32_t(pixels.size() / width);
  std::string header, rows;
  number_append(header, width);
  number_append(header, height);
  header += std::string("\x08\x06\x00\x00\x00", 5);  // 8 bits; with opacity; as is, row by row
  for (std::uint32_t y = 0; y < height; ++y) {
    rows += '\0';  // unfiltered
    for (std::uint32_t x = 0; x < width; ++x)
      for (const std::uint8_t part : pixels[std::size_t(y) * width + x]) rows += char(part);
  }
  std::string bytes = "\x89PNG\r\n\x1a\n";
  chunk_append(bytes, "IHDR", header);
  chunk_append(bytes, "IDAT", deflated(rows));
  chunk_append(bytes, "IEND", "");
  return bytes;
}

}  // namespace drape::figures
