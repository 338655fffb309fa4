// The calibration of a fabric, as `drape fabric calibrate` and `drape fabric smooth` run it.
#pragma once
#include <string>
#include <vector>

#include "laboratory/calibrate.h"

namespace drape::command {

// Prints problems on standard error; true if there are none.
bool problems_report(const std::vector<Problem>& problems);

// Calibrates a fabric on cells of edge length `cell` (m; 0: the default), and writes the corrections into the
// text of its file. Prints each sweep. Returns an exit code; unless it is kDone, the text is unchanged.
int fabric_calibrate(const scene::FabricSpec& fabric, double cell, std::string& text,
                     laboratory::Calibration& calibration);

}  // namespace drape::command
