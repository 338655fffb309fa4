// Texts of messages: the kind of value that a key expects, and the kind of node that was found.
#include <algorithm>

#include "scene/reader/value_reader.h"

namespace drape::scene {

namespace {

// The kind of value that a key expects.
struct Expected {
  const Key& key;
  std::string of(const char* what) const { return *key.unit ? std::string(what) + " in " + key.unit : what; }

  std::string operator()(Elsewhere) const { return "a table"; }
  std::string operator()(const OneOf& one) const {
    std::string text;
    for (const std::int64_t n : one.numbers) text += (text.empty() ? "" : ", ") + std::to_string(n);
    return text;
  }
  std::string operator()(std::string*) const { return "a text"; }
  std::string operator()(const Name&) const { return "a name in quotes"; }
  std::string operator()(double*) const { return of("a number"); }
  std::string operator()(const Auto&) const { return "\"auto\" or " + of("a number"); }
  std::string operator()(const Flag&) const { return "true or false"; }
  std::string operator()(const Choice& c) const { return words_text(c.words); }
  std::string operator()(const Reference& r) const { return std::string("the name of a ") + r.kind; }
  std::string operator()(int*) const { return of("a whole number"); }
  std::string operator()(const Whole&) const { return of("a whole number"); }
  std::string operator()(const Pair& p) const { return of("a number") + " or a list of two, " + p.names; }
  std::string operator()(Vec2*) const { return of("a list of two numbers"); }
  std::string operator()(std::optional<Vec2>*) const { return of("a list of two numbers"); }
  std::string operator()(Vec3*) const { return of("a list of three numbers"); }
  std::string operator()(std::vector<double>*) const { return of("a list of numbers"); }
  std::string operator()(std::vector<int>*) const { return of("a list of whole numbers"); }
  std::string operator()(std::vector<Vec2>*) const { return of("a list of points [[x, y], ...]"); }
  std::string operator()(std::vector<std::vector<Vec2>>*) const {
    return of("a list of lists of points [[[x, y], ...], ...]");
  }
  std::string operator()(const Tables&) const { return "a list of tables [{...}, ...]"; }
};

}  // namespace

std::string key_number(const Key& key, double value) {
  return *key.unit ? number_text(value) + " " + key.unit : number_text(value);
}

std::string key_range(const Key& key) {
  const Range& r = key.range;
  return r.above ? "above " + number_text(r.low) + ", at most " + key_number(key, r.high)
                 : "from " + number_text(r.low) + " to " + key_number(key, r.high);
}

std::string words_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + in_quotes(word);
  return text;
}

std::string key_number_expected(const Key& key) { return Expected{key}.of("a number"); }

std::string key_expected(const Key& key) { return std::visit(Expected{key}, key.destination); }

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

void location_note(Faults& faults, const std::string& path, const toml::node& node) {
  if (node.source().path) faults.locations[path] = {*node.source().path, node.source().begin.line};
}

}  // namespace drape::scene
