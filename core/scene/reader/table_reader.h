// Reads a table by rows of keys.
#pragma once
#include <string>
#include <vector>

#include "scene/reader/value_reader.h"

namespace drape::scene {

// Stores every value of a table at the destination of its row. Adds a fault for each unknown key and each
// missing required key.
void keys_read(Faults& faults, const toml::table& table, const std::string& path,
               const std::vector<Key>& keys);

}  // namespace drape::scene
