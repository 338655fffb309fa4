// Reads TOML files into a Scene. All faults that single keys show are found in one pass.
#pragma once
#include <filesystem>

#include "scene/diagnostics.h"
#include "scene/scene.h"

namespace drape::scene {

// A scene as read from its text, and the faults of the text. `loaded` is false where the file could not be
// read at all.
struct SceneText {
  Scene scene;
  Faults faults;
  bool loaded = false;
};

// Reads a scene file and the fabric files that it names, relative to its folder. Values with a fault keep
// their defaults, are empty or are -1.
SceneText scene_read(const std::filesystem::path& file);

// A fabric file by itself. The fabric has the name of the file without the extension.
struct FabricFile {
  FabricSpec fabric;
  DiagramSpec raw[3];           // samples kept beside warp, weft and bias; empty where there are none
  double calibration_cell = 0;  // m; 0: not calibrated
  Faults faults;
  bool loaded = false;
};

// kDropped: read the fabric without the corrections of its calibration.
enum class Corrections { kKept, kDropped };
FabricFile fabric_read(const std::filesystem::path& file, Corrections corrections,
                       Diagrams diagrams = Diagrams::kFinished);

// The location of a dotted path as text, "scene.toml:12: scene.step", for faults found only in the assembled
// cloth. Reads the files again.
std::string scene_location(const std::filesystem::path& file, const std::string& path);

// The files from which a scene is read, its own first; then those of its fabrics and bodies.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& file);

// The file name of the mesh of a body in the text of scene_inline_files.
std::string body_file(const std::string& name, const std::string& mesh);

// The scene as one TOML text in which the fabric files are inlined. It refers to the meshes of bodies only,
// which must be in the same folder under the names of body_file. Reading the text gives the same Scene bit
// for bit. Only faults of files and syntax are reported here; scene_read reports the others.
std::string scene_inline_files(const std::filesystem::path& file, std::vector<Problem>& problems);

}  // namespace drape::scene
