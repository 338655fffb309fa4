// Parts of sheet_settle.
#pragma once
#include "scene/datasheet/alternatives.h"
#include "scene/reader/schema.h"
#include "scene/reader/table_reader.h"

namespace drape::scene {

// Adds the fault of a key that is not there.
void missing(const Conversion& s, FabricText& text, const std::string& key);

// Warp and weft, and the diagrams' other units.
void tensile_convert(const Conversion& s, FabricText& text);

// Bias.
void shear_convert(const Conversion& s, FabricText& text);

}  // namespace drape::scene
