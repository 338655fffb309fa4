// The tensile test of GOST 3813 on simulated cloth: a strip of the fabric's own specimen, all of both ends in
// jaws, pulled along the warp, along the weft or at 45 degrees, without weight, in its plane.
#pragma once
#include "fabric/material_law.h"
#include "model/irregular_elements.h"
#include "model/system.h"

namespace drape::laboratory {

inline constexpr int kStripCells = 16;  // across the strip, unless told otherwise: the calibration's cell
inline constexpr int kMinCells = 4;     // across and along a specimen
inline constexpr int kMaxCells = 2000;  // along a strip, at most
inline constexpr int kExcessCells = 8;  // across the strip: quick, and good to some percent of the force

// The cell that a strip is made on where `cell` is asked for. Across the ends of a strip at 45 degrees it is
// the nearest one whose diagonals go evenly into the width, so that the corners of the jaws are nodes (of all
// four, where twice the gauge over the width is whole). Strains are singular at the corners, and the force
// moves by percents with the place of the grid there: core/README.md, section 5.
double strip_cell(const scene::FabricSpec& fabric, model::YarnDirection along, double cell);

// The strip between the pins "low" and "high"; the pull is along y, the threads `along` run along it. On
// strip_cell.
Scene strip_scene(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                  const fabric::LawOptions& options = {});

const scene::DiagramSpec& strip_diagram(const scene::FabricSpec& fabric, model::YarnDirection along);

struct StripPull {
  std::vector<double> force;   // [points] N on the upper jaw; as far as rest was found
  std::vector<double> strain;  // [points] leading_strain, below
  double residual = 0;         // the largest, over the load
  int steps = 0;               // of Newton's method
};

// Strain in a strip is not even. The strain of its most strained links along a thread: the mean of |e|
// weighted by w R e^8. (A calibration settles where the points of a law lie near the ends of what their
// strips reach: with e^2 to e^4 that of the shipped half-wool did not.)
double leading_strain(const System& system, const State& state, model::YarnDirection along);

// The jaw's force at each elongation (fraction, rising from 0). A diagram of bias without jaws
// (DiagramSpec::jaws = false) is that of a trellis: no jaws, threads of fixed length.
StripPull strip_pull(const scene::FabricSpec& fabric, model::YarnDirection along, double cell,
                     const std::vector<double>& elongation, std::vector<Problem>& problems,
                     const fabric::LawOptions& options = {});

// The points of a diagram at which a strip can be compared: above 0 elongation and, at 45 degrees, below the
// trellis' locking; at most `pull` (fraction).
std::vector<double> strip_elongations(const scene::FabricSpec& fabric, model::YarnDirection along,
                                      double pull);

// What a strip of a diagram gives that has no correction, as far from it as it gets: S/F - 1 at an elongation
// (fraction). On kExcessCells across.
struct StripExcess {
  double excess = 0, elongation = 0;
  std::string why;  // where it is not known
};
StripExcess strip_excess(const scene::FabricSpec& fabric, model::YarnDirection along,
                         const fabric::LawOptions& options);

}  // namespace drape::laboratory
