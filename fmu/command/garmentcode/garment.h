// A pattern, a fabric and a body -> a scene: the struct that the checks validate, and the text that is
// written.
#pragma once
#include <optional>

#include "command/garmentcode/pattern.h"

namespace drape::command {

// A body as its OBJ file has it. `scale` times its coordinates is in metres.
struct BodyMesh {
  std::string file;  // the path in the scene
  double scale = 1;
  double height = 0;           // m
  std::vector<Vec3> vertex{};  // m
};

// Chooses the unit among m, cm and mm in which the body is 0.3 to 3 m high.
std::optional<BodyMesh> body_measure(const std::filesystem::path& file, std::vector<Problem>& problems);

struct Garment {
  std::string name;              // of the scene
  std::string title;             // file of the pattern
  double cell = 0.01;            // m
  std::string fabric;            // name of the fabric
  std::string fabric_file;       // the path in the scene
  std::optional<BodyMesh> body;  // without a body, the garment is sewn without gravity
};

// The pieces and seams of a pattern, with names that scenes allow. All pieces have fabric 0.
Scene garment_scene(const Pattern& pattern, const Garment& garment, const scene::FabricSpec& fabric);

// The same as a TOML text.
std::string garment_text(const Scene& scene, const Pattern& pattern, const Garment& garment);

// A name that a scene accepts: other characters become _.
std::string name_made(const std::string& text, const std::string& otherwise);

}  // namespace drape::command
