// The tensile test of GOST 3813 on simulated cloth. A strip has the size of the fabric's specimen. Jaws
// clamp the full width of both ends. It is pulled along the warp, along the weft or at 45 degrees. It
// stays in its plane and has no weight.
#pragma once
#include "fabric/material_law.h"
#include "model/irregular_elements.h"
#include "model/system.h"

namespace drape::laboratory {

inline constexpr int kStripCells = 16;  // across the strip by default: the cell of a calibration
inline constexpr int kMinCells = 4;     // minimum across and along a specimen
inline constexpr int kMaxCells = 2000;  // maximum along a strip
inline constexpr int kExcessCells = 8;  // across the strip: fast, and accurate to some percent of the force

// The cell size of a strip for which `cell`, m, is requested. For a strip at 45 degrees it is the nearest
// size whose diagonals divide the width evenly. So the corners of the jaws are nodes: all four, where twice
// the gauge over the width is a whole number. Strains are singular at the corners, and the force changes by
// some percent with the position of the grid there: core/README.md, section 5.
double strip_cell(const scene::FabricSpec& fabric, model::YarnDirection along, double cell);

// The strip between the pins "low" and "high". The pull is along y, and the yarn direction `along` runs along
// y. The cell size is strip_cell.
Scene strip_scene(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                  const fabric::LawOptions& options = {});

const scene::DiagramSpec& strip_diagram(const scene::FabricSpec& fabric, model::YarnDirection along);

struct StripPull {
  std::vector<double> force;  // [points] N, on the upper jaw; ends before the first point without equilibrium
  std::vector<double> strain;  // [points] 1, leading_strain
  double residual = 0;         // 1, the largest, relative to the load
  int steps = 0;               // number of Newton steps
};

// The strain of the most strained links along a yarn direction. Strain in a strip is not uniform, so this is
// the mean of |e| weighted by w R e^8. (A calibration converges where the points of a law lie near the
// largest strains of their strips: with e^2 to e^4 that of the shipped half-wool did not.)
double leading_strain(const System& system, const State& state, model::YarnDirection along);

// The jaw's force at each elongation (fraction, in increasing order from 0). A bias diagram without jaws
// (DiagramSpec::jaws = false) is that of a trellis: no jaws, yarns of fixed length.
StripPull strip_pull(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                     const std::vector<double>& elongation, std::vector<Problem>& problems,
                     const fabric::LawOptions& options = {});

// The elongations of a diagram at which a strip can be compared: above 0, at most `pull` (fraction) and, at
// 45 degrees, below the locking of the trellis.
std::vector<double> strip_elongations(const scene::FabricSpec& fabric, model::YarnDirection along,
                                      double pull);

// How far the slope of a direction's law travels: math::curve_slope_path. 0 where the fabric has no such law.
double strip_slope_path(const scene::FabricSpec& fabric, model::YarnDirection along,
                        const fabric::LawOptions& options);
inline constexpr double kMaxSlopePath = 2;  // beyond, it is noise that makes the slope travel

// The largest deviation of a simulated strip from its diagram without correction: S/F - 1, and the elongation
// (fraction) where it occurs. The strip has kExcessCells across.
struct StripExcess {
  double excess = 0, elongation = 0;
  std::string why;  // the reason, where it is not known
};
StripExcess strip_excess(const scene::FabricSpec& fabric, model::YarnDirection along,
                         const fabric::LawOptions& options);

}  // namespace drape::laboratory
