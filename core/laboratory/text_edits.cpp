#include "laboratory/text_edits.h"

#include <algorithm>
#include <cstdio>

namespace drape::laboratory {
namespace {

constexpr std::size_t kOneLine = 8;  // numbers in one line; a longer list is broken into lines of as many

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

}  // namespace

Draft draft_of(const std::string& text) {
  return {text, text.find("\r\n") == std::string::npos ? "\n" : "\r\n", {}};
}

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

std::string value_text(const Draft& draft, const toml::node& value) {
  const std::size_t begin = byte_of(draft.text, value.source().begin);
  return draft.text.substr(begin, byte_of(draft.text, value.source().end) - begin);
}

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

void value_replace(Draft& draft, const toml::node& value, const std::string& by) {
  draft.edits.push_back(
      {byte_of(draft.text, value.source().begin), byte_of(draft.text, value.source().end), by});
}

void key_add(Draft& draft, const toml::table& table, const std::string& old_key, const std::string& key,
             const std::string& value) {
  const std::string &text = draft.text, &newline = draft.newline;
  const toml::node* old = table.get(old_key);
  if (!old) return;
  const std::size_t begin = byte_of(text, old->source().begin), end = byte_of(text, old->source().end);
  if (table.is_inline()) {
    draft.edits.push_back({end, end, ", " + key + " = " + value});
    return;
  }
  // The same indentation and dotted prefix as the old key, on a new line below the old value.
  const std::size_t line = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
  const std::size_t name = text.rfind(old_key, begin);
  const std::string before = name == std::string::npos || name < line ? "" : text.substr(line, name - line);
  std::size_t after = std::min(text.find('\n', end), text.size());
  if (after > end && text[after - 1] == '\r') --after;
  draft.edits.push_back({after, after, newline + before + key + " = " + value});
}

void key_set(Draft& draft, const toml::table& table, const std::string& old_key, const std::string& key,
             const std::vector<double>& values) {
  const std::string list = list_text(values, table.is_inline(), draft.newline);
  if (const toml::node* there = table.get(key)) value_replace(draft, *there, list);
  else key_add(draft, table, old_key, key, list);
}

std::string draft_text(const Draft& draft) {
  std::string text = draft.text;
  // From the end to the beginning, so that the places of edits to come stay; at one place the last first.
  std::vector<Edit> edits(draft.edits.rbegin(), draft.edits.rend());
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
  for (const Edit& e : edits) text.replace(e.begin, e.end - e.begin, e.text);
  return text;
}

bool has_values(toml::node_view<const toml::node> value, const std::vector<double>& values) {
  const toml::array* list = value.as_array();
  if (values.empty()) return !value;
  if (!list || list->size() != values.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (six_digits((*list)[i].value_or(0.0)) != six_digits(values[i])) return false;
  return true;
}

}  // namespace drape::laboratory
