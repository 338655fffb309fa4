// A load-elongation diagram derived from the figures of a data sheet, for use in a fabric file.
#pragma once
#include <vector>

namespace drape::standards {

struct Diagram {
  std::vector<double> percent;          // elongation, increasing from 0
  std::vector<double> force_per_width;  // N/m
};

}  // namespace drape::standards
