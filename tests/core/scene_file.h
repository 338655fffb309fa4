// A scene in a folder that is deleted with the test.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "validation/load.h"

namespace drape::tests {

struct SceneFolder {
  std::filesystem::path path;
  SceneFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "drape_scene_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path = name;
  }
  ~SceneFolder() { std::filesystem::remove_all(path); }
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return path / name;
  }
};

// The messages of reading a file, without the name of its folder.
inline std::vector<std::string> messages_of(const SceneFolder& folder, const std::filesystem::path& file) {
  std::vector<Problem> problems;
  validation::scene_load(file, problems);
  std::vector<std::string> messages;
  for (const Problem& p : problems) {
    std::string text = scene::problem_text(p);
    const std::string prefix = folder.path.string() + "/";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
    messages.push_back(text);
  }
  return messages;
}

// A scene without faults. Together with kCloth it has every key of this version.
inline const std::string kScene = R"([scene]
name = "sheet_2"
duration = 2
gravity = [0, 0.5, -9.81]
integrator = "paper"
step = 1e-5
communication = 0.002
damping = 0.25
energy = true
[options]
scaling = "paper_area"
bias_model = "tension"
clamp_correction = false
[fabric.wool]
file = "wool.toml"
areal_density = 0.2
warp.force = [0, 3, 9]
[[piece]]
name = "sheet"
fabric = "wool"
cell = 0.01
outline = [[0, 0], [0.4, 0], [0.4, 0.6], [0, 0.6]]
velocity = [0, 0, 1]
place = { origin = [0, 0, 1], axis_x = [1, 0, 0], axis_y = [0, 0, 1] }
[[pin]]
name = "bar"
piece = "sheet"
edges = [2]
hold = "point"
[[pin]]
name = "tip"
piece = "sheet"
at = [[0.1, 0.1], [0.2, 0.1]]
[[probe]]
name = "hem"
piece = "sheet"
at = [0.2, 0]
)";

inline const std::string kCloth = R"([scene]
name = "cloth"
mode = "fit"
order = 2
self_contact = false
wind = [1.5, 0, -2]
imperfection = { amplitude = 0.001, seed = 7 }
[air]
density = 1.3
normal = 1.1
tangential = 0.02
[options]
outline = "paper"
[fabric.wool]
file = "wool.toml"
friction = [0.4, 0.25]
damping = 0.001
[[piece]]
name = "skirt"
fabric = "wool"
cell = 0.02
outline = [[0, 0], [0.4, 0], [0.4, 0.6], [0.2, 0.5], [0, 0.6]]
curves = [
  { edge = 0, bezier = [[0.1, -0.05], [0.3, 0.05]] },
  { edge = 1, arc = 0.5, large = false, right = true },
  { edge = 4, bezier = [[0.05, 0.3]] },
]
holes = [[[0.1, 0.1], [0.2, 0.1], [0.1, 0.2]], [[0.25, 0.25], [0.3, 0.25], [0.3, 0.3], [0.25, 0.3]]]
grain = 0.3
grid_origin = [0.01, -0.02]
place = { origin = [0, 0.3, 1], axis_x = [1, 0, 0], axis_y = [0, 0, 1], cylinder = { axis_point = [0.2, 0, 0], axis = [0, 0, 1], radius = 0.3 } }
[[pin]]
name = "waist"
piece = "skirt"
edges = [2]
hold = "clamp"
drive = "velocity"
[[pin]]
name = "patch"
piece = "skirt"
region = [[0.25, 0.05], [0.35, 0.05], [0.35, 0.15], [0.25, 0.15]]
drive = "both"
[[pin]]
name = "tip"
piece = "skirt"
at = [[0.05, 0.05]]
drive = "position"
[[probe]]
name = "hem"
piece = "skirt"
at = [0.1, 0.3]
)";

inline const std::string kFabric = R"(description = "made up"
source = "nowhere"
areal_density = 0.15
thickness = 0.0005
compression = 0.5
compression_blend = 0.004
strip = { width = 0.05, gauge = 0.1 }
bending = { rigidity_uN_cm2 = [1370, 900], width = 0.03, poisson = 0.3 }
[warp]
elongation_percent = [0, 1, 2.5]
force = [0, 2, 7]
correction = [1, 0.9, 0.95]
[weft]
elongation_percent = [0, 4]
force = [0, 5]
[bias]
elongation_percent = [0, 3, 6]
force = [0, 0.5, 2]
)";

// The same fabrics by laboratory sheets. Each data-sheet key is in one of them.
inline const std::string kKes = R"([kes]
W = 24.5
T0 = 0.62
Fm = 500
EMT = [5.735, 5.135]
WT = [9.400, 8.675]
LT = [0.655, 0.676]
G = [0.5, 0.6]
B = [0.09, 0.07]
)";

inline const std::string kFast = R"([fast]
W = 168
T2 = 0.52
T100 = 0.42
C = [15.0, 14.5]
E5 = [0.67, 0.40]
E20 = [1.87, 1.87]
E100 = [4.60, 5.87]
EB5 = 4.7
)";

inline const std::string kStrips = R"(areal_density = 0.15
thickness = 0.0005
strip = "ASTM D5035 1R"
bending = { overhang_mm = [38, 30] }
[warp]
extension_mm = [0, 1.5, 3]
force_lbf = [0, 2, 5]
correction = [1, 0.9, 0.95]
[weft]
extension_in = [0, 0.1]
force_kgf = [0, 1]
[bias]
elongation_percent = [0, 4]
force_gf = [0, 25]
jaws = false
)";

inline const std::string kPt2 = R"(areal_density = 0.132
thickness = 0.0003
[bending]
gost_10550 = { mass_g = [3.17, 3.15], deflection_mm = [63.5, 65.1] }
poisson = 0.1
)";

}  // namespace drape::tests
