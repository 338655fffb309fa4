#include "piece/place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape {
namespace {

double dot(Vec3 a, Vec3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 sum(Vec3 a, double s, Vec3 b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }

Vec3 cross(Vec3 a, Vec3 b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 plane_point(const PlaceSpec& place, Vec2 q) {
  return sum(sum(place.origin, q[0], place.axis_x), q[1], place.axis_y);
}

// Of the plane: from the axis of its cylinder to it, where it does not hold the axis.
Vec3 plane_normal(const PlaceSpec& place) {
  const Vec3 n = cross(place.axis_x, place.axis_y);
  const Vec3 d = sum(place.origin, -1, place.axis_point);
  const double height = place.radius > 0 ? dot(n, d) : 0;
  return height < -1e-9 * (std::sqrt(dot(d, d)) + place.radius) ? Vec3{-n[0], -n[1], -n[2]} : n;
}

struct Placed {
  Vec3 at, normal;
};

Placed placed(const PlaceSpec& place, Vec2 q) {
  const Vec3 p = plane_point(place, q), n = plane_normal(place);
  if (!(place.radius > 0)) return {p, n};
  const Vec3 t = cross(place.axis, n), d = sum(p, -1, place.axis_point);
  const double f = dot(d, t) / place.radius, c = std::cos(f), s = std::sin(f);
  const Vec3 out = sum({c * n[0], c * n[1], c * n[2]}, s, t);
  return {sum(sum(place.axis_point, dot(d, place.axis), place.axis), place.radius, out), out};
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

Vec3 place_point(const PlaceSpec& place, Vec2 point) { return placed(place, point).at; }

Vec3 place_start(const PlaceSpec& place, const Waves& waves, Vec2 point) {
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

}  // namespace drape
