// The parts of datasheet_convert.
#pragma once
#include "scene/datasheet/alternatives.h"
#include "scene/reader/schema.h"
#include "scene/reader/table_reader.h"

namespace drape::scene {

// Adds the fault of a missing key.
void missing(const Conversion& s, FabricText& text, const std::string& key);

// Converts the tensile data of warp and weft, and diagrams in other units.
void tensile_convert(const Conversion& s, FabricText& text);

// Checks the samples that diagram k keeps as `raw`, and converts them to SI units.
void raw_convert(const Conversion& s, FabricText& text, std::size_t k);

// Converts the shear data to a bias diagram.
void shear_convert(const Conversion& s, FabricText& text);

}  // namespace drape::scene
