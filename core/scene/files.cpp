#include "scene/files.h"

namespace drape::scene {

namespace fs = std::filesystem;

fs::path path_of(std::string_view utf8) { return std::u8string(utf8.begin(), utf8.end()); }

std::string path_text(const fs::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

std::string file_hindrance(const fs::path& file, std::uintmax_t max_size) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::none) return "cannot be read: " + error.message();
  if (!fs::exists(status)) return "there is no such file";
  if (fs::is_directory(status)) return "is a folder, not a file";
  if (!fs::is_regular_file(status)) return "is not a regular file";
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return "cannot be read: " + error.message();
  if (size == 0) return "is empty";
  if (size > max_size) return "is larger than " + std::to_string(max_size >> 20) + " MB";
  return "";
}

}  // namespace drape::scene
