// The guid ties a modelDescription.xml to the cloth it was printed for.
#pragma once
#include <string>
#include <string_view>

#include "variables.h"

namespace drape::description {

// From Drape's version, the scene's text and the choice of node variables: equal guids mean equal variable
// tables.
std::string guid_of(std::string_view scene_text, Nodes nodes);

}  // namespace drape::description
