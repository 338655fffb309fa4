// Reading a table by rows of keys.
#pragma once
#include <string>
#include <vector>

#include "scene/reader/value_reader.h"

namespace drape::scene {

// Lands every value of a table by its row, and adds a fault for each key that has no row and each that is
// missing.
void keys_read(Faults& faults, const toml::table& table, const std::string& path,
               const std::vector<Key>& keys);

}  // namespace drape::scene
