// Strain and tension of every thread and diagonal.
#pragma once
#include "drape/drape.h"
#include "model/system.h"

namespace drape::outputs {

struct StrainSummary {
  drape_strain warp, weft, bias;
  double tension_max;        // N/m, over warp and weft
  double beyond_test_count;  // links past the last elongation of their diagram
};
StrainSummary strain_summary(const System& system, const State& state);

}  // namespace drape::outputs
