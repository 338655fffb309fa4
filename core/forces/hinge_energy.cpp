#include "forces/hinge_energy.h"

#include <cmath>

#include "forces/bending_constants.h"

namespace drape::forces {
namespace {

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

double hinge_energy(double y) {
  if (y >= kSharp) return std::pow(std::acos(std::fmin(y, 1.0)), 2) / 2;
  const double d = kSharp - y, theta = std::acos(kSharp);
  return theta * theta / 2 + d * (kSharpPsi + d * (-kSharpPsi1 / 2 + d * kSharpPsi2 / 6));
}

double hinge_energy_between(const Vec3& a, const Vec3& c) {
  const double y = dot(a, c) / std::sqrt(dot(a, a) * dot(c, c));
  if (y < kSharp) return hinge_energy(y);
  const Vec3 n = cross(a, c);
  const double theta = std::atan2(std::sqrt(dot(n, n)), dot(a, c));
  return theta * theta / 2;
}

}  // namespace drape::forces
