#include "scene/reader/value_reader.h"

#include <algorithm>
#include <optional>

#include "scene/reader/table_reader.h"
#include "scene/spelling.h"

namespace drape::scene {

namespace {

// Stores one value at its destination, or adds a fault. Nothing is stored from a list with a fault.
struct ValueReader {
  Faults& faults;
  const std::string& path;
  const Key& key;
  const toml::node& node;

  void misfit(const std::string& at, const toml::node& found, const std::string& want) const {
    location_note(faults, at, found);
    fault_add(faults, at, std::string("is ") + node_kind(found) + "; wanted: " + want);
  }

  std::optional<double> number(const toml::node& n, const std::string& at) const {
    double value;
    if (const auto* floating = n.as_floating_point()) value = floating->get();
    else if (const auto* whole = n.as_integer()) value = static_cast<double>(whole->get());
    else return misfit(at, n, key_number_expected(key)), std::nullopt;
    const Range& r = key.range;
    if (value >= r.low && value <= r.high && !(r.above && value == r.low)) return value / key.per_si;
    location_note(faults, at, n);
    fault_add(faults, at, "= " + key_number(key, value) + "; allowed: " + key_range(key));
    return std::nullopt;
  }

  std::optional<int> whole(const toml::node& n, const std::string& at) const {
    if (!n.is_integer()) return misfit(at, n, "a whole number"), std::nullopt;
    if (const auto value = number(n, at)) return static_cast<int>(*value);
    return std::nullopt;
  }

  // The node as a list of `count` entries; null after adding a fault.
  const toml::array* list_of(const toml::node& n, const std::string& at, std::size_t count,
                             const std::string& want) const {
    const toml::array* list = n.as_array();
    if (!list) return misfit(at, n, want), nullptr;
    if (list->size() == count) return list;
    location_note(faults, at, n);
    return fault_add(faults, at, "has " + entries_text(list->size()) + "; wanted: " + want), nullptr;
  }

  template <std::size_t N>
  std::optional<std::array<double, N>> fixed(const toml::node& n, const std::string& at) const {
    const Key of_these{key.name, static_cast<std::array<double, N>*>(nullptr), key.required, key.range,
                       key.unit};
    const toml::array* list = list_of(n, at, N, key_expected(of_these));
    if (!list) return std::nullopt;
    std::array<double, N> values;
    bool complete = true;
    for (std::size_t i = 0; i < N; ++i) {
      const auto value = number((*list)[i], entry(at, i));
      complete = complete && value;
      values[i] = value.value_or(0);
    }
    return complete ? std::optional(values) : std::nullopt;
  }

  // Leaves one fault where more than a few entries of a list have one: a list of noise has hundreds.
  void entries_condense(std::size_t before) const {
    constexpr std::size_t kEach = 3;
    const std::size_t count = faults.found.size() - before;
    if (count <= kEach) return;
    faults.found.resize(before + 1);
    faults.found.back().problem.message +=
        "; " + std::to_string(count - 1) + " more entries are not allowed either";
  }

  // A list with at least one entry, each read by `read`. `nested`: the entries are lists themselves.
  template <class Read>
  auto list(const toml::node& n, const std::string& at, const std::string& want, bool nested, Read read) const
      -> std::optional<std::vector<typename decltype(read(n, at))::value_type>> {
    const toml::array* entries = n.as_array();
    const auto flat = [](const toml::node& e) { return !e.is_array(); };
    if (!entries) return misfit(at, n, want), std::nullopt;
    location_note(faults, at, n);
    if (entries->empty()) return fault_add(faults, at, "is an empty list; wanted: " + want), std::nullopt;
    if (nested && std::all_of(entries->begin(), entries->end(), flat))
      return fault_add(faults, at, "is a flat list; wanted: " + want), std::nullopt;
    std::vector<typename decltype(read(n, at))::value_type> values;
    const std::size_t before = faults.found.size();
    for (std::size_t i = 0; i < entries->size(); ++i)
      if (auto value = read((*entries)[i], entry(at, i))) values.push_back(std::move(*value));
    if (!nested) entries_condense(before);
    if (values.size() != entries->size()) return std::nullopt;
    return values;
  }

  std::optional<std::vector<Vec2>> points(const toml::node& n, const std::string& at) const {
    const Key of_these{key.name, static_cast<std::vector<Vec2>*>(nullptr), key.required, key.range, key.unit};
    return list(n, at, key_expected(of_these), true,
                [&](const toml::node& e, const std::string& e_at) { return fixed<2>(e, e_at); });
  }

  template <class T, class U>
  static void put(T* to, std::optional<U> value) {
    if (value) *to = std::move(*value);
  }

  // A string, passed on to `use`.
  template <class Use>
  void word(Use use) const {
    if (const auto* text = node.as_string()) use(text->get());
    else misfit(path, node, key_expected(key));
  }

  void operator()(Elsewhere) const {}
  void operator()(const OneOf& one) const {
    const auto* whole = node.as_integer();
    if (!whole) return misfit(path, node, key_expected(key));
    const auto it = std::find(one.numbers.begin(), one.numbers.end(), whole->get());
    if (it != one.numbers.end()) *one.to = static_cast<int>(*it);
    else fault_add(faults, path, "= " + std::to_string(whole->get()) + "; allowed: " + key_expected(key));
  }
  void operator()(std::string* to) const {
    word([&](const std::string& text) { *to = text; });
  }
  void operator()(const Name& name) const {
    word([&](const std::string& text) {
      *name.to = text;
      if (!name_fits(text)) fault_add(faults, path, "= " + in_quotes(text) + " " + kNameRule);
    });
  }
  void operator()(const Auto& automatic) const {
    const auto* text = node.as_string();
    if (text && text->get() == "auto") *automatic.to = 0;
    else if (text) fault_add(faults, path, "= " + in_quotes(text->get()) + "; wanted: " + key_expected(key));
    else put(automatic.to, number(node, path));
  }
  void operator()(const Flag& flag) const {
    if (const auto* value = node.as_boolean()) *flag.to = value->get();
    else misfit(path, node, key_expected(key));
  }
  void operator()(const Choice& choice) const {
    word([&](const std::string& text) {
      const auto it = std::find(choice.words.begin(), choice.words.end(), text);
      if (it != choice.words.end()) return choice.apply(static_cast<int>(it - choice.words.begin()));
      fault_add(faults, path, "= " + in_quotes(text) + "; allowed: " + key_expected(key));
    });
  }
  void operator()(const Reference& reference) const {
    word([&](const std::string& text) {
      const auto it = std::find(reference.names->begin(), reference.names->end(), text);
      if (it != reference.names->end()) *reference.to = static_cast<int>(it - reference.names->begin());
      else if (reference.names->empty())
        fault_add(faults, path, "= " + in_quotes(text) + ", but the scene has no " + reference.kind);
      else
        fault_add(faults, path,
                  "= " + in_quotes(text) + " names no " + reference.kind +
                      "; known: " + words_text(*reference.names));
    });
  }
  void operator()(double* to) const { put(to, number(node, path)); }
  void operator()(int* to) const { put(to, whole(node, path)); }
  void operator()(const Whole& w) const {
    if (!node.is_integer()) return misfit(path, node, key_expected(key));
    if (number(node, path)) *w.to = node.as_integer()->get();
  }
  void operator()(const Pair& pair) const {
    if (!node.is_array()) {
      if (!node.is_number()) return misfit(path, node, key_expected(key));
      if (const auto value = number(node, path)) *pair.to = {*value, *value};
    } else if (list_of(node, path, 2, key_expected(key))) {
      put(pair.to, fixed<2>(node, path));
    }
  }
  void operator()(Vec2* to) const { put(to, fixed<2>(node, path)); }
  void operator()(std::optional<Vec2>* to) const { put(to, fixed<2>(node, path)); }
  void operator()(Vec3* to) const { put(to, fixed<3>(node, path)); }
  void operator()(std::vector<double>* to) const {
    put(to, list(node, path, key_expected(key), false,
                 [&](const toml::node& n, const std::string& at) { return number(n, at); }));
  }
  void operator()(std::vector<int>* to) const {
    put(to, list(node, path, key_expected(key), false,
                 [&](const toml::node& n, const std::string& at) { return whole(n, at); }));
  }
  void operator()(std::vector<Vec2>* to) const { put(to, points(node, path)); }
  // An empty list is allowed here.
  void operator()(std::vector<std::vector<Vec2>>* to) const {
    if (const toml::array* none = node.as_array(); none && none->empty()) return;
    put(to, list(node, path, key_expected(key), true,
                 [&](const toml::node& n, const std::string& at) { return points(n, at); }));
  }
  void operator()(const Tables& tables) const {
    const toml::array* entries = node.as_array();
    if (!entries) return misfit(path, node, key_expected(key));
    for (std::size_t i = 0; i < entries->size(); ++i) {
      const toml::node& n = (*entries)[i];
      location_note(faults, entry(path, i), n);
      if (n.is_table()) keys_read(faults, *n.as_table(), entry(path, i), tables.add());
      else misfit(entry(path, i), n, "a table");
    }
  }
};

}  // namespace

void value_read(Faults& faults, const std::string& path, const Key& key, const toml::node& node) {
  std::visit(ValueReader{faults, path, key, node}, key.destination);
}

}  // namespace drape::scene
