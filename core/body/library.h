// Opens the contact library, which is in the same folder as the file that contains this code.
#pragma once
#include <string>

#include "body/query.h"

namespace drape::body {

// Returns null on failure, with the reason in `hindrance`. Opens the library once per process and keeps it
// open.
const drape_contact_library* contact_library(std::string& hindrance);

}  // namespace drape::body
