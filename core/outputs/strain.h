// A summary of strain and tension over all links.
#pragma once
#include "drape/drape.h"
#include "model/system.h"

namespace drape::outputs {

struct StrainSummary {
  drape_strain warp, weft, bias;  // 1
  double tension_max;             // N/m, over warp and weft
  double beyond_test_count;       // links beyond the last elongation of their diagram
};
StrainSummary strain_summary(const System& system, const State& state);

}  // namespace drape::outputs
