// Checks of a table that involve several keys, and normalisation of the values read.
#pragma once
#include <string>

#include "scene/diagnostics.h"
#include "scene/reader/document.h"
#include "scene/reader/schema.h"
#include "scene/scene.h"

namespace drape::scene {

// Makes the axes of a piece exactly orthonormal. Clears the outline of a piece with faulty curves or holes,
// so that later checks skip it.
void piece_normalize(Faults& faults, const toml::table& table, const std::string& path, PieceSpec& piece);

// Checks that a seam has two sides.
void seam_normalize(Faults& faults, const toml::table& table, const std::string& path);

// Resolves the mesh file of a body relative to the folder of the scene, and checks its orientation.
void body_normalize(Faults& faults, const std::string& path, const std::filesystem::path& folder,
                    const BodyText& text, BodySpec& body);

// Checks that a pin is given by exactly one of at, edges and region.
void pin_normalize(Faults& faults, const toml::table& table, const std::string& path);

}  // namespace drape::scene
