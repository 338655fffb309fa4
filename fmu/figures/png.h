// PNG images.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace drape::figures {

using Pixel = std::array<std::uint8_t, 4>;  // red, green, blue, opacity

// The bytes of a file with this image, row by row from the top: [width x height].
std::string png_bytes(std::uint32_t width, const std::vector<Pixel>& pixels);

}  // namespace drape::figures
