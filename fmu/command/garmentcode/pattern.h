// A sewing pattern as GarmentCode writes it: panels and the stitches between them. Lengths are in metres.
#pragma once
#include <filesystem>

#include "command/garmentcode/panel.h"

namespace drape::command {

struct Stitch {
  int panel[2], edge[2];     // indices into Pattern::panels, of their edges
  bool right_wrong = false;  // true: both edges start where the seam starts; false: opposite ends
};

struct Pattern {
  std::vector<Panel> panels;
  std::vector<Stitch> stitches;
};

// Appends a problem for each fault. The pattern is usable only if none was appended.
Pattern pattern_read(const std::filesystem::path& file, std::vector<Problem>& problems);

}  // namespace drape::command
