// Bending tests on simulated cloth under its own weight.
//
//     PT-2 (GOST 10550): a strip of 160 x 30 mm lies on a support with its middle 20 mm. f is the drop of the
//     ends of its wings, which are l = 70 mm long. EI = 42046 m/A(f/l), where m is the mass of five strips in
//     g. That is B = rho g l^3/beta, with beta = A(f/l) of the heavy elastica (standards/cantilever.h).
//
//     Bending length (ASTM D1388): a strip is pushed over an edge until its end meets a plane that falls from
//     the edge by 41.5 degrees. The overhang l gives c = l/2 and B = rho g l^3/beta, with beta = 8.00 of the
//     elastica whose end lies on this plane.
#pragma once
#include "scene/scene.h"
#include "standards/units.h"

namespace drape::laboratory {

inline constexpr double kWing = 0.07, kSupport = 0.02, kWingWidth = 0.03;  // m, PT-2
inline constexpr double kPlane = 41.5, kOverhangWidth = 0.025;             // degrees, m, ASTM D1388

// The PT-2 specimen along the warp or weft, held by the pin "support". The probes "low" and "high" are the
// middles of its ends.
Scene pt2_scene(const scene::FabricSpec& fabric, bool warp, double cell);
// A strip 25 mm wide, clamped at the pin "edge". The probe "end" is the middle of its free end.
Scene overhang_scene(const scene::FabricSpec& fabric, bool warp, double cell, double length);

struct BendingTest {
  bool found = false;   // the equilibrium was found
  double reading = 0;   // m, the drop f (PT-2) or the overhang l (ASTM)
  double expected = 0;  // m, the reading of an elastica with the fabric's own B
  double rigidity = 0;  // N m, B from the reading, by the formula
};

BendingTest pt2_test(const scene::FabricSpec& fabric, bool warp, double cell, std::vector<Problem>& problems);

// cells: number of cells along the overhang.
BendingTest overhang_test(const scene::FabricSpec& fabric, bool warp, int cells,
                          std::vector<Problem>& problems);

}  // namespace drape::laboratory
