// SiroFAST (A. De Boos, D. Tester, SiroFAST - A System for Fabric Objective Measurement, CSIRO Report
// WT92.02, 1994): figures of the data sheet to SI units. W is in g/m^2, the bending length C in mm.
// Extensions are in percent, at 5, 20 and 100 gf/cm of width.
//
//   FAST-2   B = W C^3 g:  1e-3 kg/m^2 (1e-3 m)^3 9.81 m/s^2 = 9.81e-12 N m     (9.81e-6 uN m)
//   FAST-3   G = 123/EB5 N/m per rad. A strip cut at 45 degrees stretches by EB5 under 5 gf/cm = 4.903 N/m.
//            For small e its F/width = 4 G e (standards/trellis.h), so G = 4.903 x 100/(4 EB5) = 122.6/EB5.
//
// G is FAST's own figure. It holds for small strains, and it includes the stiffening by the jaws of FAST-3.
#pragma once
#include "standards/units.h"

namespace drape::standards {

inline constexpr double kFastForce[] = {0, 5 * kGramForcePerCm, 20 * kGramForcePerCm,
                                        100 * kGramForcePerCm};  // N/m

constexpr double fast_bending(double w, double c) { return 9.81e-12 * w * c * c * c; }  // N m
constexpr double fast_shear(double eb5) { return 123 / eb5; }                           // N/m per rad

}  // namespace drape::standards
