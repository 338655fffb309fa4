// A sewing pattern as GarmentCode writes it: panels and what is stitched to what. core/README.md has no part
// in it: coordinates become metres here, and everything else is the scene's.
#pragma once
#include <filesystem>

#include "import/panel.h"

namespace drape {

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

}  // namespace drape
