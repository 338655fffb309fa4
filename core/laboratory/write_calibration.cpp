#include "laboratory/write_calibration.h"

#include <algorithm>
#include <cstdio>

#include "scene/reader/document.h"

namespace drape::laboratory {
namespace {

constexpr std::size_t kOneLine = 8;  // numbers in one line; a longer list is broken into lines of as many

struct Edit {
  std::size_t begin, end;  // bytes
  std::string text;
};

// A text and the edits that are still to be applied to it.
struct Draft {
  const std::string& text;
  std::string newline;
  std::vector<Edit> edits;
};

std::string six_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::string(text).find_first_of(".e") == std::string::npos ? std::string(text) + ".0" : text;
}

std::string list_text(const std::vector<double>& values, bool in_line, const std::string& newline) {
  const bool broken = !in_line && values.size() > kOneLine + 3;
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (broken && i % kOneLine == 0) text += newline + "  ";
    else if (i > 0) text += ' ';
    text += six_digits(values[i]);
    if (broken || i + 1 < values.size()) text += ',';
  }
  return text + (broken ? newline + "]" : "]");
}

// The byte at a line and column of the parser, which counts characters from 1.
std::size_t byte_of(const std::string& text, toml::source_position at) {
  std::size_t k = 0;
  for (unsigned line = 1; line < at.line && k < text.size(); ++k)
    if (text[k] == '\n') ++line;
  for (unsigned column = 1; column < at.column && k < text.size(); ++column) {
    ++k;
    while (k < text.size() && (static_cast<unsigned char>(text[k]) & 0xC0) == 0x80) ++k;
  }
  return k;
}

// Removes a key from a table: its lines, or its part between the commas of an inline table.
void key_remove(Draft& draft, const toml::table& table, const std::string& key) {
  const std::string& text = draft.text;
  const toml::node* there = table.get(key);
  if (!there) return;
  std::size_t begin = text.rfind(key, byte_of(text, there->source().begin)),
              end = byte_of(text, there->source().end);
  if (begin == std::string::npos) return;
  if (table.is_inline()) {
    const std::size_t before = text.find_last_not_of(" \t\r\n", begin - 1);
    if (text[before] == ',') begin = before;
    else if (const std::size_t after = text.find_first_not_of(" \t\r\n", end); text[after] == ',')
      end = text.find_first_not_of(" \t", after + 1);
  } else {
    begin = text.rfind('\n', begin) + 1;
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  draft.edits.push_back({begin, end, ""});
}

// Sets `key` next to the value of `old_key` in a table of the document.
void key_set(Draft& draft, const toml::table& table, const std::string& old_key, const std::string& key,
             const std::vector<double>& values) {
  const std::string &text = draft.text, &newline = draft.newline;
  const auto region = [&](const toml::node& node) {
    return std::pair(byte_of(text, node.source().begin), byte_of(text, node.source().end));
  };
  if (const toml::node* there = table.get(key)) {
    const auto [begin, end] = region(*there);
    draft.edits.push_back({begin, end, list_text(values, table.is_inline(), newline)});
    return;
  }
  const toml::node* old = table.get(old_key);
  if (!old) return;
  const auto [begin, end] = region(*old);
  if (table.is_inline()) {
    draft.edits.push_back({end, end, ", " + key + " = " + list_text(values, true, newline)});
    return;
  }
  // The same indentation and dotted prefix as the old key, on a new line below the old value.
  const std::size_t line = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
  const std::size_t name = text.rfind(old_key, begin);
  const std::string before = name == std::string::npos || name < line ? "" : text.substr(line, name - line);
  std::size_t after = std::min(text.find('\n', end), text.size());
  if (after > end && text[after - 1] == '\r') --after;
  draft.edits.push_back({after, after, newline + before + key + " = " + list_text(values, false, newline)});
}

// Corrections of diagrams from data sheets, which have no table of their own: by direction.
using SheetCorrections = std::vector<std::pair<std::string, std::vector<double>>>;

void calibration_set(Draft& draft, const toml::table& root, const Calibration& c, const std::string& date,
                     const SheetCorrections& sheets) {
  const std::string &text = draft.text, &newline = draft.newline;
  const std::pair<const char*, std::string> keys[] = {
      {"cell", six_digits(c.cell)}, {"residual", six_digits(c.residuals.back())}, {"date", '"' + date + '"'}};
  const toml::table* table = root["calibration"].as_table();
  if (!table) {
    const char* const units[] = {"   # m", "   # largest difference between simulated strips and diagrams",
                                 ""};
    std::string added = text.empty() || text.back() == '\n' ? "" : newline;
    added += newline + "# By drape fabric calibrate: where the corrections come from" + newline +
             "[calibration]" + newline;
    for (int k = 0; k < 3; ++k)
      added += std::string(keys[k].first) + " = " + keys[k].second + units[k] + newline;
    for (const auto& [name, values] : sheets)
      added += name + " = " + list_text(values, false, newline) + newline;
    draft.edits.push_back({text.size(), text.size(), added});
    return;
  }
  for (const auto& [key, value] : keys)
    if (const toml::node* there = table->get(key))
      draft.edits.push_back(
          {byte_of(text, there->source().begin), byte_of(text, there->source().end), value});
  for (const auto& [name, values] : sheets) key_set(draft, *table, "date", name, values);
}

std::string edited(std::string text, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  for (auto e = edits.rbegin(); e != edits.rend(); ++e) text.replace(e->begin, e->end - e->begin, e->text);
  return text;
}

// True where a key of the document has these values, to six digits.
bool has_values(const toml::table& root, const char* table, const char* key,
                const std::vector<double>& values) {
  const toml::array* list = root[table][key].as_array();
  if (values.empty()) return !root[table][key];
  if (!list || list->size() != values.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (six_digits((*list)[i].value_or(0.0)) != six_digits(values[i])) return false;
  return true;
}

}  // namespace

std::string write_calibration(const std::string& text, const Calibration& c, const std::string& date,
                              std::vector<Problem>& problems) {
  const std::string newline = text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  const model::YarnDirection directions[] = {model::YarnDirection::kWarp, model::YarnDirection::kWeft,
                                             model::YarnDirection::kBias};
  try {
    const toml::table root = toml::parse(text);
    Draft draft{text, newline, {}};
    SheetCorrections sheets;
    for (model::YarnDirection along : directions) {
      const scene::DiagramSpec& d = strip_diagram(c.fabric, along);
      const toml::table* table = root[yarn_direction_name(along)].as_table();
      if (d.correction.empty()) continue;
      if (!table) {
        sheets.push_back({yarn_direction_name(along), d.correction});
        continue;
      }
      if (d.correction_elongation.empty()) key_remove(draft, *table, "correction_elongation");
      else key_set(draft, *table, d.force_as.key, "correction_elongation", d.correction_elongation);
      key_set(draft, *table, d.force_as.key, "correction", d.correction);
    }
    calibration_set(draft, root, c, date, sheets);
    std::string stored = edited(text, draft.edits);
    const toml::table after = toml::parse(stored);
    bool good = after["calibration"]["date"].value_or(std::string()) == date;
    for (model::YarnDirection along : directions) {
      const scene::DiagramSpec& d = strip_diagram(c.fabric, along);
      const bool sheet = !after[yarn_direction_name(along)].is_table();
      good = good && (sheet ? has_values(after, "calibration", yarn_direction_name(along), d.correction)
                            : has_values(after, yarn_direction_name(along), "correction", d.correction) &&
                                  has_values(after, yarn_direction_name(along), "correction_elongation",
                                             d.correction_elongation));
    }
    if (good) return stored;
  } catch (const toml::parse_error&) {
  }
  problems.push_back({"fabric." + c.fabric.name,
                      "does not take corrections where its tables stand; wanted: "
                      "tables [warp], [weft] and [bias] with a key on each line"});
  return "";
}

}  // namespace drape::laboratory
