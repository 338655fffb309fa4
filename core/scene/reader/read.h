// TOML -> Scene. Every fault that single keys show is found in one pass.
#pragma once
#include <filesystem>

#include "scene/diagnostics.h"
#include "scene/scene.h"

namespace drape::scene {

// A scene as its text has it, and the faults of its text. Not `loaded`: the file could not be read at all.
struct SceneText {
  Scene scene;
  Faults faults;
  bool loaded = false;
};

// Reads a scene file and the fabric files it names (relative to the scene's folder). Values with a fault keep
// their defaults, are empty or -1.
SceneText scene_read(const std::filesystem::path& file);

// A fabric file by itself; its name is that of the file, without the ending.
struct FabricFile {
  FabricSpec fabric;
  Faults faults;
  bool loaded = false;
};

// kDropped: as it stood before its calibration.
enum class Corrections { kKept, kDropped };
FabricFile fabric_read(const std::filesystem::path& file, Corrections corrections);

// A dotted path with where it stands, "scene.toml:12: scene.step", for faults that only the assembled cloth
// shows. Reads the files once more.
std::string scene_location(const std::filesystem::path& file, const std::string& path);

// The files that a scene is read from: its own first.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& file);

// The name by which the text of scene_resolve calls the mesh of a body.
std::string body_file(const std::string& name, const std::string& mesh);

// The same scene as one TOML text that refers to no other file but the meshes of bodies, which must lie
// beside it by the names of body_file; reading it gives the same Scene bit for bit. Reports only what hinders
// the folding (files, syntax): the rest is scene_read's.
std::string scene_inline_files(const std::filesystem::path& file, std::vector<Problem>& problems);

}  // namespace drape::scene
