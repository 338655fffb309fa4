// The licences of the code in the binary of an FMU. The FMU includes them.
#pragma once
#include <string>
#include <vector>

namespace drape::package {

struct License {
  std::string name, text;
};
extern const std::vector<License> kLicenses;
extern const std::vector<License> kContactLicenses;  // of the contact library and its dependencies

// What an FMU packs, with versions and licences: lines of CSV after a header. The second list goes on from
// the first where a scene has a body.
extern const std::string kComponents, kContactComponents;

}  // namespace drape::package
