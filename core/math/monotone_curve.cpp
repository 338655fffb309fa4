#include "math/monotone_curve.h"

#include <algorithm>
#include <cmath>

namespace drape::math {
namespace {

struct SegmentShape {
  double f, d;       // value at the origin; width
  double k, k_next;  // slopes at both ends
  double s;          // mean slope
};

// Adds a segment from `origin` on: the polynomial of core/README.md, section 2, in powers of t.
void segment_add(Curve& c, double origin, const SegmentShape& shape) {
  const auto [f, d, k, k_next, s] = shape;
  if (c.segments > 0) c.segment[c.segments - 1].end = origin;
  CurveSegment& to = c.segment[c.segments++];
  const double bump = 30 * (s - (k + k_next) / 2);
  to.origin = origin;
  to.c0 = f;
  to.c1 = k;
  to.c3 = (k_next - k + bump / 3) / (d * d);
  to.c4 = -(k_next - k + bump) / (2 * d * d * d);
  to.c5 = bump / (5 * d * d * d * d);
}

void line_add(Curve& c, double origin, double f, double k) { segment_add(c, origin, {f, 1, k, k, k}); }

// Slopes at the points: the weighted harmonic mean of Fritsch and Butland (1984), limited to twice the
// smaller of the two secant slopes.
std::vector<double> slopes_of(const std::vector<double>& d, const std::vector<double>& s) {
  std::vector<double> k(s.size() + 1, 0.0);
  k.front() = s.front();
  k.back() = s.back();
  for (std::size_t i = 1; i < s.size(); ++i) {
    if (s[i - 1] * s[i] <= 0) continue;
    const double mean =
        3 * (d[i - 1] + d[i]) / ((2 * d[i] + d[i - 1]) / s[i - 1] + (d[i] + 2 * d[i - 1]) / s[i]);
    const double limit = 2 * std::min(std::abs(s[i - 1]), std::abs(s[i]));
    k[i] = std::copysign(std::min(std::abs(mean), limit), mean);
  }
  return k;
}

// Slope of the segment whose bump is `bump`, at the share t of its width.
double slope_within(double k, double k_next, double bump, double t) {
  return k + (k_next - k) * t * t * (3 - 2 * t) + bump * t * t * (1 - t) * (1 - t);
}

const CurveSegment& segment_of(const Curve& c, double e) {
  const CurveSegment* s = c.segment;
  while (e >= s->end) ++s;
  return *s;
}

double integral_within(const CurveSegment& s, double t) {
  const double t2 = t * t;
  return t * (s.c0 + t * (s.c1 / 2 + t2 * (s.c3 / 4 + t * (s.c4 / 5 + t * s.c5 / 6))));
}

// Integrates the energy from segment to segment, outwards from e = 0.
void energies_set(Curve& c, int zero) {
  c.segment[zero].energy = 0;
  for (int k = zero + 1; k < c.segments; ++k) {
    const CurveSegment& before = c.segment[k - 1];
    c.segment[k].energy = before.energy + integral_within(before, c.segment[k].origin - before.origin);
  }
  for (int k = zero - 1; k >= 0; --k) {
    CurveSegment& s = c.segment[k];
    s.energy = c.segment[k + 1].energy - integral_within(s, s.end - s.origin);
  }
}

// Each bin starts slightly early, so that rounding never puts a strain into a bin that starts beyond the
// strain's segment.
void bins_set(Curve& c) {
  if (c.segments < 2) return;
  const double first = c.segment[0].end, last = c.segment[c.segments - 2].end;
  const double width = std::max(last - first, 1e-6) / (kCurveBins - 2);
  c.bin_scale = 1 / width;
  c.bin_shift = 1 - first / width;
  constexpr double kEarly = 1e-3;  // of a bin
  for (int i = 0; i < kCurveBins; ++i) {
    const double begin = first + (i - 1 - kEarly) * width, end = first + (i + kEarly) * width;
    const CurveSegment *at = &segment_of(c, i == 0 ? -1 : begin), *to = &segment_of(c, end);
    c.bin_begin[i] = static_cast<unsigned char>(at - c.segment);
    c.bin_ends = std::max(c.bin_ends, int(to - at));
  }
}

// True where bins of equal width from `low` on contain the first `ends` segment ends, at most one in a bin
// and none near the edge of a bin.
bool bins_part(const Curve& c, double low, double width, int ends) {
  constexpr double kEdge = 1e-6;  // of a bin
  double before = -1;
  for (int k = 0; k < ends; ++k) {
    const double at = (c.segment[k].end - low) / width, bin = std::floor(at);
    if (bin == before || at - bin < kEdge || at - bin > 1 - kEdge) return false;
    before = bin;
  }
  return true;
}

template <int kSize>
void start_fill(const Curve& c, double low, double width, double limit, CurveStart<kSize>& s) {
  s.low = low + 1e-3 * width;  // off the edge of the bin in spite of rounding
  s.limit = std::min(limit, low + (kSize - 1e-6) * width);
  s.scale = 1 / width;
  s.shift = -low / width - 0.5;
  for (int k = 0; k < kSize; ++k) {
    const CurveSegment& at = segment_of(c, low + k * width);
    s.first[k] = &at - c.segment;
    s.end[k] = at.end < low + (k + 1) * width ? at.end : std::numeric_limits<double>::quiet_NaN();
    const CurveSegment& row = c.segment[k];
    const double values[6] = {row.origin, row.c0, row.c1, row.c3, row.c4, row.c5};
    for (int q = 0; q < 6; ++q) s.column[q][k] = values[q];
  }
}

// Finds the bin width and position that cover the most segment ends. Candidate widths run from 1 to 1.5
// times the smallest possible width; the intervals between segment ends are candidates too.
template <int kSize>
void start_set(const Curve& c, CurveStart<kSize>& s) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr int kPhases = 32, kWidths = 12;
  if (c.segments < 2) return start_fill(c, 0, 1, kInfinite, s);
  const auto end = [&](int k) { return c.segment[k].end; };
  for (int ends = std::min(c.segments, kSize) - 1; ends > 0; --ends) {
    const double span = ends > 1 ? end(ends - 1) - end(0) : std::max(std::abs(end(0)), 1e-3);
    const double limit = ends == c.segments - 1 ? kInfinite : end(ends);
    for (int phase = 1; phase < kPhases; ++phase) {
      const double before = double(phase) / kPhases;  // of a bin, from `low` to the first end
      const double smallest = span / (kSize - before) * 1.001;
      for (int w = 0; w < kWidths + ends - 1; ++w) {
        const double width =
            w < kWidths ? smallest * (1 + w / (2.0 * kWidths)) : end(w - kWidths + 1) - end(w - kWidths);
        const double low = end(0) - before * width;
        if (width >= smallest && bins_part(c, low, width, ends)) return start_fill(c, low, width, limit, s);
      }
    }
  }
}

void starts_set(Curve& c) {
  start_set(c, c.start8);
  start_set(c, c.start16);
}

// The path of a slope from its values at the points where it turns, over the range of these values.
double path_over_range(const std::vector<double>& slope) {
  if (slope.empty()) return 1;
  const auto [low, high] = std::minmax_element(slope.begin(), slope.end());
  if (*high - *low <= kConstantSlope * std::max(std::abs(*low), std::abs(*high))) return 1;
  double path = 0;
  for (std::size_t i = 1; i < slope.size(); ++i) path += std::abs(slope[i] - slope[i - 1]);
  return path / (*high - *low);
}

}  // namespace

double slope_path(const std::vector<double>& e, const std::vector<double>& f) {
  if (e.size() < 2) return 1;
  std::vector<double> d, s;
  for (std::size_t i = 0; i + 1 < e.size(); ++i) {
    d.push_back(e[i + 1] - e[i]);
    s.push_back((f[i + 1] - f[i]) / d[i]);
  }
  const std::vector<double> k = slopes_of(d, s);
  std::vector<double> turns{k[0]};
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double rise = k[i + 1] - k[i], bump = 30 * (s[i] - (k[i] + k[i + 1]) / 2);
    // p'' = t (1 - t) [6 rise + 2 bump (1 - 2 t)]/d
    if (3 * std::abs(rise) < std::abs(bump))
      turns.push_back(slope_within(k[i], k[i + 1], bump, (1 + 3 * rise / bump) / 2));
    turns.push_back(k[i + 1]);
  }
  return path_over_range(turns);
}

double curve_slope_path(const Curve& c) {
  std::vector<double> turns;
  for (int k = 0; k + 1 < c.segments; ++k) {
    const CurveSegment& s = c.segment[k];
    if (s.origin < 0 || !(s.end <= c.last)) continue;
    turns.push_back(s.c1);
    // p'' = t (6 c3 + 12 c4 t + 20 c5 t^2) has the roots 0, d and one more.
    if (const double d = s.end - s.origin, turn = 0.3 * s.c3 / (s.c5 * d); turn > 0 && turn < d)
      turns.push_back(curve_slope(c, s.origin + turn));
    turns.push_back(curve_slope(c, s.end));
  }
  return path_over_range(turns);
}

Curve curve_make(const std::vector<double>& e, const std::vector<double>& f, const Continuation& below) {
  Curve c;
  c.odd = below.odd;
  if (e.size() < 2 || std::all_of(f.begin(), f.end(), [](double v) { return v == 0; })) return c;
  c.last = e.back();

  std::vector<double> d, s;
  for (std::size_t i = 0; i + 1 < e.size(); ++i) {
    d.push_back(e[i + 1] - e[i]);
    s.push_back((f[i + 1] - f[i]) / d[i]);
  }
  const std::vector<double> k = slopes_of(d, s);
  const double r = below.compression;

  const bool straight =
      std::all_of(s.begin(), s.end(), [&](double v) { return std::abs(v - s[0]) <= 1e-14 * std::abs(s[0]); });
  if (straight && (below.odd || r == 1)) {
    line_add(c, 0, 0, k[0]);
    starts_set(c);
    return c;
  }
  if (!below.odd && r != 1) {
    const double w = below.blend, f_blend = -k[0] * w * (1 + r) / 2;
    line_add(c, -w, f_blend, r * k[0]);
    segment_add(c, -w, {f_blend, w, r * k[0], k[0], k[0] * (1 + r) / 2});
  } else if (!below.odd) {
    line_add(c, 0, 0, k[0]);
  }
  const int zero = c.segments;
  for (std::size_t i = 0; i < s.size(); ++i) segment_add(c, e[i], {f[i], d[i], k[i], k[i + 1], s[i]});
  line_add(c, e.back(), f.back(), k.back());
  energies_set(c, zero);
  bins_set(c);
  starts_set(c);
  return c;
}

double curve_value(const Curve& c, double e) {
  const double x = c.odd ? std::abs(e) : e;
  const CurveSegment& s = segment_of(c, x);
  const double t = x - s.origin;
  const double f = s.c0 + t * (s.c1 + t * t * (s.c3 + t * (s.c4 + t * s.c5)));
  return c.odd ? std::copysign(1.0, e) * f : f;
}

double curve_slope(const Curve& c, double e) {
  const double x = c.odd ? std::abs(e) : e;
  const CurveSegment& s = segment_of(c, x);
  const double t = x - s.origin;
  return s.c1 + t * t * (3 * s.c3 + t * (4 * s.c4 + t * 5 * s.c5));
}

double curve_energy(const Curve& c, double e) {
  const double x = c.odd ? std::abs(e) : e;
  const CurveSegment& s = segment_of(c, x);
  return s.energy + integral_within(s, x - s.origin);
}

}  // namespace drape::math
