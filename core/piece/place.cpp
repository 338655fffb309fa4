#include "piece/place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/elliptic.h"

namespace drape::piece {
namespace {

double dot(Vec3 a, Vec3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 sum(Vec3 a, double s, Vec3 b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }

Vec3 cross(Vec3 a, Vec3 b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 plane_point(const scene::PlaceSpec& place, Vec2 q) {
  return sum(sum(place.origin, q[0], place.axis_x), q[1], place.axis_y);
}

// The unit normal of the plane. It points from the axis of the cylinder to the plane, unless the axis is in
// the plane.
Vec3 plane_normal(const scene::PlaceSpec& place) {
  const Vec3 n = cross(place.axis_x, place.axis_y);
  const Vec3 d = sum(place.origin, -1, place.axis_point);
  const double size = place.radius[0], height = size > 0 ? dot(n, d) : 0;
  return height < -1e-9 * (std::sqrt(dot(d, d)) + size) ? Vec3{-n[0], -n[1], -n[2]} : n;
}

// Arc length of the ellipse (a sin f, b cos f) from 0 to f, by the elliptic integral of the second kind:
//
//   s(f) = int_0^f sqrt(a^2 cos^2 u + b^2 sin^2 u) du = a E(f, k),  k^2 = 1 - b^2/a^2      for a >= b,
//                                                     = b [E(k') - E(pi/2 - f, k')]        for a < b
constexpr double kQuarter = std::numbers::pi / 2;  // rad
double arc_length(Vec2 radius, double f) {
  const auto [a, b] = radius;
  if (a >= b) return a * math::elliptic_second(f, std::sqrt(1 - b * b / (a * a)));
  const double k = std::sqrt(1 - a * a / (b * b));
  return b * (math::elliptic_second(kQuarter, k) - math::elliptic_second(kQuarter - f, k));
}

// The f at which s(f) = s. Within a quarter of the ellipse s' is monotone, so Newton's method started at the
// end with the larger s' converges from one side.
double arc_angle(Vec2 radius, double s) {
  const auto [a, b] = radius;
  if (a == b) return s / a;
  const double quarter = std::floor(s / arc_length(radius, kQuarter));
  const bool even = std::fmod(quarter, 2) == 0;  // s' runs from a to b there, else from b to a
  double f = kQuarter * ((even == (a > b)) ? quarter : quarter + 1);
  for (int k = 0; k < 60; ++k) {
    const double step = (arc_length(radius, f) - s) / std::hypot(a * std::cos(f), b * std::sin(f));
    f -= step;
    if (!(std::abs(step) > 1e-10)) break;  // the remaining error is of the order of step^2
  }
  return f;
}

struct Placed {
  Vec3 at, normal;
};

Placed placed(const scene::PlaceSpec& place, Vec2 q) {
  const Vec3 p = plane_point(place, q), n = plane_normal(place);
  const auto [a, b] = place.radius;
  if (!(a > 0)) return {p, n};
  const Vec3 t = cross(place.axis, n), d = sum(p, -1, place.axis_point);
  const double f = arc_angle(place.radius, dot(d, t)), c = std::cos(f), s = std::sin(f);
  const Vec3 foot = sum(place.axis_point, dot(d, place.axis), place.axis);
  const double size = a == b ? a : std::hypot(a * c, b * s);
  const Vec3 out = sum({a * c / size * n[0], a * c / size * n[1], a * c / size * n[2]}, b * s / size, t);
  return {sum(sum(foot, b * c, n), a * s, t), out};
}

// splitmix64 (Steele, Lea, Flood 2014): the next number in [0, 1)
double uniform(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  z ^= z >> 31;
  return double(z >> 11) * 0x1p-53;
}

}  // namespace

Waves waves_make(const Scene& scene, int piece) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const std::vector<Vec2>& outline = scene.pieces[std::size_t(piece)].outline;
  Vec2 low = outline[0], high = low;
  for (const Vec2& p : outline)
    for (std::size_t a = 0; a < 2; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1]);
  std::uint64_t state =
      std::uint64_t(scene.imperfection_seed) + std::uint64_t(1000003) * std::uint64_t(piece);
  Waves w;
  w.height = scene.imperfection_amplitude / 8;
  for (int k = 0; k < 8; ++k) {
    const double a = kTurn * uniform(state), b = kTurn * uniform(state);
    const double number = kTurn / (diagonal * std::exp2(-(k + 1) / 2.0));
    w.x[k] = number * std::cos(a);
    w.y[k] = number * std::sin(a);
    w.shift[k] = b - w.x[k] * low[0] - w.y[k] * low[1];
  }
  return w;
}

Vec3 place_point(const scene::PlaceSpec& place, Vec2 point) { return placed(place, point).at; }

Vec3 place_start(const scene::PlaceSpec& place, const Waves& waves, Vec2 point) {
  const Placed p = placed(place, point);
  if (waves.height == 0) return p.at;
  double sines = 0;
  for (int k = 0; k < 8; ++k)
    sines += std::sin(waves.x[k] * point[0] + waves.y[k] * point[1] + waves.shift[k]);
  return sum(p.at, waves.height * sines, p.normal);
}

Vec3 place_start(const Scene& scene, int piece, Vec2 point) {
  return place_start(scene.pieces[std::size_t(piece)].place, waves_make(scene, piece), point);
}

}  // namespace drape::piece
