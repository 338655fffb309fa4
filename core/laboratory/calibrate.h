// Calibration: the corrections with which simulated strips give back the diagrams that were measured.
//
// A pulled warp or weft strip loads the diagonals too, whose share comes off its law. Jaws hold a 45 degree
// strip square at its ends: its middle strains by more than the strip, and pulls harder. With F the diagram,
// S its simulated strip, and both at the point i:
//
//     warp, weft:  q_i <- q_i + (F_i - S_i)/F_i
//     bias:        q_i <- q_i F_i/S_i,      and its point is put at the leading strain there (strip.h),
//                                           c_i e_i, in the first sweeps
//
// The law goes through (c_i e_i, q_i F_i/w_p). Left at e_i, the points of the bias law would lie below the
// strains that their strips reach, and what the last ones need would have to come from beyond the law's end.
#pragma once
#include "laboratory/strip.h"

namespace drape::laboratory {

struct CalibrationOptions {
  double cell = 0;          // m; 0: the strip's width over kStripCells
  double tolerance = 1e-4;  // of the force, at each point
  int max_sweeps = 40;
};

struct Calibration {
  scene::FabricSpec fabric;  // with its corrections
  bool converged = false;
  double cell = 0;  // m
  std::vector<double>
      residuals;    // [sweeps] largest |S/F - 1| with the corrections that the sweep starts from
  std::string why;  // where not converged
};

// `begun` is called after each sweep of strips, with its residual.
Calibration calibrate(const scene::FabricSpec& fabric, const CalibrationOptions& options,
                      std::vector<Problem>& problems);

// "warp", "weft", "bias"
const char* yarn_direction_name(model::YarnDirection along);

}  // namespace drape::laboratory
