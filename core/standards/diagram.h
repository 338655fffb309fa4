// A diagram that a sheet implies but does not show, ready for a fabric file.
#pragma once
#include <vector>

namespace drape::standards {

struct Diagram {
  std::vector<double> percent;          // elongation, from 0
  std::vector<double> force_per_width;  // N/m
};

}  // namespace drape::standards
