// Makes a diagram of a tensile tester's samples: at most 64 points of a smooth rising curve near them.
//
// The interpolant goes through every point of a diagram, and so follows the noise of a load cell. Its slope
// then travels several times its own range (math/monotone_curve.h, slope_path). Here the points are those of
// the smoothest rising curve whose residual is the resolution of the load cell (monotone_fit.h).
#pragma once
#include "laboratory/samples.h"

namespace drape::laboratory {

inline constexpr double kSmoothPath = 1.5;  // a diagram with a smaller slope path stays as it is

struct SmoothedDiagram {
  scene::DiagramSpec diagram;   // its points, with the keys and units of the samples
  bool is_smooth = false;       // the samples were a smooth diagram as they stood; `diagram` holds them
  Record record;                // what was left out of the samples
  double resolution = 0;        // N, given or estimated
  double pretension = 0;        // N, subtracted from all forces
  double slack = 0;             // fraction, subtracted from all elongations: there is no force up to there
  double rms = 0, largest = 0;  // N, residual of the samples about the interpolant
  double path_before = 1, path_after = 1;  // slope paths
  bool is_near = true;  // false: no rising curve is within the resolution; the points are of the nearest
  std::string problem;  // why there is no diagram; empty if there is one
};

// resolution: N, of the load cell; 0: the samples' own scatter. The samples need not rise, and need not begin
// at 0. Their lists have the same length.
SmoothedDiagram diagram_smooth(const scene::DiagramSpec& samples, double resolution);

}  // namespace drape::laboratory
