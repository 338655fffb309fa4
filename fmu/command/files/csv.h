// Comma-separated values: a header, then rows of numbers. Each number is the shortest decimal that reads
// back to the same bits.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace drape::command {

struct Csv {
  std::filesystem::path path;
  std::ofstream file;
  std::string failure;  // why the file could not be written; empty while it could
};

void csv_header(Csv& csv, const std::vector<std::string>& names);
void csv_row(Csv& csv, const std::vector<double>& values);

// Creates the folder and outputs.csv in it. On failure it returns false and puts a sentence in `problem`.
bool csv_open(Csv& csv, const std::filesystem::path& folder, std::string& problem);

// Ends the file. If something could not be written, it returns false and puts a sentence in `problem`.
bool csv_close(Csv& csv, std::string& problem);

}  // namespace drape::command
