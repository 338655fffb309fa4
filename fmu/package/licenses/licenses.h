// The licences of what is in the binary of an FMU. They travel with it.
#pragma once
#include <string>
#include <vector>

namespace drape::package {

struct License {
  std::string name, text;
};
extern const std::vector<License> kLicenses;
extern const std::vector<License> kContactLicenses;  // of the contact library and what comes with it

}  // namespace drape::package
