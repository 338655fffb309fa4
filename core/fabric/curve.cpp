#include "fabric/curve.h"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

// One segment of width d from value f: slope k to k_next, mean slope s (core/README.md, section 2, in powers
// of t).
void segment_add(Curve& c, double start, double origin, double f, double d, double k, double k_next,
                 double s) {
  const int i = c.segments++;
  const double bump = 30 * (s - (k + k_next) / 2);
  c.start[i] = start;
  c.origin[i] = origin;
  c.c0[i] = f;
  c.c1[i] = k;
  c.c3[i] = (k_next - k + bump / 3) / (d * d);
  c.c4[i] = -(k_next - k + bump) / (2 * d * d * d);
  c.c5[i] = bump / (5 * d * d * d * d);
}

void line_add(Curve& c, double start, double origin, double f, double k) {
  segment_add(c, start, origin, f, 1, k, k, k);
}

// Slopes at the points: the weighted harmonic mean of Fritsch and Butland (1984), at most twice the lesser
// secant.
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

int segment_of(const Curve& c, double e) {
  int k = 0;
  while (k + 1 < c.segments && e >= c.start[k + 1]) ++k;
  return k;
}

double integral_within(const Curve& c, int k, double t) {
  const double t2 = t * t;
  return t * (c.c0[k] + t * (c.c1[k] / 2 + t2 * (c.c3[k] / 4 + t * (c.c4[k] / 5 + t * c.c5[k] / 6))));
}

// energy[k] from segment to segment, outwards from e = 0.
void energies_set(Curve& c, int zero) {
  c.energy[zero] = 0;
  for (int k = zero + 1; k < c.segments; ++k)
    c.energy[k] = c.energy[k - 1] + integral_within(c, k - 1, c.origin[k] - c.origin[k - 1]);
  for (int k = zero - 1; k >= 0; --k) {
    const double t = c.start[k + 1] - c.origin[k];  // to the left end of segment k + 1, whose origin that is
    c.energy[k] = c.energy[k + 1] - integral_within(c, k, t);
  }
}

}  // namespace

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
    line_add(c, 0, 0, 0, k[0]);
    return c;
  }
  if (!below.odd && r != 1) {
    const double w = below.blend, f_blend = -k[0] * w * (1 + r) / 2;
    line_add(c, -w, -w, f_blend, r * k[0]);
    segment_add(c, -w, -w, f_blend, w, r * k[0], k[0], k[0] * (1 + r) / 2);
  } else if (!below.odd) {
    line_add(c, 0, 0, 0, k[0]);
  }
  const int zero = c.segments;
  for (std::size_t i = 0; i < s.size(); ++i) segment_add(c, e[i], e[i], f[i], d[i], k[i], k[i + 1], s[i]);
  line_add(c, e.back(), e.back(), f.back(), k.back());
  energies_set(c, zero);
  return c;
}

double curve_value(const Curve& c, double e) {
  if (c.segments == 0) return 0;
  const double x = c.odd ? std::abs(e) : e;
  const int k = segment_of(c, x);
  const double t = x - c.origin[k];
  const double f = c.c0[k] + t * (c.c1[k] + t * t * (c.c3[k] + t * (c.c4[k] + t * c.c5[k])));
  return c.odd ? std::copysign(1.0, e) * f : f;
}

double curve_slope(const Curve& c, double e) {
  if (c.segments == 0) return 0;
  const double x = c.odd ? std::abs(e) : e;
  const int k = segment_of(c, x);
  const double t = x - c.origin[k];
  return c.c1[k] + t * t * (3 * c.c3[k] + t * (4 * c.c4[k] + t * 5 * c.c5[k]));
}

double curve_energy(const Curve& c, double e) {
  if (c.segments == 0) return 0;
  const double x = c.odd ? std::abs(e) : e;
  const int k = segment_of(c, x);
  return c.energy[k] + integral_within(c, k, x - c.origin[k]);
}

}  // namespace drape
