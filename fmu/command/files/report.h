// The report at the end of a run: elongation per piece and direction, seams, contact.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "drape/drape.h"

namespace drape::command {

struct ReportColumn {
  std::string name, unit;
};

struct ReportTable {
  std::string title;
  std::vector<std::string> labels;    // of the leading columns of words
  std::vector<ReportColumn> columns;  // of numbers
  struct Row {
    std::vector<std::string> words;  // [labels]
    std::vector<double> values;      // [columns]
  };
  std::vector<Row> rows;
};

// `limit`: the strain beyond which the area counts as strained too far. Below 0: the tested range of each
// diagram.
std::vector<ReportTable> report_of(drape_cloth* cloth, double limit);

// Tables to read. With the ending .csv, one value per line: table, what, column, value, unit.
std::string report_text(const std::vector<ReportTable>& report);
std::string report_csv(const std::vector<ReportTable>& report);

// Why the file could not be written; empty if it was.
std::string report_write(const std::filesystem::path& file, const std::vector<ReportTable>& report);

}  // namespace drape::command
