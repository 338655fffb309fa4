// Pictures of the cloth in motion for ParaView and PyVista: PolyData files, and collections with their times.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "drape/drape.h"

namespace drape::command {

// One kind of thing in a folder of its own, NAME/NNNN.vtp, and NAME.pvd with the times.
struct Collection {
  std::string name;
  std::vector<double> times;       // s
  std::vector<std::size_t> files;  // [times] the number of each; what does not move is written once
};

struct Frames {
  std::filesystem::path folder;
  std::string trouble;  // why a file could not be written
  Collection cloth{"frames", {}, {}}, seams{"seams", {}, {}}, bodies{"bodies", {}, {}};
};

// Writes the present state: the cloth (the particles, then the points of the outline between them; polygons
// with velocity, strains, tensions, pressure), and where the scene has them, seams (both sides as lines, with
// their gap) and bodies (at their present pose). False, with the sentence in `trouble`, where something could
// not be written.
bool frame_write(Frames& frames, drape_cloth* cloth, double time);

}  // namespace drape::command
