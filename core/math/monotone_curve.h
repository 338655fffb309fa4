// A law as a table of polynomials: the interpolant of core/README.md, section 2, ready for lanes.
//
//   f(e) = c0 + t (c1 + t^2 (c3 + t (c4 + t c5))),   t = e - origin
//
// on the segment that e lies in: the first that ends above it. To find it, the strains from the first end to
// the last are shared out into equal bins, each of which knows the segment that it begins in.
//
// The second derivative vanishes at every point of a diagram, so no segment has a t^2 term. Compression,
// tension and the linear ends are segments like any other; an odd curve is read at |e| and takes the sign
// of e.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

namespace drape::math {

inline constexpr int kCurvePoints = 64;  // of a diagram, at most
inline constexpr int kCurveSegments =
    kCurvePoints + 2;  // and the blend and the line below zero, the line beyond the end

inline constexpr int kCurveBins = 256;

// The first segments of a curve, up to a strain `limit`, laid out for tables of kSize numbers in registers.
// Bins of equal width, each with no more than one end in it: the bin of e = scale max(e, low) + shift,
// rounded to the nearest.
template <int kSize>
struct CurveStart {
  double low = 0, limit = std::numeric_limits<double>::infinity(), scale = 0, shift = 0;
  alignas(64) double end[kSize]{};          // the end in the bin, or what nothing reaches
  alignas(64) std::int64_t first[kSize]{};  // the segment that the bin begins in
  alignas(64) double column[6][kSize]{};    // origin, c0, c1, c3, c4, c5 of the segments
};

struct CurveSegment {
  double origin = 0, c0 = 0, c1 = 0, c3 = 0, c4 = 0, c5 = 0;
  double end =
      std::numeric_limits<double>::quiet_NaN();  // of the last: nothing is beyond it, infinity neither
  double energy = 0;                             // integral of f from 0 to origin
};

struct Curve {
  int segments = 0;  // 0: law off; 1: a straight line through 0
  bool odd = false;
  double last = 0;  // last tested strain; linear beyond
  alignas(64) CurveSegment segment[kCurveSegments];
  double bin_scale = 0, bin_shift = 0;  // bin of e = scale e + shift, rounded down, from 0 to kCurveBins - 1
  int bin_ends = 0;                     // ends of segments in one bin, at most
  unsigned char bin_begin[kCurveBins]{};  // segment
  CurveStart<8> start8;
  CurveStart<16> start16;
};

// How a diagram goes on below zero.
struct Continuation {
  bool odd = false;
  double compression = 1;  // slope far below zero over the slope at zero
  double blend = 0.002;    // strain over which the slope gets there
};

// The curve through (e[k], f[k]): e[0] = f[0] = 0, e rising, f finite. All f zero: a curve with no segments.
Curve curve_make(const std::vector<double>& e, const std::vector<double>& f, const Continuation& below);

double curve_value(const Curve& curve, double e);
double curve_slope(const Curve& curve, double e);
double curve_energy(const Curve& curve, double e);  // integral of f from 0 to e

}  // namespace drape::math
