// What a cloth should have reached by now and has not: the rest of a fit, and seams that are to be closed.
// And the energy that it should have kept.
#pragma once
#include <string>
#include <vector>

#include "drape/drape.h"

namespace drape::instance {

inline constexpr double kResidualAtRest = 1e-5;  // of the load: the residual of a fit at rest

// A sentence for each: "by 4 s the seam 'side' has not closed: ...". Reads outputs of the present time.
std::vector<std::string> unfinished(drape_cloth* cloth);

// A sentence where more energy than allowed is unaccounted for; empty if not.
std::string energy_missing(const drape_unaccounted& unaccounted);

}  // namespace drape::instance
