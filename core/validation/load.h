// Reads and checks scene and fabric files. All problems are found in one pass.
#pragma once
#include "scene/reader/read.h"

namespace drape::validation {

// Reads a scene file and the fabric files that it names, and checks the scene as a whole. Appends one Problem
// for each fault, in the order of the text. The scene is usable only if none was appended.
Scene scene_load(const std::filesystem::path& file, std::vector<Problem>& problems);

// Reads and checks a fabric file by itself.
scene::FabricSpec fabric_load(const std::filesystem::path& file, std::vector<Problem>& problems,
                              scene::Corrections corrections = scene::Corrections::kKept);

// Reads a fabric file whose diagrams may be the samples of a tensile tester, with noise, and checks the
// lengths of their lists. The corrections of a calibration are dropped.
scene::FabricFile samples_load(const std::filesystem::path& file, std::vector<Problem>& problems);

// The checks that involve several keys: geometry, pins and probes against their pieces, diagrams.
void scene_check(const Scene& scene, std::vector<Problem>& problems);

// The checks that need the grids of the pieces. The scene must have no other fault.
void scene_check_layout(const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape::validation
