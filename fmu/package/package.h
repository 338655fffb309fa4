// An FMU as one file.
#pragma once
#include <filesystem>
#include <string>

#include "variables.h"

namespace drape::package {

// Writes the FMU of a scene; the same scene gives the same bytes. `picture` is an SVG element for the
// documentation. False, with a sentence in `problem`, where that fails; then the file is not there, or is as
// it was.
bool fmu_pack(drape_cloth* cloth, description::Nodes nodes, const std::string& picture,
              const std::filesystem::path& file, std::string& problem);

}  // namespace drape::package
