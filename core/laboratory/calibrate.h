// Calibration finds the corrections with which simulated strips reproduce the measured diagrams.
//
// A strip pulled along the warp or weft loads the diagonals too; their share is subtracted from its law. Jaws
// keep a 45 degree strip square at its ends. So its middle strains by more than the strip, and the force is
// higher. With the force F_i of the diagram and S_i of its simulated strip at point i:
//
//     warp, weft:  q_i <- q_i + (F_i - S_i)/F_i
//     bias:        q_i <- q_i F_i/S_i,      and in the first sweeps the point moves to its leading
//                                           strain (strip.h), c_i e_i
//
// The law passes through (c_i e_i, q_i F_i/w_p). At e_i, the points of the bias law would lie below the
// strains that their strips reach, and the last points would depend on the law beyond its end.
#pragma once
#include "laboratory/strip.h"

namespace drape::laboratory {

struct CalibrationOptions {
  double cell = 0;          // m, cell size; 0: the strip's width over kStripCells
  double tolerance = 1e-4;  // relative to the force, at each point
  int max_sweeps = 40;
};

struct Calibration {
  scene::FabricSpec fabric;  // with its corrections
  bool converged = false;
  double cell = 0;                // m, cell size
  std::vector<double> residuals;  // [sweeps] largest |S/F - 1| with the corrections at the start of the sweep
  std::string why;                // the reason, where not converged
};

// Calibrates all directions that have a diagram. Starts from the corrections of the fabric, if it has any.
Calibration calibrate(const scene::FabricSpec& fabric, const CalibrationOptions& options,
                      std::vector<Problem>& problems);

// "warp", "weft", "bias"
const char* yarn_direction_name(model::YarnDirection along);

}  // namespace drape::laboratory
