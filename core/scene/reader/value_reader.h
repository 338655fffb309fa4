// Rows of keys. A row gives the name of a key, the destination of its value, the allowed range and the unit.
// The value reader stores one value at its destination, and makes all messages about values.
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
constexpr bool kAbove = true;  // `low` itself is not allowed

struct Range {
  double low = 0, high = 0;  // in the key's unit
  bool above = false;
};

// The destination of a value. Each alternative is a kind of value.
struct Name {
  std::string* to;
};  // a word that can be part of a variable's name
struct Auto {
  double* to;
};  // a number, or "auto", which is stored as 0
struct Flag {
  bool* to;
};  // true or false
struct Choice {
  std::vector<std::string> words;
  std::function<void(int)> apply;  // called with the index of the word
};  // one of some words
struct Reference {
  int* to;
  const char* kind;
  const std::vector<std::string>* names;
};  // the name of an object, stored as its index
struct Whole {
  std::int64_t* to;
};  // an integer
struct Pair {
  Vec2* to;
  const char* names;
};  // two numbers, or one number for both
struct OneOf {
  std::vector<std::int64_t> numbers;
  int* to;
};  // one of some integers
struct Tables {
  std::function<std::vector<Key>()> add;  // adds an element and returns its rows
};  // a list of tables; faulty ones are added too
struct Elsewhere {};  // a table that is read separately
using Destination =
    std::variant<Elsewhere, std::string*, Name, double*, Auto, Flag, Choice, OneOf, Reference, int*, Whole,
                 Pair, Vec2*, std::optional<Vec2>*, Vec3*, std::vector<double>*, std::vector<int>*,
                 std::vector<Vec2>*, std::vector<std::vector<Vec2>>*, Tables>;

struct Key {
  std::string name;  // within its table; "strip.width" is `width` in the table `strip`
  Destination destination;
  bool required = kOptional;  // of a nested table: required where that table is present
  Range range{};
  const char* unit = "";
  double per_si = 1;  // key units in one SI unit: the value stored is number / per_si
};

// Stores a value at the destination of its row, or adds a fault. A value with a fault is not stored: its
// destination keeps its default, empty or -1.
void value_read(Faults& faults, const std::string& path, const Key& key, const toml::node& node);

// Texts of messages: the kind of value that a key expects, the range of its numbers, a number in its unit,
// and the kind of a node.
std::string key_expected(const Key& key);
std::string key_number_expected(const Key& key);
std::string key_range(const Key& key);
std::string key_number(const Key& key, double value);
std::string words_text(const std::vector<std::string>& words);
const char* node_kind(const toml::node& node);

// Stores the location of a path.
void location_note(Faults& faults, const std::string& path, const toml::node& node);

}  // namespace drape::scene
