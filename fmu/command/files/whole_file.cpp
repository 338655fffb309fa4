#include "command/files/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace drape::command {
namespace {

namespace fs = std::filesystem;

Written text_write(const fs::path& place, const std::string& text, const fs::path& file) {
  errno = 0;
  std::ofstream stream(place, std::ios::binary);
  if (!stream) return {cannot_write(file)};
  stream << text;
  stream.close();
  return stream.fail() ? Written{cannot_write(file), true} : Written{};
}

}  // namespace

std::string cannot_write(const fs::path& file) {
  return "cannot write " + file.string() + (errno ? std::string(": ") + std::strerror(errno) : "");
}

std::string place_problem(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const bool written_directly = fs::exists(status) && !fs::is_regular_file(status);
  errno = 0;
  return access(written_directly ? file.c_str() : folder.c_str(), W_OK) == 0 ? "" : cannot_write(file);
}

Written file_write(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(file, error);  // a link stays a link
  if (error) target = file;
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return text_write(file, text, file);
  fs::path beside = target;
  beside += ".new";
  Written written = text_write(beside, text, file);
  if (written.problem.empty()) {
    if (fs::exists(status)) fs::permissions(beside, status.permissions(), error);
    fs::rename(beside, target, error);
    if (error) written.problem = "cannot write " + file.string() + ": " + error.message();
  }
  if (!written.problem.empty()) fs::remove(beside, error);
  return written;
}

}  // namespace drape::command
