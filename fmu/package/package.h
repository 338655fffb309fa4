// A scene packed as an FMU, which is one file.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "package/platforms.h"
#include "variables.h"

namespace drape::package {

// What was packed for a platform.
struct PackedPlatform {
  std::string name;
  std::size_t size = 0;  // bytes of the binaries
  std::string glibc;     // the version needed, as "2.28"; empty: none
};

// Writes the FMU of a scene. With SOURCE_DATE_EPOCH the same scene gives the same bytes. `picture` is an SVG
// element for the documentation. On failure it returns nothing, puts a sentence in `problem`, and leaves the
// file absent or as it was.
std::vector<PackedPlatform> fmu_pack(drape_cloth* cloth, description::Nodes nodes,
                                     const std::vector<Platform>& platforms, const std::string& picture,
                                     const std::filesystem::path& file, std::string& problem);

// The folder of the running program, where the binaries of FMUs lie.
std::filesystem::path program_folder();

}  // namespace drape::package
