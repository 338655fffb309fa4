// The guid ties a modelDescription.xml to the cloth for which it was printed.
#pragma once
#include <string>
#include <string_view>

#include "variables.h"

namespace drape::description {

// A hash of Drape's version, the scene's text and the choice of node variables. Equal guids mean equal
// variable tables.
std::string guid_of(std::string_view scene_text, Nodes nodes);

}  // namespace drape::description
