// Files that people name: their paths, and what can be read.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace drape::scene {

inline constexpr std::uintmax_t kMaxText = 64 << 20;                 // bytes of a scene, fabric or pattern
inline constexpr std::uintmax_t kMaxData = std::uintmax_t(1) << 30;  // bytes of a mesh or table

// Texts of this program are in UTF-8. The constructor of a path and its member string() take the code page of
// the machine on Windows.
std::filesystem::path path_of(std::string_view utf8);
std::string path_text(const std::filesystem::path& path);

// Why a file cannot be read: there is none, it is a folder, a pipe or a device, it is empty, or it is larger
// than `max_size` (bytes). Empty where it can. Reading a pipe or a device might never end.
std::string file_hindrance(const std::filesystem::path& file, std::uintmax_t max_size);

}  // namespace drape::scene
