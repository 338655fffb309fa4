#include "scene/datasheet/alternatives.h"

#include <algorithm>

namespace drape::scene {

namespace {

bool in_scene(const Conversion& s, const std::string& key) {
  const toml::source_region& source = stated(s, key)->source();
  return !source.path || *source.path == s.faults.file;
}

}  // namespace

const toml::node* stated(const Conversion& s, const std::string& key) {
  const toml::node* node = &s.table;
  for (std::size_t from = 0; node && from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    node = node->is_table() ? node->as_table()->get(key.substr(from, dot - from)) : nullptr;
    from = dot + 1;
  }
  return node;
}

bool valid(const Conversion& s, const std::string& key) {
  return stated(s, key) && !fault_within(s.faults, s.path + "." + key);
}

void fault_at(const Conversion& s, const std::string& key, const std::string& message) {
  fault_add(s.faults, s.path + "." + key, message);
}

void fault_at(const Conversion& s, const std::string& key, std::size_t k, const std::string& message) {
  const toml::node* node = stated(s, key);
  const std::string at = node && node->is_array() ? key + "[" + std::to_string(k) + "]" : key;
  const std::string path = s.path + "." + at;
  const bool reported =
      std::any_of(s.faults.found.begin(), s.faults.found.end(),
                  [&](const Faults::Found& f) { return f.path == path && f.problem.message == message; });
  if (!reported) fault_at(s, at, message);
}

bool same_text(const Conversion& s, const std::string& a, const std::string& b) {
  return in_scene(s, a) == in_scene(s, b);
}

std::string property_source(const Conversion& s, const std::string& property,
                            const std::vector<std::string>& keys) {
  std::vector<std::string> given;
  bool from_scene = false;
  for (const std::string& key : keys) {
    if (!stated(s, key)) continue;
    const bool own = in_scene(s, key);
    if (own && !from_scene) given.clear();
    if (own || !from_scene) given.push_back(key);
    from_scene = from_scene || own;
  }
  for (std::size_t k = 1; k < given.size(); ++k)
    fault_at(s, given[k], "states the " + property + ", as " + given[0] + " does; wanted: one of them");
  return given.empty() ? "" : given[0];
}

}  // namespace drape::scene
