// The licences of what is in the binary of an FMU. They travel with it.
#pragma once
#include <string>
#include <vector>

namespace drape {

struct License {
  std::string name, text;
};
extern const std::vector<License> kLicenses;

}  // namespace drape
