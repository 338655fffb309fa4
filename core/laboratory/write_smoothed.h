// Writes smoothed diagrams into the text of their fabric file. The samples stay beside the points, as the key
// `raw` of the diagram. All other text is unchanged, comments and line ends included.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace drape::laboratory {

// Whether the text has lists for warp, weft and bias. Diagrams without come from a data sheet.
std::array<bool, 3> diagrams_in_text(const std::string& text);

// Returns the new text, with numbers of six digits. diagrams: of warp, weft and bias, those to be written.
// Returns an empty text, with a problem, where they cannot be written into the text.
std::string write_smoothed(const std::string& text, const std::string& fabric,
                           const std::optional<scene::DiagramSpec> (&diagrams)[3],
                           std::vector<Problem>& problems);

}  // namespace drape::laboratory
