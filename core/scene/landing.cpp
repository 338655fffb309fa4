#include "scene/landing.h"

#include <algorithm>
#include <optional>

namespace drape {

namespace {

std::string entry(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

std::string with_unit(const std::string& number, const Key& key) {
  return *key.unit ? number + " " + key.unit : number;
}

std::string words_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + in_quotes(word);
  return text;
}

std::string range_text(const Key& key) {
  const Range& r = key.range;
  const std::string high = with_unit(number_text(r.high), key);
  return r.above ? "above " + number_text(r.low) + ", at most " + high
                 : "from " + number_text(r.low) + " to " + high;
}

// What a key takes, for messages.
struct Wanted {
  const Key& key;
  std::string of(const char* what) const { return *key.unit ? std::string(what) + " in " + key.unit : what; }

  std::string operator()(Elsewhere) const { return "a table"; }
  std::string operator()(Later) const { return "nothing"; }
  std::string operator()(std::string*) const { return "a text"; }
  std::string operator()(const Name&) const { return "a name in quotes"; }
  std::string operator()(double*) const { return of("a number"); }
  std::string operator()(const Auto&) const { return "\"auto\" or " + of("a number"); }
  std::string operator()(const Flag&) const { return "true or false"; }
  std::string operator()(const Choice& c) const { return words_text(c.words); }
  std::string operator()(const Reference& r) const { return std::string("the name of a ") + r.kind; }
  std::string operator()(Vec2*) const { return of("a list of two numbers"); }
  std::string operator()(Vec3*) const { return of("a list of three numbers"); }
  std::string operator()(std::vector<double>*) const { return of("a list of numbers"); }
  std::string operator()(std::vector<int>*) const { return of("a list of whole numbers"); }
  std::string operator()(std::vector<Vec2>*) const { return of("a list of points [[x, y], ...]"); }
};

// Puts one value where it belongs, or adds a fault. Nothing lands from a list with a fault.
struct Land {
  Faults& faults;
  const std::string& path;
  const Key& key;
  const toml::node& node;

  void misfit(const std::string& at, const toml::node& found, const std::string& want) const {
    place_note(faults, at, found);
    fault_add(faults, at, std::string("is ") + node_kind(found) + "; wanted: " + want);
  }

  std::optional<double> number(const toml::node& n, const std::string& at) const {
    double value;
    if (const auto* floating = n.as_floating_point()) value = floating->get();
    else if (const auto* whole = n.as_integer()) value = static_cast<double>(whole->get());
    else return misfit(at, n, Wanted{key}.of("a number")), std::nullopt;
    const Range& r = key.range;
    if (value >= r.low && value <= r.high && !(r.above && value == r.low)) return value / key.per_si;
    place_note(faults, at, n);
    fault_add(faults, at, "= " + with_unit(number_text(value), key) + "; allowed: " + range_text(key));
    return std::nullopt;
  }

  std::optional<int> whole(const toml::node& n, const std::string& at) const {
    if (!n.is_integer()) return misfit(at, n, "a whole number"), std::nullopt;
    if (const auto value = number(n, at)) return static_cast<int>(*value);
    return std::nullopt;
  }

  template <std::size_t N>
  std::optional<std::array<double, N>> fixed(const toml::node& n, const std::string& at) const {
    const std::string want = Wanted{key}(static_cast<std::array<double, N>*>(nullptr));
    const toml::array* list = n.as_array();
    if (!list) return misfit(at, n, want), std::nullopt;
    if (list->size() != N) {
      place_note(faults, at, n);
      return fault_add(faults, at, "has " + entries_text(list->size()) + "; wanted: " + want), std::nullopt;
    }
    std::array<double, N> values;
    bool complete = true;
    for (std::size_t i = 0; i < N; ++i) {
      const auto value = number((*list)[i], entry(at, i));
      complete = complete && value;
      values[i] = value.value_or(0);
    }
    return complete ? std::optional(values) : std::nullopt;
  }

  template <class T, class Take>
  void list(std::vector<T>& to, Take take) const {
    const toml::array* entries = node.as_array();
    const auto flat = [](const toml::node& n) { return !n.is_array(); };
    if (!entries) return misfit(path, node, key_wanted(key));
    if (entries->empty()) return fault_add(faults, path, "is an empty list; wanted: " + key_wanted(key));
    if (std::is_same_v<T, Vec2> && std::all_of(entries->begin(), entries->end(), flat))
      return fault_add(faults, path, "is a flat list; wanted: " + key_wanted(key));
    std::vector<T> values;
    for (std::size_t i = 0; i < entries->size(); ++i)
      if (const std::optional<T> value = take((*entries)[i], entry(path, i))) values.push_back(*value);
    if (values.size() == entries->size()) to = values;
  }

  // A word of TOML text, passed on to `take`.
  template <class Take>
  void word(Take take) const {
    if (const auto* text = node.as_string()) take(text->get());
    else misfit(path, node, key_wanted(key));
  }

  void operator()(Elsewhere) const {}
  void operator()(Later) const { fault_add(faults, path, "is not supported by this version"); }
  void operator()(std::string* to) const {
    word([&](const std::string& text) { *to = text; });
  }
  void operator()(const Name& name) const {
    word([&](const std::string& text) {
      *name.to = text;
      if (!name_fits(text)) fault_add(faults, path, "= " + in_quotes(text) + " " + kNameRule);
    });
  }
  void operator()(double* to) const {
    if (const auto value = number(node, path)) *to = *value;
  }
  void operator()(const Auto& automatic) const {
    const auto* text = node.as_string();
    if (text && text->get() == "auto") *automatic.to = 0;
    else if (text) fault_add(faults, path, "= " + in_quotes(text->get()) + "; wanted: " + key_wanted(key));
    else (*this)(automatic.to);
  }
  void operator()(const Flag& flag) const {
    if (const auto* value = node.as_boolean()) *flag.to = value->get();
    else misfit(path, node, key_wanted(key));
  }
  void operator()(const Choice& choice) const {
    word([&](const std::string& text) {
      const auto it = std::find(choice.words.begin(), choice.words.end(), text);
      if (it != choice.words.end()) return choice.take(static_cast<int>(it - choice.words.begin()));
      fault_add(faults, path, "= " + in_quotes(text) + "; allowed: " + key_wanted(key));
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
  void operator()(Vec2* to) const {
    if (const auto values = fixed<2>(node, path)) *to = *values;
  }
  void operator()(Vec3* to) const {
    if (const auto values = fixed<3>(node, path)) *to = *values;
  }
  void operator()(std::vector<double>* to) const {
    list(*to, [&](const toml::node& n, const std::string& at) { return number(n, at); });
  }
  void operator()(std::vector<int>* to) const {
    list(*to, [&](const toml::node& n, const std::string& at) { return whole(n, at); });
  }
  void operator()(std::vector<Vec2>* to) const {
    list(*to, [&](const toml::node& n, const std::string& at) { return fixed<2>(n, at); });
  }
};

}  // namespace

void value_land(Faults& faults, const std::string& path, const Key& key, const toml::node& node) {
  std::visit(Land{faults, path, key, node}, key.lands);
}

std::string key_wanted(const Key& key) { return std::visit(Wanted{key}, key.lands); }

const char* node_kind(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

bool name_fits(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto inner = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name.size() <= kLongest && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), inner);
}

void place_note(Faults& faults, const std::string& path, const toml::node& node) {
  if (node.source().path) faults.places[path] = {*node.source().path, node.source().begin.line};
}

}  // namespace drape
