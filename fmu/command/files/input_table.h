// Inputs over time from a CSV file: a column `time` and any input variables. Values are linear between the
// rows; before the first and after the last row, that row holds.
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

// Reads a file and checks it against a variable table. Appends one sentence for every problem.
InputTable input_table_read(const std::string& file, const std::vector<description::Variable>& table,
                            std::vector<std::string>& problems);

// Remarks on bodies that are moved by positions alone, on rows farther apart than `step` (s): their velocity
// jumps at every row.
std::vector<std::string> input_table_remarks(const InputTable& inputs,
                                             const std::vector<description::Variable>& table, double step);

// The values [columns] at a time (s), in the order of the columns.
void input_table_at(const InputTable& inputs, double time, double* values);

// Writes the values at a time (s) to the variables of the table.
void input_table_apply(const InputTable& inputs, double time,
                       const std::vector<description::Variable>& table);

}  // namespace drape::command
