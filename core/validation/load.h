// Scene and fabric files, read and checked: every problem in one pass.
#pragma once
#include "scene/reader/read.h"

namespace drape::validation {

// Reads a scene file and the fabric files it names, and checks what no single key can show. Appends one
// Problem for each fault, in the order of the text; the scene is usable only when none was appended.
Scene scene_load(const std::filesystem::path& file, std::vector<Problem>& problems);

// The same for a fabric file by itself.
scene::FabricSpec fabric_load(const std::filesystem::path& file, std::vector<Problem>& problems,
                              scene::Corrections corrections = scene::Corrections::kKept);

// Checks that no single key can show: geometry, pins and probes against their pieces, diagrams.
void scene_check(const Scene& scene, std::vector<Problem>& problems);

// What only the grids of a scene that is otherwise without fault show.
void scene_check_layout(const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape::validation
