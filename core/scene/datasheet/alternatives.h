// A property of a fabric can have several alternative keys; here the key that was used is found.
#pragma once
#include <string>
#include <vector>

#include "scene/reader/document.h"

namespace drape::scene {

// A fabric during the conversion of its data sheets.
struct Conversion {
  Faults& faults;
  const toml::table& table;
  const std::string& path;  // of the fabric
};

// The node at a dotted key of the fabric; null if the key is absent.
const toml::node* stated(const Conversion& s, const std::string& key);

// True if the key is present and has no fault.
bool valid(const Conversion& s, const std::string& key);

// Adds a fault at a key of the fabric.
void fault_at(const Conversion& s, const std::string& key, const std::string& message);

// Adds a fault at entry k of a key with a pair of values. Where one number was given for both, the fault is
// reported once.
void fault_at(const Conversion& s, const std::string& key, std::size_t k, const std::string& message);

// True if both keys are in the scene file, or both in the fabric file.
bool same_text(const Conversion& s, const std::string& a, const std::string& b);

// The key that gives a property; "" where none does. Keys of the scene file take precedence over those of the
// fabric file. Two keys in the same file are a fault, which is reported once; the first one is returned.
std::string property_source(const Conversion& s, const std::string& property,
                            const std::vector<std::string>& keys);

}  // namespace drape::scene
