// Comma-separated values: a header, then rows of numbers with all their digits.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace drape {

struct Csv {
  std::ofstream file;
};

void csv_header(Csv& csv, const std::vector<std::string>& names);
void csv_row(Csv& csv, const std::vector<double>& values);

// Creates the folder and outputs.csv in it. False, with a sentence in `problem`, where that fails.
bool csv_open(Csv& csv, const std::filesystem::path& folder, std::string& problem);

// Ends the file. False where something could not be written.
bool csv_close(Csv& csv);

}  // namespace drape
