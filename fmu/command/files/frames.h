// The cloth in motion for ParaView and PyVista: PolyData files, and collections with their times.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "drape/drape.h"

namespace drape::command {

// One kind of thing in a folder of its own: the files NAME/NNNN.vtp, and NAME.pvd with the times.
struct Collection {
  std::string name;
  std::vector<double> times;       // s
  std::vector<std::size_t> files;  // [times] the number of each file; what does not move is written once
};

struct Frames {
  std::filesystem::path folder;
  std::string trouble;  // why a file could not be written
  Collection cloth{"frames", {}, {}}, seams{"seams", {}, {}}, bodies{"bodies", {}, {}};
};

// Writes the present state. The cloth: the particles, then the points of the outline between them; polygons
// with velocity, strains, tensions and pressure. Where the scene has them: seams (both sides as lines, with
// their gap) and bodies (at their present pose). If something could not be written, it returns false and
// puts a sentence in `trouble`.
bool frame_write(Frames& frames, drape_cloth* cloth, double time);

}  // namespace drape::command
