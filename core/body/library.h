// Opens the contact library, which is in the same folder as the file that contains this code.
#pragma once
#include <memory>
#include <string>

#include "body/query.h"

namespace drape::body {

// Returns null on failure, with the reason in `hindrance`. All users in a process share one library; it is
// closed when the last one lets go of it.
std::shared_ptr<const drape_contact_library> contact_library(std::string& hindrance);

}  // namespace drape::body
