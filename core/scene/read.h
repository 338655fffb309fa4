// TOML -> Scene. Every problem is found in one pass.
#pragma once
#include <filesystem>

#include "scene/scene.h"

namespace drape {

// Reads a scene file and the fabric files it names (relative to the scene's folder). Appends one Problem for
// each fault; the scene is usable only when none was appended.
Scene scene_read(const std::filesystem::path& file, std::vector<Problem>& problems);

// The same scene as one TOML text that refers to no other file; reading it gives the same Scene bit for bit.
// Reports only what hinders the folding (files, syntax): the rest is scene_read's.
std::string scene_resolve(const std::filesystem::path& file, std::vector<Problem>& problems);

// Checks that no single key can show: geometry, pins and probes against their pieces, diagrams. Called by
// scene_read.
void scene_check(const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape
