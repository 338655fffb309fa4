// Two pieces sewn together, in motion.
#pragma once
#include "cloth_fixture.h"
#include "dynamics/seam_welding.h"

namespace drape::tests {

// The seam from the right edge of the first rectangle to the left edge of the second.
inline scene::SeamSpec seam_join() {
  scene::SeamSpec seam;
  seam.name = "join";
  seam.side[0] = {0, {1}, false};
  seam.side[1] = {1, {3}, true};
  return seam;
}

// Advances as a cloth does: seams are checked at the beginning of each interval.
inline void sewn_advance(Assembled& a, double length) {
  std::string event;
  const dynamics::Advance how =
      dynamics::leapfrog_advance(a.system, a.motion, a.state, length, event, [&](double) {
        bool changed = dynamics::seams_pull_begin(a.system, a.state);
        const std::vector<std::size_t> within = dynamics::seams_within_tolerance(a.system, a.state);
        if (!within.empty()) dynamics::seams_weld(a.system, a.motion, a.state, within);
        changed = changed || !within.empty();
        if (changed) dynamics::leapfrog_retuned(a.system, a.motion, a.state);
        return changed;
      });
  EXPECT_EQ(how, dynamics::Advance::kDone);
}

}  // namespace drape::tests
