// A smooth rising curve near samples: the smoothest one whose residual stays within the resolution.
//
// The slope is piecewise linear between equally spaced knots, p' = sum_j c_j hat_j(e), so p is a spline of
// degree 2. It rises where c_j >= 0. With samples f_i of weight m_i, p minimises
//
//     sum_i m_i [f_i - p(e_i)]^2 + lambda sum_j (c_{j-1} - 2 c_j + c_{j+1})^2,     p(0) = 0,   c_j >= 0
//
// This is a P-spline (Eilers, Marx 1996, Statistical Science 11) of the slope, whose integrals are the
// I-splines of Ramsay (1988, Statistical Science 3). lambda is the largest one with a root mean square
// residual of at most the resolution, as Reinsch (1967, Numerische Mathematik 10) chooses it. Where the slope
// still travels more than `path` times its range, noise happens to be larger than stated: the sum of squares
// of n samples of noise scatters by sqrt(2 n) about n resolution^2. There lambda grows until the slope does
// not, while the sum is at most n + 3 sqrt(2 n) of them.
//
// The minimum under c_j >= 0 is found by the active sets of Lawson and
// Hanson (1974), on the normal equations as by Bro and de Jong (1997, Journal of Chemometrics 11).
#pragma once
#include <vector>

#include "laboratory/samples.h"

namespace drape::laboratory {

struct MonotoneFit {
  double length = 0;          // last elongation, fraction
  std::vector<double> slope;  // [knots] N per strain, c_j
  double rms = 0;             // N, of the residual of the samples
  bool is_near = true;        // false: no such curve is within the resolution; this is the nearest
};

MonotoneFit monotone_fit(const Samples& samples, double resolution, double path);

double fit_value(const MonotoneFit& fit, double elongation);
double fit_slope_path(const MonotoneFit& fit);  // as math::slope_path

// Force (N) and slope (N per strain) at elongation 0, of the parabola nearest to the first samples: a tenth
// of them, at least 12. The fit above, as smooth as the resolution allows, would be off by as much there.
struct Beginning {
  double force = 0, slope = 0;
};
Beginning samples_beginning(const Samples& samples);

}  // namespace drape::laboratory
