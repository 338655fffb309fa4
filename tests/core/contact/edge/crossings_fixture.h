// Whether cloth goes through a body: a segment through a triangle, with no use of the contact's own geometry.
#pragma once
#include "body_fixture.h"
#include "math/vector3.h"
#include "model/elements.h"

namespace drape::tests {

// Whether the segment a b goes through the triangle p q r.
inline bool passes_through(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
  using namespace math::vector3;
  const Vec3 normal = cross(q - p, r - p);
  const double from = dot(a - p, normal), to = dot(b - p, normal);
  if (!(from * to < 0)) return false;
  const Vec3 x = a + (from / (from - to)) * (b - a);
  return dot(cross(q - p, x - p), normal) > 0 && dot(cross(r - q, x - q), normal) > 0 &&
         dot(cross(p - r, x - r), normal) > 0;
}

// Whether the segment p q goes through the bilinear surface of the corners a, b, c, d. In the plane across
// the segment, two equations A + B u + C v + D u v = 0 hold; without v they are one quadratic equation of u.
inline bool passes_through_cell(const Vec3& p, const Vec3& q, const Vec3* c) {
  using namespace math::vector3;
  const Vec3 along = q - p, twist = (c[3] - c[2]) - (c[1] - c[0]);
  const Vec3 other = std::abs(along[0]) < 0.6 * norm(along) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 axis[2] = {unit(cross(along, other)), unit(cross(along, cross(along, other)))};
  double of[2][4];
  for (int k = 0; k < 2; ++k) {
    const Vec3 part[4] = {c[0] - p, c[1] - c[0], c[2] - c[0], twist};
    for (int i = 0; i < 4; ++i) of[k][i] = dot(axis[k], part[i]);
  }
  const auto product = [&](int i, int j) { return of[0][i] * of[1][j] - of[1][i] * of[0][j]; };
  const double q2 = product(1, 3), q1 = product(0, 3) + product(1, 2), q0 = product(0, 2);
  const double det = q1 * q1 - 4 * q2 * q0;
  if (!(det >= 0)) return false;
  const double far = -(q1 + std::copysign(std::sqrt(det), q1)) / 2;
  for (const double u : {q2 != 0 ? far / q2 : NAN, far != 0 ? q0 / far : NAN}) {
    if (!(u > 0 && u < 1)) continue;
    const int k = std::abs(of[0][2] + of[0][3] * u) > std::abs(of[1][2] + of[1][3] * u) ? 0 : 1;
    const double v = -(of[k][0] + of[k][1] * u) / (of[k][2] + of[k][3] * u);
    if (!(v > 0 && v < 1)) continue;
    const Vec3 x = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]) + (u * v) * twist;
    const double t = dot(x - p, along) / dot(along, along);
    if (t > 0 && t < 1) return true;
  }
  return false;
}

// Counts the links that go through triangles of a mesh, and the bilinear cells that its edges go through.
inline int crossings(const Assembled& a, const Mesh& body) {
  using namespace math::vector3;
  int count = 0;
  const auto place = [&](std::size_t n) { return Vec3{a.state.x[n], a.state.y[n], a.state.z[n]}; };
  std::vector<std::array<Vec3, 3>> triangle;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high = -1.0 * low;
  for (const auto& c : body.corner) {
    triangle.push_back(
        {body.point[std::size_t(c[0])], body.point[std::size_t(c[1])], body.point[std::size_t(c[2])]});
    for (const Vec3& p : triangle.back())
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  const auto apart = [&](const Vec3* x, int n) {
    for (std::size_t k = 0; k < 3; ++k) {
      bool below = true, above = true;
      for (int i = 0; i < n; ++i) below = below && x[i][k] < low[k], above = above && x[i][k] > high[k];
      if (below || above) return true;
    }
    return false;
  };
  const auto through_body = [&](const Vec3& p, const Vec3& q) {
    for (const auto& t : triangle)
      if (passes_through(p, q, t[0], t[1], t[2])) return true;
    return false;
  };
  for (const model::Lattice& l : a.system.lattices)
    model::cells_visit(a.system, l, [&](const std::size_t* corner, double) {
      Vec3 c[4];
      for (int k = 0; k < 4; ++k) c[k] = place(corner[k]);
      if (apart(c, 4)) return;
      for (const auto& side : {std::array<int, 2>{0, 1}, {0, 2}, {1, 3}, {2, 3}})
        count += through_body(c[side[0]], c[side[1]]);
      bool cut = false;
      for (const auto& t : triangle)
        for (std::size_t k = 0; k < 3 && !cut; ++k) cut = passes_through_cell(t[k], t[(k + 1) % 3], c);
      count += cut;
    });
  return count;
}

}  // namespace drape::tests
