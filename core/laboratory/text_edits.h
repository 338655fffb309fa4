// Edits of a TOML text: keys are set, added and removed. All other text is unchanged, comments and line ends
// included.
#pragma once
#include <string>
#include <vector>

#include "scene/reader/document.h"

namespace drape::laboratory {

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
Draft draft_of(const std::string& text);

std::string six_digits(double value);

// A list of numbers of six digits. A long one has lines of eight, unless it is to stay in its line.
std::string list_text(const std::vector<double>& values, bool in_line, const std::string& newline);

// The text of a value as it stands.
std::string value_text(const Draft& draft, const toml::node& value);

void value_replace(Draft& draft, const toml::node& value, const std::string& by);

// Removes a key from a table: its lines, or its part between the commas of an inline table.
void key_remove(Draft& draft, const toml::table& table, const std::string& key);

// Adds `key` next to the value of `old_key` in a table of the document.
void key_add(Draft& draft, const toml::table& table, const std::string& old_key, const std::string& key,
             const std::string& value);

// Sets the value of `key`, or adds it next to that of `old_key`.
void key_set(Draft& draft, const toml::table& table, const std::string& old_key, const std::string& key,
             const std::vector<double>& values);

// The text with all edits.
std::string draft_text(const Draft& draft);

// True where a value of the document is a list of these numbers, to six digits; with none, where it is
// absent.
bool has_values(toml::node_view<const toml::node> value, const std::vector<double>& values);

}  // namespace drape::laboratory
