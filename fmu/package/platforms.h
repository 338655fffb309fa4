// The platforms that FMUs can be packed for: the binaries that lie beside the command.
//
//   drape_fmi2.so, libdrape_contact.so, licenses/   the development build, by the compiler of this machine
//   release/linux64/ ..., release/win64/ ...        the release build, by fmu/release.sh
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace drape::package {

struct Platform {
  std::string name;              // as in the folder binaries/ of an FMU
  std::filesystem::path folder;  // of the binaries and of licenses/
  std::string binary, contact;   // names of files
  std::string ending;            // of the binary in an FMU
  bool released = false;
};

enum class Build { kNewest, kRelease, kDevelopment };

// The platforms of a build. Without names: all that are built. kNewest: the release build, unless the
// development build is younger; then the sources may have changed since. What it lacks comes from the
// development build. `folder` holds the command. If
// there is none, or a named one is absent, the result is empty and `problem` a sentence.
std::vector<Platform> platforms_built(const std::filesystem::path& folder, Build build,
                                      const std::vector<std::string>& names, std::string& problem);

// The newest version of glibc that the bytes of an ELF library ask for, as "2.28". Empty: none, or no such
// library.
std::string glibc_needed(std::string_view bytes);
std::string glibc_newer(const std::string& a, const std::string& b);  // of two such versions

}  // namespace drape::package
