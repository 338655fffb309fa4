// A property that several keys can state.
#pragma once
#include <string>
#include <vector>

#include "scene/reader/document.h"

namespace drape::scene {

// A fabric while its sheets are settled.
struct Conversion {
  Faults& faults;
  const toml::table& table;
  const std::string& path;  // of the fabric
};

// What stands at a dotted key of the fabric; null if nothing does.
const toml::node* stated(const Conversion& s, const std::string& key);

// True if the key is there and has no fault.
bool valid(const Conversion& s, const std::string& key);

void fault_at(const Conversion& s, const std::string& key, const std::string& message);

// The same at entry k, where the key holds a pair; once for both, where one number stands for them.
void fault_at(const Conversion& s, const std::string& key, std::size_t k, const std::string& message);

// True if both keys stand in the scene, or both in the fabric's file.
bool same_text(const Conversion& s, const std::string& a, const std::string& b);

// The key that states a property; "" where none does. Keys of the scene go before those of the fabric's file;
// two in the same text are a fault, reported once and answered by the first.
std::string property_source(const Conversion& s, const std::string& property,
                            const std::vector<std::string>& keys);

}  // namespace drape::scene
