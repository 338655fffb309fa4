#include "body/surface_walk.h"

#include <algorithm>
#include <cmath>

#include "math/vector3.h"

namespace drape::body {
namespace {

using namespace math::vector3;

constexpr int kMaxTriangles = 256;  // of a path; the rest of it is straight
constexpr double kAway = 1e-9;      // of the direction: slower, a path never leaves through an edge

// The edge of a triangle's own three through which a path leaves, and after what length, m.
struct Exit {
  std::size_t edge = 3;
  double length = INFINITY;
};
Exit exit_of(const BodySurface& s, int triangle, int entered, const Vec3& from, const Vec3& along) {
  Exit exit;
  for (std::size_t k = 0; k < 3; ++k) {
    const int number = s.edge[std::size_t(triangle)][k];
    if (number == entered) continue;
    const SurfaceEdge& e = s.edges[std::size_t(number)];
    const std::size_t side = e.triangle[0] == triangle ? 0 : 1;
    const double away = -dot(along, e.into[side]);
    if (!(away > kAway)) continue;
    const double length = std::max(dot(from - s.point[std::size_t(e.corner[0])], e.into[side]), 0.0) / away;
    if (length < exit.length) exit = {k, length};
  }
  return exit;
}

}  // namespace

SurfaceWalk surface_walk(const BodySurface& s, const WalkStart& start, double distance, double bend) {
  int triangle = start.triangle;
  Vec3 at = start.from, to = start.along;
  double done = 0;  // m, of the path
  bool bends = false;
  SurfaceWalk walk;
  const auto go = [&](double length) {
    at += length * to;
    done += length;
    const Vec3 arm = at - start.from;
    walk.drop = std::max(walk.drop, -dot(arm, start.up));
    bends = bends || norm(arm - dot(arm, start.along) * start.along) > bend;
    if (!bends) walk.straight = done;
  };
  int entered = -1;
  for (int k = 0; k < kMaxTriangles && done < distance; ++k) {
    const Exit exit = exit_of(s, triangle, entered, at, to);
    if (!(exit.length < distance - done)) break;
    go(exit.length);
    entered = s.edge[std::size_t(triangle)][exit.edge];
    const SurfaceEdge& e = s.edges[std::size_t(entered)];
    if (e.triangle.size() != 2) break;
    const std::size_t next = e.triangle[0] == triangle ? 1 : 0;
    const Vec3 edge = unit(s.point[std::size_t(e.corner[1])] - s.point[std::size_t(e.corner[0])]);
    const double with = dot(to, edge);
    to = unit(with * edge + std::sqrt(std::max(1 - with * with, 0.0)) * e.into[next]);
    triangle = e.triangle[next];
  }
  if (done < distance) go(distance - done);
  return walk;
}

}  // namespace drape::body
