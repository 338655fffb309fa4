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

}  // namespace drape::package
