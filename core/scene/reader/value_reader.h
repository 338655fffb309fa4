// Rows of keys: one row says what a key is called, where its value lands, what is allowed, in which unit.
// Here one value lands; all messages about values are made here.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/diagnostics.h"
#include "scene/reader/document.h"
#include "scene/scene.h"

namespace drape::scene {

struct Key;

constexpr bool kRequired = true, kOptional = false;
constexpr bool kAbove = true;  // the low end itself is not allowed

struct Range {
  double low = 0, high = 0;  // in the key's unit
  bool above = false;
};

// Where a value lands; each alternative is a kind of value.
struct Name {
  std::string* to;
};  // a word that can be part of a variable's name
struct Auto {
  double* to;
};  // a number, or "auto", which lands as 0
struct Flag {
  bool* to;
};  // true or false
struct Choice {
  std::vector<std::string> words;
  std::function<void(int)> take;
};
struct Reference {
  int* to;
  const char* kind;
  const std::vector<std::string>* names;
};  // the index of a name
struct Whole {
  std::int64_t* to;
};  // a whole number
struct Pair {
  Vec2* to;
  const char* names;
};  // two numbers, or one that stands for both
struct OneOf {
  std::vector<std::int64_t> numbers;
  int* to;
};  // one of some whole numbers
struct Tables {
  std::function<std::vector<Key>()> add;  // the rows of one more
};  // a list of tables; those with a fault are there too
struct Elsewhere {};  // a table with rows of its own
using Destination =
    std::variant<Elsewhere, std::string*, Name, double*, Auto, Flag, Choice, OneOf, Reference, int*, Whole,
                 Pair, Vec2*, std::optional<Vec2>*, Vec3*, std::vector<double>*, std::vector<int>*,
                 std::vector<Vec2>*, std::vector<std::vector<Vec2>>*, Tables>;

struct Key {
  std::string name;  // within its table; "strip.width" is `width` in the table `strip`
  Destination destination;
  bool required = kOptional;  // in a table within the table: where that table is there
  Range range{};
  const char* unit = "";
  double per_si = 1;  // key units in one SI unit: value lands as number / per_si
};

// Puts a value where its row says, or adds a fault. A value with a fault does not land: what it was to fill
// keeps its default, empty or -1.
void value_read(Faults& faults, const std::string& path, const Key& key, const toml::node& node);

// Texts of messages: what a key takes, the range of its numbers, a number in its unit, what a node is.
std::string key_expected(const Key& key);
std::string key_number_expected(const Key& key);
std::string key_range(const Key& key);
std::string key_number(const Key& key, double value);
std::string words_text(const std::vector<std::string>& words);
const char* node_kind(const toml::node& node);

// Names become part of variables' names.
bool name_fits(const std::string& name);
constexpr const char* kNameRule =
    "is no name; wanted: a letter, then letters, digits or underscores, at most 64 characters in all";

// Remembers on which line a path stands.
void place_note(Faults& faults, const std::string& path, const toml::node& node);

}  // namespace drape::scene
