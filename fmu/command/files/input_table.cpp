#include "command/files/input_table.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "decimal.h"
#include "scene/diagnostics.h"
#include "scene/files.h"
#include "scene/spelling.h"

namespace drape::command {
namespace {

// The file being read, and the position in it.
struct Reading {
  const std::string& file;
  std::vector<std::string>& problems;
  std::size_t line = 0;  // counted from 1
};

// Appends a problem "FILE:3:2: ...", with line and column.
void complain(Reading& r, std::size_t column, const std::string& sentence) {
  r.problems.push_back(r.file + ":" + std::to_string(r.line) + ":" + std::to_string(column + 1) + ": " +
                       sentence);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// The cells of a line. A cell in double quotes may hold commas; two double quotes stand for one.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') cells.back() += line[++i];
    else if (line[i] == '"') quoted = !quoted;
    else if (line[i] == ',' && !quoted) cells.emplace_back();
    else cells.back() += line[i];
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

constexpr std::size_t kTime = std::size_t(-1), kUnknown = std::size_t(-2);

// The row of the variable table that a column is for; or kTime; or kUnknown, after reporting the reason.
std::size_t column_of(Reading& r, std::size_t column, const std::string& name,
                      const std::vector<description::Variable>& table) {
  if (name == "time") return kTime;
  const auto row = std::find_if(table.begin(), table.end(),
                                [&](const description::Variable& v) { return v.name() == name; });
  if (row != table.end() && row->causality == description::Causality::kInput)
    return std::size_t(row - table.begin());
  if (row != table.end()) {
    const bool output = row->causality == description::Causality::kOutput;
    complain(r, column,
             "'" + name + "' is " + (output ? "an output" : "a parameter, which --set sets") +
                 "; allowed: time and inputs");
    return kUnknown;
  }
  std::vector<std::string> names{"time"};
  for (const description::Variable& v : table)
    if (v.causality == description::Causality::kInput) names.push_back(v.name());
  const std::string nearest = scene::spelling_nearest(name, names);
  const std::string known =
      names.size() > 1 ? "`drape variables SCENE` lists the inputs" : "this scene has no inputs";
  complain(
      r, column,
      "'" + name + "' is no variable; " + (nearest.empty() ? known : "the nearest is '" + nearest + "'"));
  return kUnknown;
}

// The variables of the columns, in the order of the file. Every name may occur once, and the time must
// occur.
std::vector<std::size_t> header_read(Reading& r, const std::string& line,
                                     const std::vector<description::Variable>& table) {
  const std::vector<std::string> names = cells_of(line);
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    columns.push_back(column_of(r, k, names[k], table));
    const std::size_t first = std::size_t(std::find(names.begin(), names.end(), names[k]) - names.begin());
    if (first < k && columns[k] != kUnknown)
      complain(r, k, "'" + names[k] + "' is there already, in column " + std::to_string(first + 1));
  }
  if (std::find(columns.begin(), columns.end(), kTime) == columns.end())
    complain(r, 0, "the column 'time' is missing");
  return columns;
}

// Reads a cell. Returns false, after reporting the reason, if it is no number or one that its variable may
// not have.
bool cell_read(Reading& r, std::size_t column, const std::string& text, const description::Variable* variable,
               double& value) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';  // from_chars accepts no plus
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + plus, last, value);
  if (error != std::errc() || end != last) {
    complain(r, column, "'" + text + "'; allowed: a number");
    return false;
  }
  std::string problem;
  if (variable) problem = description::range_problem(*variable, value);
  else if (!std::isfinite(value))
    problem = "time is " + description::decimal_text(value) + " s; allowed: any finite number";
  if (!problem.empty()) complain(r, column, problem);
  return problem.empty();
}

void row_read(Reading& r, const std::string& line, const std::vector<std::size_t>& columns,
              const std::vector<description::Variable>& table, InputTable& inputs) {
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != columns.size()) {
    complain(r, std::min(cells.size(), columns.size()),
             std::to_string(cells.size()) + " cells; expected: " + std::to_string(columns.size()) +
                 ", as in the header");
    return;
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (columns[k] == kUnknown) continue;
    const description::Variable* variable = columns[k] == kTime ? nullptr : &table[columns[k]];
    double value = 0;
    const bool good = cell_read(r, k, cells[k], variable, value);
    if (variable) {
      inputs.value.push_back(value);
    } else if (good) {
      if (!inputs.time.empty() && !(value > inputs.time.back()))
        complain(r, k,
                 "time is " + cells[k] + " s; allowed: above the time before it, " +
                     description::decimal_text(inputs.time.back()) + " s");
      inputs.time.push_back(value);
    }
  }
}

// The largest change of a column's slope from one pair of rows to the next that are more than `step` apart.
double largest_jump(const InputTable& inputs, std::size_t column, double step) {
  const std::size_t columns = inputs.variable.size();
  const auto slope = [&](std::size_t row) {
    return (inputs.value[(row + 1) * columns + column] - inputs.value[row * columns + column]) /
           (inputs.time[row + 1] - inputs.time[row]);
  };
  const auto is_wide = [&](std::size_t row) { return inputs.time[row + 1] - inputs.time[row] > 1.5 * step; };
  double largest = 0;
  if (inputs.time.size() > 1 && is_wide(0)) largest = std::abs(slope(0));  // from rest
  for (std::size_t row = 0; row + 2 < inputs.time.size(); ++row)
    if (is_wide(row) || is_wide(row + 1)) largest = std::max(largest, std::abs(slope(row + 1) - slope(row)));
  return largest;
}

}  // namespace

InputTable input_table_read(const std::string& file, const std::vector<description::Variable>& table,
                            std::vector<std::string>& problems) {
  InputTable inputs;
  Reading r{file, problems};
  const std::size_t before = problems.size();
  if (const std::string hindrance = scene::file_hindrance(file, scene::kMaxData); !hindrance.empty()) {
    problems.push_back("cannot read " + file + ": " + hindrance);
    return inputs;
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::size_t> columns;
  for (std::string line; std::getline(stream, line);) {
    ++r.line;
    if (r.line == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
    if (trimmed(line).empty()) continue;
    if (columns.empty()) columns = header_read(r, line, table);
    else row_read(r, line, columns, table, inputs);
  }
  if (!stream.eof() || r.line == 0) {
    problems.push_back("cannot read " + file +
                       (errno ? std::string(": ") + std::strerror(errno) : ": it is empty"));
  } else if (problems.size() == before && inputs.time.empty()) {
    problems.push_back(file + " has no row of values; allowed: one or more below the header");
  }
  for (const std::size_t column : columns)
    if (column != kTime) inputs.variable.push_back(column);
  return problems.size() == before ? inputs : InputTable{};
}

void input_table_at(const InputTable& inputs, double time, double* values) {
  const std::size_t columns = inputs.variable.size(), rows = inputs.time.size();
  const std::size_t next =
      std::size_t(std::upper_bound(inputs.time.begin(), inputs.time.end(), time) - inputs.time.begin());
  const std::size_t a = next > 0 ? next - 1 : 0, b = std::min(next, rows - 1);
  const double length = inputs.time[b] - inputs.time[a];
  const double share = a < b ? (time - inputs.time[a]) / length : 0;
  for (std::size_t k = 0; k < columns; ++k) {
    const double from = inputs.value[a * columns + k], to = inputs.value[b * columns + k];
    values[k] = from + share * (to - from);
  }
}

void input_table_apply(const InputTable& inputs, double time,
                       const std::vector<description::Variable>& table) {
  std::vector<double> values(inputs.variable.size());
  input_table_at(inputs, time, values.data());
  for (std::size_t k = 0; k < values.size(); ++k) *table[inputs.variable[k]].setting = values[k];
}

std::vector<std::string> input_table_remarks(const InputTable& inputs,
                                             const std::vector<description::Variable>& table, double step) {
  constexpr double kSlow = 1e-3;       // m/s
  std::map<std::string, double> jump;  // of each body, m/s
  std::set<std::string> has_velocity;
  for (std::size_t k = 0; k < inputs.variable.size(); ++k) {
    const std::string& name = table[inputs.variable[k]].family;
    if (!name.starts_with("body.")) continue;
    const std::string body = name.substr(0, name.rfind('.'));
    if (name.ends_with(".velocity")) has_velocity.insert(body);
    if (name.ends_with(".position")) jump[body] = std::max(jump[body], largest_jump(inputs, k, step));
  }
  std::vector<std::string> remarks;
  for (const auto& [body, speed] : jump)
    if (speed > kSlow && !has_velocity.contains(body))
      remarks.push_back(
          body + " has positions alone, which are linear between rows: its velocity jumps by up to " +
          scene::rounded(speed) + " m/s at a row, and cloth may slip; wanted: rows " +
          description::decimal_text(step) + " s apart" +
          (description::variable_find(table, body + ".velocity[1]") ? ", or its velocities too" : ""));
  return remarks;
}

}  // namespace drape::command
