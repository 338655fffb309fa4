// The guid ties a modelDescription.xml to the cloth for which it was printed.
#pragma once
#include <string>
#include <string_view>

#include "variables.h"

namespace drape::description {

// What a guid stands for: the scene's text, and a hash of each of its meshes.
std::string guid_content(const drape_cloth* cloth);

// A hash of Drape's version, this content and the choice of node variables. Equal guids mean equal variable
// tables and equal runs.
std::string guid_of(std::string_view content, Nodes nodes);

}  // namespace drape::description
