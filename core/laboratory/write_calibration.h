// A calibration in the text of its fabric file: the corrections, and a table [calibration]. All else stays as
// it is, comments and line ends included.
#pragma once
#include <string>

#include "laboratory/calibrate.h"

namespace drape::laboratory {

// Numbers are rounded to six digits. `date`: "2026-11-25". Empty, with a problem, where the text does not
// take them.
std::string write_calibration(const std::string& text, const Calibration& calibration,
                              const std::string& date, std::vector<Problem>& problems);

}  // namespace drape::laboratory
