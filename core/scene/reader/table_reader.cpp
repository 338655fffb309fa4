#include "scene/reader/table_reader.h"

#include <algorithm>

#include "scene/spelling.h"

namespace drape::scene {

namespace {

// The path of a key. A key with a dot in it must be quoted in TOML, and is quoted here too.
std::string joined(const std::string& path, const std::string& key) {
  const std::string shown = key.find('.') == std::string::npos ? key : '"' + key + '"';
  return path.empty() ? shown : path + "." + shown;
}

// The component of a row's name directly below the table `prefix`; "" if the row is not in that table.
std::string key_within(const Key& key, const std::string& prefix) {
  if (!key.name.starts_with(prefix)) return "";
  return key.name.substr(prefix.size(), key.name.find('.', prefix.size()) - prefix.size());
}

void unknown_key(Faults& faults, const std::string& path, const std::string& name, const std::string& prefix,
                 const std::vector<Key>& keys) {
  std::vector<std::string> known;
  std::string all;
  for (const Key& key : keys) {
    const std::string name_known = key_within(key, prefix);
    if (name_known.empty()) continue;
    if (std::find(known.begin(), known.end(), name_known) != known.end()) continue;
    known.push_back(name_known);
    all += (all.empty() ? "" : ", ") + name_known;
  }
  const std::string nearest = spelling_nearest(name, known);
  fault_add(
      faults, path,
      "is no known key; " + (nearest.empty() ? "known: " + all : "the nearest is " + in_quotes(nearest)));
}

void level_read(Faults& faults, const toml::table& table, const std::string& path, const std::string& prefix,
                const std::vector<Key>& keys) {
  for (auto&& [toml_key, node] : table) {
    const std::string name(toml_key.str()), at = joined(path, name);
    if (toml_key.source().path)
      faults.locations[at] = {*toml_key.source().path, toml_key.source().begin.line};
    const bool plain = name.find('.') == std::string::npos;  // the dotted name of a row is no key
    const auto row =
        std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == prefix + name; });
    const bool is_table = std::any_of(keys.begin(), keys.end(), [&](const Key& k) {
      return k.name != prefix + name && key_within(k, prefix) == name;
    });
    const bool is_value = plain && row != keys.end() &&
                          (!is_table || node.is_string());  // a string can be given in place of a table
    if (is_value) value_read(faults, at, *row, node);
    else if (!is_table) unknown_key(faults, at, name, prefix, keys);
    else if (node.is_table()) level_read(faults, *node.as_table(), at, prefix + name + ".", keys);
    else
      fault_add(faults, at,
                std::string("is ") + node_kind(node) + "; wanted: a table" +
                    (row != keys.end() ? " or " + key_expected(*row) : ""));
  }
  for (const Key& key : keys)
    if (key.required && key.name == prefix + key_within(key, prefix) &&
        !table.contains(key.name.substr(prefix.size())))
      fault_add(faults, joined(path, key.name.substr(prefix.size())),
                "is missing; wanted: " + key_expected(key));
}

}  // namespace

void keys_read(Faults& faults, const toml::table& table, const std::string& path,
               const std::vector<Key>& keys) {
  level_read(faults, table, path, "", keys);
}

}  // namespace drape::scene
