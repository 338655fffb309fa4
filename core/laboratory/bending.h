// Bending tests on simulated cloth under its weight.
//
//     PT-2 (GOST 10550): a strip of 160 x 30 mm lies with its middle 20 mm on a support, f is the drop of the
//     ends of its wings, l = 70 mm long; EI = 42046 m/A(f/l) with m the mass of five strips in g, which is
//     B = rho g l^3/beta, beta = A(f/l) that of the heavy elastica (sheet/cantilever.h).
//
//     Bending length (ASTM D1388): a strip is pushed out until its end meets the plane that falls by 41.5
//     degrees from the edge; the overhang l gives c = l/2 and B = rho g l^3/beta, beta = 8.00 that of the
//     elastica whose end lies on this plane.
#pragma once
#include "scene/scene.h"
#include "standards/units.h"

namespace drape::laboratory {

inline constexpr double kWing = 0.07, kSupport = 0.02, kWingWidth = 0.03;  // m, PT-2
inline constexpr double kPlane = 41.5, kOverhangWidth = 0.025;             // degrees, m, ASTM D1388

// The PT-2 specimen along the warp (or weft), held by the pin "support"; probes "low" and "high" are the
// middles of its ends.
Scene pt2_scene(const scene::FabricSpec& fabric, bool warp, double cell);
// A strip of 25 mm that leaves the clamped edge "edge" and ends at the probe "end".
Scene overhang_scene(const scene::FabricSpec& fabric, bool warp, double cell, double length);

struct BendingTest {
  bool found = false;
  double reading = 0;   // m: the drop f; the overhang
  double expected = 0;  // m: that of the elastica with the fabric's own B
  double rigidity = 0;  // N m, B by the formula from the reading
};

BendingTest pt2_test(const scene::FabricSpec& fabric, bool warp, double cell, std::vector<Problem>& problems);

// `cells` along the overhang.
BendingTest overhang_test(const scene::FabricSpec& fabric, bool warp, int cells,
                          std::vector<Problem>& problems);

}  // namespace drape::laboratory
