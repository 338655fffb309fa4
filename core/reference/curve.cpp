// Equations: core/README.md, section 2. On segment i, with t = (e - e_i)/d_i and j = k_{i+1} - k_i,
//
//     f'(e) = k_i + j (3t^2 - 2t^3) + 30 q t^2 (1 - t)^2,                       q = s_i - (k_i + k_{i+1})/2
//     f(e)  = f_i + d_i { k_i t + j (t^3 - t^4/2) + 30 q (t^3/3 - t^4/2 + t^5/5) }
//     E(e)  = E_i + f_i d_i t + d_i^2 { k_i t^2/2 + j (t^4/4 - t^5/10) + 30 q (t^4/12 - t^5/10 + t^6/30) }
//
// where s is the slope of the secant. Inner slopes are the weighted harmonic mean of Fritsch and Butland
// (1984), SIAM J. Sci. Stat. Comput. 5, 300, limited to twice the smaller secant.
#include "reference/curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace drape::reference {
namespace {

constexpr double kLockingGap = 1e-6;       // smallest distance of a stretch from sqrt(2)
constexpr double kSweepConverged = 1e-14;  // relative to the last force
constexpr int kSweepLimit = 10000;
constexpr double kSmallestWeight = 0.02;  // of the residual, in a sweep

double secant(const Curve& c, std::size_t i) { return (c.f[i + 1] - c.f[i]) / (c.e[i + 1] - c.e[i]); }

double inner_slope(const Curve& c, std::size_t i) {
  const double left = c.e[i] - c.e[i - 1], right = c.e[i + 1] - c.e[i];
  const double s_left = secant(c, i - 1), s_right = secant(c, i);
  if (s_left * s_right <= 0) return 0;
  const double mean = 3 * (left + right) / ((2 * right + left) / s_left + (right + 2 * left) / s_right);
  return std::min(mean, 2 * std::min(s_left, s_right));
}

// The index of the segment that contains an elongation in [0, e_n).
std::size_t segment_of(const Curve& c, double e) {
  return std::size_t(std::upper_bound(c.e.begin() + 1, c.e.end() - 1, e) - c.e.begin()) - 1;
}

struct Segment {
  double t, d, f, k, j, q;
};

Segment segment_at(const Curve& c, std::size_t i, double e) {
  const double d = c.e[i + 1] - c.e[i];
  return {(e - c.e[i]) / d, d, c.f[i], c.k[i], c.k[i + 1] - c.k[i], secant(c, i) - (c.k[i] + c.k[i + 1]) / 2};
}

double segment_energy(const Segment& s) {
  const double t = s.t, t2 = t * t, t4 = t2 * t2;
  const double slopes = s.k * t2 / 2 + s.j * (t4 / 4 - t4 * t / 10);
  const double bump = 30 * s.q * (t4 / 12 - t4 * t / 10 + t4 * t2 / 30);
  return s.f * s.d * t + s.d * s.d * (slopes + bump);
}

}  // namespace

Curve curve_make(const std::vector<double>& e, const std::vector<double>& f, Below below, double ratio,
                 double blend) {
  Curve c{e, f, std::vector<double>(e.size()), below, ratio, blend};
  if (e.size() < 2) return Curve{};
  const std::size_t n = e.size() - 1;
  c.k[0] = secant(c, 0);
  c.k[n] = secant(c, n - 1);
  for (std::size_t i = 1; i < n; ++i) c.k[i] = inner_slope(c, i);
  return c;
}

double curve_value(const Curve& c, double e) {
  if (c.e.empty()) return 0;
  if (e < 0 && c.below == Below::kOdd) return -curve_value(c, -e);
  if (e < 0) {
    const double r = c.ratio, b = c.blend, k0 = c.k[0];
    if (e <= -b) return -k0 * b * (1 + r) / 2 + r * k0 * (e + b);
    const double u = 1 + e / b, u3 = u * u * u;
    return k0 * b * (r * (u - 1) + (1 - r) * (u3 - u3 * u / 2 - 0.5));
  }
  if (e >= c.e.back()) return c.f.back() + c.k.back() * (e - c.e.back());
  const Segment s = segment_at(c, segment_of(c, e), e);
  const double t = s.t, t3 = t * t * t, t4 = t3 * t;
  return s.f + s.d * (s.k * t + s.j * (t3 - t4 / 2) + 30 * s.q * (t3 / 3 - t4 / 2 + t4 * t / 5));
}

double curve_slope(const Curve& c, double e) {
  if (c.e.empty()) return 0;
  if (e < 0 && c.below == Below::kOdd) return curve_slope(c, -e);
  if (e < 0) {
    if (e <= -c.blend) return c.ratio * c.k[0];
    const double u = 1 + e / c.blend;
    return c.k[0] * (c.ratio + (1 - c.ratio) * u * u * (3 - 2 * u));
  }
  if (e >= c.e.back()) return c.k.back();
  const Segment s = segment_at(c, segment_of(c, e), e);
  const double t = s.t, t2 = t * t;
  return s.k + s.j * t2 * (3 - 2 * t) + 30 * s.q * t2 * (1 - t) * (1 - t);
}

double curve_energy(const Curve& c, double e) {
  if (c.e.empty()) return 0;
  if (e < 0 && c.below == Below::kOdd) return curve_energy(c, -e);
  if (e < 0) {
    // The antiderivative of f(u) from u = 1 to max(u, 0); beyond, a parabola.
    const double r = c.ratio, b = c.blend, k0 = c.k[0];
    const double u = e <= -b ? 0 : 1 + e / b, u4 = u * u * u * u;
    const double at_u = r * (u * u / 2 - u) + (1 - r) * (u4 / 4 - u4 * u / 10 - u / 2);
    const double at_1 = -r / 2 - (1 - r) * 0.35;
    const double blend = k0 * b * b * (at_u - at_1);
    if (e > -b) return blend;
    return blend - k0 * b * (1 + r) / 2 * (e + b) + r * k0 * (e + b) * (e + b) / 2;
  }
  double energy = 0;
  const bool beyond = e >= c.e.back();
  const std::size_t last = beyond ? c.e.size() - 1 : segment_of(c, e);
  for (std::size_t i = 0; i < last; ++i) energy += segment_energy(segment_at(c, i, c.e[i + 1]));
  if (!beyond) return energy + segment_energy(segment_at(c, last, e));
  const double x = e - c.e.back();
  return energy + c.f.back() * x + c.k.back() * x * x / 2;
}

std::vector<double> below_locking(const std::vector<double>& e) {
  std::vector<double> kept;
  for (double x : e) {
    if (1 + x < std::numbers::sqrt2 - kLockingGap) kept.push_back(x);
  }
  return kept;
}

Curve odd_law(const std::vector<double>& e, const std::vector<double>& P) {
  const std::vector<double> kept = below_locking(e);
  const std::size_t points = kept.size();
  if (points < 2)
    throw std::runtime_error("odd bias law: no point of the diagram lies below 41.4 % elongation");
  for (double weight = 0.5; weight > kSmallestWeight; weight /= 2) {
    std::vector<double> g(points);
    for (std::size_t i = 0; i < points; ++i) g[i] = P[i] / 2;
    for (int sweep = 0; sweep < kSweepLimit; ++sweep) {
      const Curve old = curve_make(kept, g, Below::kOdd);
      double change = 0;
      for (std::size_t i = 1; i < points; ++i) {
        const double l1 = 1 + kept[i], l2 = std::sqrt(2 - l1 * l1);
        const double rest = P[i] - g[i] - curve_value(old, std::abs(l2 - 1)) * l1 / l2;
        const double risen = std::max(g[i] + weight * rest, g[i - 1]);
        change = std::max(change, std::abs(risen - g[i]));
        g[i] = risen;
      }
      if (change <= kSweepConverged * P[points - 1]) return curve_make(kept, g, Below::kOdd);
      if (!std::isfinite(change)) break;
    }
  }
  throw std::runtime_error("odd bias law: the sweep for g(L) + g(|e2|) l1/l2 = P(L) does not come to rest");
}

}  // namespace drape::reference
