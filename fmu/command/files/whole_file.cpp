#include "command/files/whole_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
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

// Where a link leads to, whether there is a file or not.
fs::path link_end(fs::path file) {
  constexpr int kMaxLinks = 40;
  std::error_code error;
  for (int k = 0; k < kMaxLinks && fs::is_symlink(file, error); ++k) {
    const fs::path next = fs::read_symlink(file, error);
    if (error) break;
    file = next.is_absolute() ? next : file.parent_path() / next;
  }
  return file;
}

// True for what is written to as it is: devices, pipes, and the files that a shell has opened.
bool is_stream(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const std::string place = fs::absolute(file, error).lexically_normal().string();
  return (fs::exists(status) && !fs::is_regular_file(status)) || place.starts_with("/dev/") ||
         place.starts_with("/proc/");
}

fs::perms permissions_of(const fs::path& target) {
  std::error_code error;
  if (const fs::file_status status = fs::status(target, error); fs::exists(status))
    return status.permissions();
  const mode_t mask = umask(0);
  umask(mask);
  return fs::perms(0666 & ~mask);
}

}  // namespace

std::string cannot_write(const fs::path& file) {
  return "cannot write " + file.string() + (errno ? std::string(": ") + std::strerror(errno) : "");
}

std::string place_problem(const fs::path& file) {
  std::error_code error;
  const fs::path target = link_end(file),
                 folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  errno = fs::is_directory(target, error) ? EISDIR : 0;
  if (errno) return cannot_write(file);
  const bool there = fs::exists(target, error);
  return access(there ? target.c_str() : folder.c_str(), W_OK) == 0 ? "" : cannot_write(file);
}

Written file_write(const fs::path& file, const std::string& text) {
  if (is_stream(file)) return text_write(file, text, file);
  const fs::path target = link_end(file);
  std::error_code error;
  const bool there = fs::exists(target, error);
  std::string beside = target.string() + ".XXXXXX";
  errno = 0;
  const int opened = mkstemp(beside.data());
  if (opened < 0) return there ? text_write(target, text, file) : Written{cannot_write(file)};
  close(opened);
  Written written = text_write(beside, text, file);
  if (written.problem.empty()) {
    fs::permissions(beside, permissions_of(target), error);
    fs::rename(beside, target, error);
    if (error) written = there ? text_write(target, text, file) : Written{cannot_write(file)};
  }
  fs::remove(beside, error);
  return written;
}

}  // namespace drape::command
