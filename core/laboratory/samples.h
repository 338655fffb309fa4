// The samples of a tensile tester, brought into order: what follows the break is left out, samples are
// sorted by elongation, and those of one elongation become their mean.
#pragma once
#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace drape::laboratory {

struct Samples {
  std::vector<double> elongation;  // [n] fraction, rising
  std::vector<double> force;       // [n] N, means
  std::vector<double> count;       // [n] samples of this elongation
  std::vector<double> square;      // [n] N^2, sum of squares of the samples about their mean
};

double samples_total(const Samples& samples);   // their number
double samples_square(const Samples& samples);  // N^2, the sum of `square`

// How far samples scatter about a smooth curve, N: the root mean square of their third divided differences,
// each over the norm of its weights,
//
//     sigma^2 = mean of (sum_k w_k f_k)^2/(sum_k w_k^2/m_k),   w_k = prod_{j != k} 1/(e_k - e_j)  of 4
//     neighbours,
//
// and of samples about the means of their elongations. m_k: samples of elongation k. These are the
// pseudo-residuals of Gasser, Sroka, Jennen-Steinmetz (1986), Biometrika 73, with differences of one order
// more. They vanish on any parabola, so stiffening is not taken for noise. Three samples have second
// differences only.
double samples_scatter(const Samples& samples);

// What was taken from a record, in the order of its samples.
struct Record {
  Samples samples;
  double scatter = 0;           // N, samples_scatter, at least kMinScatter of the greatest force
  std::size_t below_zero = 0;   // samples at an elongation below 0, left out
  std::size_t after_break = 0;  // samples after the greatest force, left out
  double break_elongation = 0;  // fraction, where the force is greatest
  bool reordered = false;       // sorted or merged
};
inline constexpr double kMinScatter = 1e-4;  // no load cell tells less of its range

// `resolution`: N, of the load cell; 0: the samples' own scatter. A fall after the greatest force counts as
// the break where it exceeds kBreakFall of that.
inline constexpr double kBreakFall = 6;
Record record_order(const scene::DiagramSpec& samples, double resolution);

// The greatest elongation up to which the force cannot be told from 0: the slope of a line through 0 is
// within two of its standard errors, resolution/sqrt(sum m e^2), or all forces are 0. With resolution 0 only
// the latter counts. There is no slack where that is less than a twentieth of the diagram or less than three
// samples of noise.
struct Slack {
  double end = 0;        // fraction; 0: none
  double max_slope = 0;  // N per strain, of this line and two standard errors
};
Slack samples_slack(const Samples& samples, double resolution);

// The samples beyond an elongation, which becomes 0.
Samples samples_from(const Samples& samples, double elongation);

}  // namespace drape::laboratory
