#include "math/rigid_motion.h"

#include <algorithm>

#include "math/vector3.h"

namespace drape::math {
namespace {

using namespace vector3;

constexpr double kSmall = 0.3;  // rad^2; below it, five terms of the series are exact to rounding

// c_0 + c_1 x + ... + c_4 x^4
double series(double x, const double (&c)[5]) {
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
}

// A and B of rigid_motion.h, and their derivatives with respect to |f|^2 / 2, as functions of x = |f|^2.
double spin_a(double x) {
  if (x < kSmall) return series(x, {1. / 2, -1. / 24, 1. / 720, -1. / 40320, 1. / 3628800});
  return (1 - std::cos(std::sqrt(x))) / x;
}
double spin_b(double x) {
  if (x < kSmall) return series(x, {1. / 6, -1. / 120, 1. / 5040, -1. / 362880, 1. / 39916800});
  const double t = std::sqrt(x);
  return (t - std::sin(t)) / (x * t);
}
double spin_a1(double x) {
  if (x < kSmall) return series(x, {-1. / 12, 1. / 180, -1. / 6720, 1. / 453600, -1. / 47900160});
  const double t = std::sqrt(x);
  return (t * std::sin(t) - 2 + 2 * std::cos(t)) / (x * x);
}
double spin_b1(double x) {
  if (x < kSmall) return series(x, {-1. / 60, 1. / 1260, -1. / 60480, 1. / 4989600, -1. / 622702080});
  const double t = std::sqrt(x);
  return (3 * std::sin(t) - 2 * t - t * std::cos(t)) / (x * x * t);
}

}  // namespace

Quaternion quaternion_product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + (a[2] * b[3] - a[3] * b[2]),
          a[0] * b[2] + a[2] * b[0] + (a[3] * b[1] - a[1] * b[3]),
          a[0] * b[3] + a[3] * b[0] + (a[1] * b[2] - a[2] * b[1])};
}

Quaternion quaternion_normalised(const Quaternion& q) {
  double largest = 0;  // scale to size 1 first: the squares of small components may underflow
  for (double x : q) largest = std::max(largest, std::abs(x));
  const Quaternion s{q[0] / largest, q[1] / largest, q[2] / largest, q[3] / largest};
  const double size = std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + s[3] * s[3]);
  return {s[0] / size, s[1] / size, s[2] / size, s[3] / size};
}

// R x = x + 2 w u x x + 2 u x (u x x)
Vec3 rotation_displacement(const Quaternion& q, const Vec3& x) {
  const Vec3 u{q[1], q[2], q[3]}, ux = cross(u, x);
  return 2 * (q[0] * ux + cross(u, ux));
}

std::array<Vec3, 3> rotation_matrix(const Quaternion& q) {
  std::array<Vec3, 3> r;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 axis{k == 0 ? 1. : 0., k == 1 ? 1. : 0., k == 2 ? 1. : 0.},
        image = axis + rotation_displacement(q, axis);
    for (std::size_t i = 0; i < 3; ++i) r[i][k] = image[i];
  }
  return r;
}

Quaternion rotation_exp(const Vec3& f) {
  const double half = norm(f) / 2;
  if (half == 0) return {1, 0, 0, 0};
  const double s = std::sin(half) / (2 * half);
  return {std::cos(half), s * f[0], s * f[1], s * f[2]};
}

Vec3 rotation_vector_between(const Quaternion& from, const Quaternion& to) {
  const Quaternion q = quaternion_product(to, {from[0], -from[1], -from[2], -from[3]});
  const Vec3 u{q[1], q[2], q[3]};
  const double sine = norm(u);
  if (sine == 0) return {0, 0, 0};
  return (2 * std::atan2(sine, std::abs(q[0])) / (q[0] < 0 ? -sine : sine)) * u;
}

Vec3 rotation_angular_velocity(const Vec3& f, const Vec3& f1) {
  const double x = dot(f, f);
  const Vec3 c = cross(f, f1);
  return f1 + spin_a(x) * c + spin_b(x) * cross(f, c);
}

Vec3 rotation_angular_acceleration(const Vec3& f, const Vec3& f1, const Vec3& f2) {
  const double x = dot(f, f), x1 = dot(f, f1);
  const Vec3 c = cross(f, f1), c1 = cross(f, f2);
  return f2 + spin_a(x) * c1 + spin_b(x) * (cross(f1, c) + cross(f, c1)) + x1 * spin_a1(x) * c +
         x1 * spin_b1(x) * cross(f, c);
}

// f' = w - f x w/2 + [1 - (t/2) cot(t/2)]/t^2 f x (f x w),  t = |f|
Vec3 rotation_vector_rate(const Vec3& f, const Vec3& angular_velocity) {
  const double x = dot(f, f), half = std::sqrt(x) / 2;
  const double c = x < kSmall ? series(x, {1. / 12, 1. / 720, 1. / 30240, 1. / 1209600, 1. / 47900160})
                              : (1 - half / std::tan(half)) / x;
  const Vec3 across = cross(f, angular_velocity);
  return angular_velocity - 0.5 * across + c * cross(f, across);
}

}  // namespace drape::math
