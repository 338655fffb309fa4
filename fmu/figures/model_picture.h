// The picture of a model: its cloth and bodies in space, at the present time.
#pragma once
#include <string>

#include "drape/drape.h"

namespace drape::figures {

// A PNG image, seen obliquely from above.
std::string model_png(drape_cloth* cloth);

}  // namespace drape::figures
