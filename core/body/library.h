// Opens the contact library, which lies beside the file that this code is in.
#pragma once
#include <string>

#include "body/query.h"

namespace drape::body {

// Null: `hindrance` says why. Opened once in a process, and kept.
const drape_contact_library* contact_library(std::string& hindrance);

}  // namespace drape::body
