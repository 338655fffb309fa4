// Writes a calibration into the text of its fabric file: the corrections, and a table [calibration]. All
// other text is unchanged, comments and line ends included.
#pragma once
#include <string>

#include "laboratory/calibrate.h"

namespace drape::laboratory {

// Returns the new text, with numbers of six digits. date: such as "2026-11-25". Returns an empty text, with a
// problem, where the corrections cannot be written into the text.
std::string write_calibration(const std::string& text, const Calibration& calibration,
                              const std::string& date, std::vector<Problem>& problems);

}  // namespace drape::laboratory
