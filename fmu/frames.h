// Pictures of the cloth in motion for ParaView and PyVista: one PolyData file a frame, and a collection with
// their times.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "drape.h"

namespace drape {

struct Frames {
  std::filesystem::path folder;
  std::vector<double> times;  // s, of the frames written
  std::string trouble;        // why a file could not be written
};

// Writes frames/NNNN.vtp with the particles, then the points of the outline between them, the polygons of the
// cloth and the velocity, and frames.pvd anew. False, with the sentence in `trouble`, where something could
// not be written.
bool frame_write(Frames& frames, drape_cloth* cloth, double time);

}  // namespace drape
