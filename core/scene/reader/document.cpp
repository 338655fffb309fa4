#include "scene/reader/document.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

#include "scene/files.h"
#include "standards/strip.h"

namespace drape::scene {

namespace {

namespace fs = std::filesystem;

// The text of a file. Where it cannot be read, `hindrance` is the reason.
std::string file_text(const fs::path& file, std::string& hindrance) {
  hindrance = file_hindrance(file, kMaxText);
  if (!hindrance.empty()) return "";
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return hindrance = "cannot be opened", "";
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The first line of a text whose key is of more than kMaxDepth parts, a.b.c...; 0 if there is none. The
// parser goes one call deeper for every part.
unsigned deep_line(const std::string& text) {
  constexpr int kMaxDepth = 256;
  int dots = 0;
  unsigned line = 1;
  char quote = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    line += c == '\n';
    if (quote) {
      if (c == '\\' && quote == '"') {
        ++k;
        line += k < text.size() && text[k] == '\n';
      } else if (c == quote || c == '\n') {
        quote = 0;
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '.') {
      if (++dots >= kMaxDepth) return line;
    } else if (c == '#') {
      k = std::min(text.find('\n', k), text.size()) - 1;
    } else if (std::string_view("=,{}[]\n").find(c) != std::string_view::npos) {
      dots = 0;
    }
  }
  return 0;
}

// The first of the least whole numbers, which toml++ cannot print: it negates them. Null if there is none.
const toml::node* least_integer(const toml::node& node) {
  if (const auto* number = node.as_integer())
    return number->get() == std::numeric_limits<std::int64_t>::min() ? &node : nullptr;
  const toml::node* found = nullptr;
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& one : *list)
      if (!found) found = least_integer(one);
  } else if (const toml::table* table = node.as_table()) {
    for (const auto& [key, one] : *table)
      if (!found) found = least_integer(one);
  }
  return found;
}

// The table of a TOML text. Adds a fault where the text is not valid.
std::optional<toml::table> text_parse(const std::string& text, const std::string& file, Faults& faults) {
  if (const unsigned line = deep_line(text)) {
    fault_add_at(faults, {file, line}, file + ":" + std::to_string(line) + ":",
                 "has a key of 257 or more parts; allowed: up to 256");
    return std::nullopt;
  }
  try {
    toml::table table = toml::parse(text, file);
    const toml::node* least = least_integer(table);
    if (!least) return table;
    const unsigned line = least->source().begin.line;
    fault_add_at(faults, {file, line}, file + ":" + std::to_string(line) + ":",
                 "has the whole number -9223372036854775808; allowed: from -9223372036854775807");
    return std::nullopt;
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    const Location place{file, at.line};
    const std::string where = file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ":";
    fault_add_at(faults, place, where, "is not valid TOML: " + std::string(error.description()));
    return std::nullopt;
  }
}

// Adds to `over` the keys that only `base` has; tables in both are merged recursively. Nodes are moved,
// because a copy loses its line number.
void table_underlay(toml::table& over, toml::table&& base) {
  for (auto&& [key, node] : base) {
    toml::node* own = over.get(key);
    if (own && own->is_table() && node.is_table())
      table_underlay(*own->as_table(), std::move(*node.as_table()));
    else if (!own) node.visit([&, &name = key](auto& value) { over.insert(name, std::move(value)); });
  }
}

// Drops the corrections of the fabric file where they do not apply. Corrections belong to the points that
// they were found for. A diagram with elongations, a data sheet or a strip given in the scene has other
// points.
void corrections_drop(const toml::table& own, toml::table& base) {
  toml::table* calibration = base["calibration"].as_table();
  for (const char* diagram : {"warp", "weft", "bias"}) {
    if (calibration && (own.contains("kes") || own.contains("fast") || own.contains(diagram)))
      calibration->erase(diagram);
    toml::table* table = base[diagram].as_table();
    const auto has = [&](const char* key) { return bool(own[diagram][key]); };
    const bool elsewhere = own.contains("strip") || has("jaws");
    if (!table || !(elsewhere || has("elongation_percent") || has("extension_mm") || has("extension_in")))
      continue;
    table->erase("correction");
    table->erase("correction_elongation");
  }
}

// Expands a strip that the fabric file gives by the name of a standard, where the scene has a table `strip`
// which may override one of its two figures.
void strip_spell(const toml::table& own, toml::table& base) {
  const toml::node* strip = base.get("strip");
  if (!own["strip"].is_table() || !strip || !strip->is_string()) return;
  for (const standards::StripStandard& standard : standards::kStripStandards)
    if (strip->as_string()->get() == standard.name)
      return void(
          base.insert_or_assign("strip", toml::table{{"width", standard.width}, {"gauge", standard.gauge}}));
}

// Merges the file that a fabric names into the table of the fabric. False if the file cannot be read.
bool fabric_file_merge(toml::table& fabric, const std::string& path, const fs::path& folder, Faults& faults,
                       std::vector<fs::path>& files) {
  const toml::node* named = fabric.get("file");
  if (!named || !named->is_string()) return true;
  const std::string& name = named->as_string()->get();
  const std::string key = path + ".file";
  faults.locations[key] = {faults.file, named->source().begin.line};

  const fs::path file = (folder / path_of(name)).lexically_normal();
  files.push_back(file);
  std::string hindrance;
  const std::string text = file_text(file, hindrance);
  if (!hindrance.empty()) {
    fault_add(faults, key,
              "= " + in_quotes(name) + ": " + hindrance + " (looked for " + path_text(file) + ")");
    return false;
  }
  std::optional<toml::table> base = text_parse(text, path_text(file), faults);
  if (!base) return false;
  if (const toml::node* another = base->get("file")) {
    faults.locations[key] = {path_text(file), another->source().begin.line};
    fault_add(faults, key, "stands in a fabric file; a fabric file cannot name another one");
  }
  corrections_drop(fabric, *base);
  strip_spell(fabric, *base);
  table_underlay(fabric, std::move(*base));
  return true;
}

}  // namespace

void calibration_drop(toml::table& fabric) {
  fabric.erase("calibration");
  for (const char* diagram : {"warp", "weft", "bias"})
    if (toml::table* table = fabric[diagram].as_table())
      table->erase("correction"), table->erase("correction_elongation");
}

Document document_load_file(const std::filesystem::path& file, Faults& faults) {
  Document document;
  faults.file = path_text(file);
  document.files.push_back(file);
  std::string hindrance;
  const std::string text = file_text(file, hindrance);
  if (!hindrance.empty()) return fault_add(faults, "", hindrance), document;
  std::optional<toml::table> root = text_parse(text, faults.file, faults);
  if (!root) return document;
  if (root->empty()) return fault_add(faults, "", "holds no keys"), document;

  document.root = std::move(*root);
  document.loaded = true;
  return document;
}

Document document_load(const std::filesystem::path& file, Faults& faults) {
  Document document = document_load_file(file, faults);
  if (toml::table* fabrics = document.root["fabric"].as_table())
    for (auto&& [name, node] : *fabrics)
      if (toml::table* fabric = node.as_table();
          fabric && !fabric_file_merge(*fabric, "fabric." + std::string(name.str()), file.parent_path(),
                                       faults, document.files))
        document.unread.emplace(name.str());
  return document;
}

}  // namespace drape::scene
