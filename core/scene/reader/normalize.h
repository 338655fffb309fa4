// What no single row of a table can say, and what the rows leave open.
#pragma once
#include <string>

#include "scene/diagnostics.h"
#include "scene/reader/document.h"
#include "scene/reader/schema.h"
#include "scene/scene.h"

namespace drape::scene {

// Axes become exactly orthonormal. A piece whose outline, curves or holes have a fault loses its outline:
// what rests on them is passed over.
void piece_normalize(Faults& faults, const toml::table& table, const std::string& path, PieceSpec& piece);

// A seam has two sides.
void seam_normalize(Faults& faults, const toml::table& table, const std::string& path);

// The mesh's file, looked for beside the scene's, and the orientation.
void body_normalize(Faults& faults, const std::string& path, const std::filesystem::path& folder,
                    const BodyText& text, BodySpec& body);

void pin_normalize(Faults& faults, const toml::table& table, const std::string& path);

}  // namespace drape::scene
