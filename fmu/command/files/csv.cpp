#include "command/files/csv.h"

#include <cerrno>
#include <system_error>

#include "command/files/whole_file.h"
#include "decimal.h"

namespace drape::command {
namespace {

// Records the reason of the first failure, because later calls would overwrite errno.
void csv_note(Csv& csv) {
  if (!csv.file && csv.failure.empty()) csv.failure = cannot_write(csv.path);
}

}  // namespace

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
  std::string row;
  for (const double value : values) {
    if (!row.empty()) row += ',';
    row += description::decimal_text(value);
  }
  errno = 0;
  csv.file << row + '\n' << std::flush;  // whole, so that what is there of a run that is stopped can be read
  csv_note(csv);
}

bool csv_close(Csv& csv, std::string& problem) {
  errno = 0;
  csv.file.close();
  csv_note(csv);
  problem = csv.failure;
  return csv.failure.empty();
}

}  // namespace drape::command
