#include "table_rows.h"

namespace drape::description {

std::string description_markdown(const Description& d) {
  std::string text;
  const auto print_row = [&](const auto& cells, const char* quote) {
    for (std::size_t i = 0; i < std::size(cells); ++i)
      text += std::string(i == 0 ? "| " : " | ") + (i == 0 ? quote : "") + cells[i] + (i == 0 ? quote : "");
    text += " |\n";
  };
  print_row(kColumns, "");
  for (std::size_t i = 0; i < std::size(kColumns); ++i) text += "|---";
  text += "|\n";
  for (const TableRow& row : table_rows_of(d)) print_row(row, "`");
  return text;
}

}  // namespace drape::description
