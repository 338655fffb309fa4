// A scene packed as an FMU, which is one file.
#pragma once
#include <filesystem>
#include <string>

#include "variables.h"

namespace drape::package {

// Writes the FMU of a scene. With SOURCE_DATE_EPOCH the same scene gives the same bytes. `picture` is an SVG
// element for the documentation. On failure it returns false, puts a sentence in `problem`, and leaves the
// file absent or as it was.
bool fmu_pack(drape_cloth* cloth, description::Nodes nodes, const std::string& picture,
              const std::filesystem::path& file, std::string& problem);

}  // namespace drape::package
