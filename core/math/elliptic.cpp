// Carlson's forms, by his duplication theorem (B. C. Carlson, Numerical computation of real or complex
// elliptic integrals, 1995; DLMF 19.25.9, 19.36.1 and 19.36.2): each turn divides the differences of the
// arguments by four, and a Taylor series about equal arguments is left, cut at the order 6.
//
//   E(f, k) = s R_F(c^2, 1 - k^2 s^2, 1) - k^2 s^3/3 R_D(c^2, 1 - k^2 s^2, 1),  c = cos f, s = sin f, |f| <=
//   pi/2
#include "math/elliptic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::math {
namespace {

constexpr double kNear = 1e-3;  // of the differences over the mean: their sixth power is below the rounding

double carlson_rf(double x, double y, double z) {
  for (;;) {
    const double mean = (x + y + z) / 3, dx = 1 - x / mean, dy = 1 - y / mean, dz = 1 - z / mean;
    if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) < kNear) {
      const double e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
      return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
    }
    const double p = std::sqrt(x), q = std::sqrt(y), r = std::sqrt(z), l = p * q + p * r + q * r;
    x = (x + l) / 4;
    y = (y + l) / 4;
    z = (z + l) / 4;
  }
}

double carlson_rd(double x, double y, double z) {
  double total = 0, share = 1;
  for (;;) {
    const double mean = (x + y + 3 * z) / 5, dx = 1 - x / mean, dy = 1 - y / mean, dz = -(dx + dy) / 3;
    if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) < kNear) {
      const double xy = dx * dy, zz = dz * dz;
      const double e2 = xy - 6 * zz, e3 = (3 * xy - 8 * zz) * dz, e4 = 3 * (xy - zz) * zz, e5 = xy * zz * dz;
      const double series =
          1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
      return 3 * total + share * series / (mean * std::sqrt(mean));
    }
    const double p = std::sqrt(x), q = std::sqrt(y), r = std::sqrt(z), l = p * q + p * r + q * r;
    total += share / (r * (z + l));
    share /= 4;
    x = (x + l) / 4;
    y = (y + l) / 4;
    z = (z + l) / 4;
  }
}

// E for the angle whose sine and cosine are given, in [-pi/2, pi/2].
double within_half_turn(double sine, double cosine, double modulus) {
  const double k2 = modulus * modulus, y = 1 - k2 * sine * sine;
  if (k2 == 1) return sine;  // the forms diverge at the right angle, each alone
  return sine * carlson_rf(cosine * cosine, y, 1) -
         k2 * sine * sine * sine / 3 * carlson_rd(cosine * cosine, y, 1);
}

}  // namespace

double elliptic_second(double angle, double modulus) {
  const double half_turns = std::floor(angle / std::numbers::pi + 0.5),
               rest = angle - half_turns * std::numbers::pi;
  const double part = within_half_turn(std::sin(rest), std::cos(rest), modulus);
  return half_turns == 0 ? part : 2 * half_turns * within_half_turn(1, 0, modulus) + part;
}

}  // namespace drape::math
