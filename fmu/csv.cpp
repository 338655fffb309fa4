#include "csv.h"

#include <cstdio>
#include <system_error>

namespace drape {

bool csv_open(Csv& csv, const std::filesystem::path& folder, std::string& problem) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  csv.file.open(folder / "outputs.csv", std::ios::binary);
  if (csv.file) return true;
  problem = "cannot write " + (folder / "outputs.csv").string();
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
  for (const double value : values) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    csv.file << separator << text;
    separator = ",";
  }
  csv.file << "\n";
}

bool csv_close(Csv& csv) {
  csv.file.close();
  return !csv.file.fail();
}

}  // namespace drape
