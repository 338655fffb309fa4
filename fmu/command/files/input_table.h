// Inputs over time from a CSV file: a column `time` and any input variables, linear between the rows; the
// first and the last row hold outside.
#pragma once
#include <string>
#include <vector>

#include "variables.h"

namespace drape::command {

struct InputTable {
  std::vector<std::size_t> variable;  // [columns] indices into the variable table
  std::vector<double> time;           // [rows] s, rising
  std::vector<double> value;          // [rows x columns]
};

// Reads and checks a file against a variable table: every problem of it, one sentence each.
InputTable input_table_read(const std::string& file, const std::vector<description::Variable>& table,
                            std::vector<std::string>& problems);

// The values at a time, column by column.
void input_table_at(const InputTable& inputs, double time, double* values);

// Writes the values at a time to where the table's rows have them.
void input_table_apply(const InputTable& inputs, double time,
                       const std::vector<description::Variable>& table);

}  // namespace drape::command
