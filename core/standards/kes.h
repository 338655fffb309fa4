// KES-F (S. Kawabata, The Standardization and Analysis of Hand Evaluation, 2nd ed., Osaka 1980): figures of
// the data sheet to SI units.
//
//   W    1 mg/cm^2      = 0.01 kg/m^2
//   B    1 gf cm^2/cm   = 9.80665e-3 N (1e-2 m)^2/(1e-2 m) = 9.80665e-5 N m
//   G    1 gf/(cm deg)  = 0.980665 N/m per pi/180 rad      = 56.188 N/m per rad
//   WT   1 gf cm/cm^2   = 9.80665e-3 N/(1e-2 m)            = 0.980665 N/m
//
// Tension. A specimen is pulled up to the force Fm per width (500 gf/cm), where its strain is EMT. WT is the
// area under the curve. The linearity LT is that area over the area of the triangle:
//
//   WT = integral of F de from 0 to EMT,      LT = WT/(Fm EMT/2).
//
// These figures leave one parameter of the shape to determine. The curve is the exponential
//
//   F(e) = Fm (exp(a e/EMT) - 1)/(exp(a) - 1),      LT = 2 [1/a - 1/(exp(a) - 1)],
//
// One formula covers stiffening cloth (a > 0, LT < 1), the straight line (a = 0, LT = 1) and softening cloth
// (a < 0, LT > 1). Its slope is positive and finite everywhere, whereas the slope of a power of e would
// vanish at 0. The diagram is the curve of core/README.md, section 2, through eleven points of the
// exponential. The parameter a is chosen so that the area under that curve, rather than under the
// exponential, is WT. So the diagram reproduces Fm, EMT, WT and LT to rounding.
#pragma once
#include "standards/diagram.h"
#include "standards/units.h"

namespace drape::standards {

inline constexpr double kKesWeight = 1e-2;                                // kg/m^2 per mg/cm^2
inline constexpr double kKesBending = kGramForce * 1e-2;                  // N m per gf cm^2/cm
inline constexpr double kKesShear = kGramForcePerCm / kRadiansPerDegree;  // N/m per rad per gf/(cm deg)
inline constexpr double kKesLinearityLow = 0.2, kKesLinearityHigh = 1.8;  // of LT: |a| up to 10

// LT, WT and the tensile diagram. EMT in percent, WT in gf cm/cm^2, Fm in gf/cm.
double kes_linearity(double emt, double wt, double fm);
double kes_energy(double emt, double lt, double fm);
Diagram kes_tension(double emt, double wt, double fm);

}  // namespace drape::standards
