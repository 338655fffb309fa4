// TOML -> Scene. Every problem is found in one pass.
#pragma once
#include <filesystem>

#include "scene/scene.h"

namespace drape {

// Reads a scene file and the fabric files it names (relative to the scene's folder). Appends one Problem for
// each fault; the scene is usable only when none was appended.
Scene scene_read(const std::filesystem::path& file, std::vector<Problem>& problems);

// Reads a fabric file by itself; its name is that of the file, without the ending. kDropped: as it stood
// before its calibration.
enum class Corrections { kKept, kDropped };
FabricSpec fabric_read(const std::filesystem::path& file, std::vector<Problem>& problems,
                       Corrections corrections = Corrections::kKept);

// A dotted path with where it stands, "scene.toml:12: scene.step", for faults that only the assembled cloth
// shows. Reads the files once more.
std::string scene_place(const std::filesystem::path& file, const std::string& path);

// The files that a scene is read from: its own first.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& file);

// The name by which the text of scene_resolve calls the mesh of a body.
std::string body_file(const std::string& name, const std::string& mesh);

// The same scene as one TOML text that refers to no other file but the meshes of bodies, which must lie
// beside it by the names of body_file; reading it gives the same Scene bit for bit. Reports only what hinders
// the folding (files, syntax): the rest is scene_read's.
std::string scene_resolve(const std::filesystem::path& file, std::vector<Problem>& problems);

// Checks that no single key can show: geometry, pins and probes against their pieces, diagrams. Called by
// scene_read.
void scene_check(const Scene& scene, std::vector<Problem>& problems);

// What only the grids of a scene that is otherwise without fault show. Called by scene_read.
void scene_check_layout(const Scene& scene, std::vector<Problem>& problems);

}  // namespace drape
