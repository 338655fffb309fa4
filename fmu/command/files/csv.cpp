#include "command/files/csv.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include "decimal.h"

namespace drape::command {
namespace {

// Records the reason of the first failure, because later calls would overwrite errno.
void csv_note(Csv& csv) {
  if (!csv.file && csv.trouble.empty()) csv.trouble = cannot_write(csv.path);
}

}  // namespace

std::string cannot_write(const std::filesystem::path& file) {
  return "cannot write " + file.string() + (errno ? std::string(": ") + std::strerror(errno) : "");
}

bool csv_open(Csv& csv, const std::filesystem::path& folder, std::string& problem) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  csv.path = folder / "outputs.csv";
  errno = 0;
  csv.file.open(csv.path, std::ios::binary);
  if (csv.file) return true;
  problem =
      error ? "cannot make the folder " + folder.string() + ": " + error.message() : cannot_write(csv.path);
  return false;
}

void csv_header(Csv& csv, const std::vector<std::string>& names) {
  const char* separator = "";
  for (const std::string& name : names) {
    const char* quote = name.find(',') == std::string::npos ? "" : "\"";  // node.position[1,2]
    csv.file << separator << quote << name << quote;
    separator = ",";
  }
  csv.file << "\n";
}

void csv_row(Csv& csv, const std::vector<double>& values) {
  const char* separator = "";
  errno = 0;
  for (const double value : values) {
    csv.file << separator << description::decimal_text(value);
    separator = ",";
  }
  csv.file << "\n";
  csv_note(csv);
}

bool csv_close(Csv& csv, std::string& problem) {
  errno = 0;
  csv.file.close();
  csv_note(csv);
  problem = csv.trouble;
  return csv.trouble.empty();
}

}  // namespace drape::command
