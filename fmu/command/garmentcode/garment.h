// A pattern, a fabric and a body -> a scene: the struct that the checks judge, and the text that is written.
#pragma once
#include <optional>

#include "command/garmentcode/pattern.h"

namespace drape::command {

// A body as its OBJ file has it; `scale` times its coordinates are metres.
struct BodyMesh {
  std::string file;  // as the scene names it
  double scale = 1;
  double height = 0;           // m
  std::vector<Vec3> vertex{};  // m
};

// Of the units in which bodies are usual (m, cm, mm) the one that makes it 0.3 to 3 m high.
std::optional<BodyMesh> body_measure(const std::filesystem::path& file,
                                            std::vector<Problem>& problems);

struct Garment {
  std::string name;                     // of the scene
  std::string title;                    // file of the pattern
  double cell = 0.01;                   // m
  std::string fabric;                   // name of the fabric
  std::string fabric_file;              // as the scene names it
  std::optional<BodyMesh> body;  // without one the garment is sewn weightless
};

// The pieces and seams of a pattern, named as scenes allow; fabric 0 for all.
Scene garment_scene(const Pattern& pattern, const Garment& garment, const scene::FabricSpec& fabric);

// The same as a TOML text.
std::string garment_text(const Scene& scene, const Pattern& pattern, const Garment& garment);

// A word that a scene takes for a name: other characters become _.
std::string name_made(const std::string& text, const std::string& otherwise);

}  // namespace drape::command
