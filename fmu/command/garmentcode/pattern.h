// A sewing pattern as GarmentCode writes it: panels, and what is stitched to what; lengths in metres.
#pragma once
#include <filesystem>

#include "command/garmentcode/panel.h"

namespace drape::command {

struct Stitch {
  int panel[2], edge[2];     // indices into Pattern::panels, of their edges
  bool right_wrong = false;  // both edges start where the seam starts; else one runs against the other
};

struct Pattern {
  std::vector<Panel> panels;
  std::vector<Stitch> stitches;
};

// Appends a problem for each fault; the pattern is usable only when none was appended.
Pattern pattern_read(const std::filesystem::path& file, std::vector<Problem>& problems);

}  // namespace drape::command
