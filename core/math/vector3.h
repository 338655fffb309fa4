// Points and vectors in two and three dimensions, and their arithmetic.
#pragma once
#include <array>
#include <cmath>

namespace drape::math {

using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;

namespace vector3 {

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline void operator+=(Vec3& a, const Vec3& b) { a = a + b; }
inline void operator-=(Vec3& a, const Vec3& b) { a = a - b; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(const Vec3& a) {  // of length 1; the zero vector stays zero
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : a;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace vector3
}  // namespace drape::math

namespace drape {
using math::Vec2;
using math::Vec3;
}  // namespace drape
