// A monotone curve as a table of polynomials: the interpolant of core/README.md, section 2, laid out for
// vector lanes.
//
//   f(e) = c0 + t (c1 + t^2 (c3 + t (c4 + t c5))),   t = e - origin
//
// on the segment that contains e: the first one whose end is above e. A table of bins finds it. The range
// from the first segment end to the last is divided into equal bins, and each bin stores the segment it
// starts in.
//
// The second derivative vanishes at every point of a diagram, so no segment has a t^2 term. Compression,
// tension and the linear ends are ordinary segments. An odd curve is evaluated at |e| and multiplied by the
// sign of e.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

namespace drape::math {

inline constexpr int kCurvePoints = 64;  // largest number of points of a diagram
// The segments between the points, the blend and the line below zero, and the line beyond the last point.
inline constexpr int kCurveSegments = kCurvePoints + 2;

inline constexpr int kCurveBins = 256;

// The first segments of a curve, up to the strain `limit`, laid out as tables of kSize numbers that fit into
// registers. The bins have equal width and contain at most one segment end each. The bin of e is scale max(e,
// low) + shift, rounded to the nearest integer.
template <int kSize>
struct CurveStart {
  double low = 0, limit = std::numeric_limits<double>::infinity(), scale = 0, shift = 0;
  alignas(64) double end[kSize]{};          // the segment end in the bin, or NaN where there is none
  alignas(64) std::int64_t first[kSize]{};  // the segment in which the bin starts
  alignas(64) double column[6][kSize]{};    // origin, c0, c1, c3, c4, c5 of the segments
};

struct CurveSegment {
  double origin = 0, c0 = 0, c1 = 0, c3 = 0, c4 = 0, c5 = 0;
  // NaN in the last segment: no strain is beyond it, not even infinity.
  double end = std::numeric_limits<double>::quiet_NaN();
  double energy = 0;  // integral of f from 0 to origin
};

struct Curve {
  int segments = 0;  // 0: the curve is 0 everywhere; 1: a straight line through 0
  bool odd = false;
  double last = 0;  // last tested strain; linear beyond
  alignas(64) CurveSegment segment[kCurveSegments];
  double bin_scale = 0, bin_shift = 0;  // bin of e = scale e + shift, rounded down, from 0 to kCurveBins - 1
  int bin_ends = 0;                     // largest number of segment ends in one bin
  unsigned char bin_begin[kCurveBins]{};  // [bins] segment in which the bin starts
  CurveStart<8> start8;
  CurveStart<16> start16;
};

// How a diagram continues below zero strain.
struct Continuation {
  bool odd = false;
  double compression = 1;  // slope far below zero over the slope at zero
  double blend = 0.002;    // strain over which the slope changes from one to the other
};

// The curve through the points (e[k], f[k]) with e[0] = f[0] = 0, e increasing and f finite. Where all f are
// zero, the curve has no segments.
Curve curve_make(const std::vector<double>& e, const std::vector<double>& f, const Continuation& below);

double curve_value(const Curve& curve, double e);
double curve_slope(const Curve& curve, double e);
double curve_energy(const Curve& curve, double e);  // integral of f from 0 to e

// How far the slope of a curve travels from 0 to the last point, over the range of its values:
//
//   integral of |f''(e)| de/(max f' - min f')
//
// 1 where the slope only rises or only falls, and where it is constant but for the rounding of the points:
// within a hundredth of its largest value. A slope that rises and falls back has 2.
inline constexpr double kConstantSlope = 0.01;
double curve_slope_path(const Curve& curve);

// The same of the interpolant through points of any number, of any sign of their secants.
double slope_path(const std::vector<double>& e, const std::vector<double>& f);

}  // namespace drape::math
