// A body's pose, place by place.
#pragma once
#include "math/vector3.h"
#include "model/contact.h"

namespace drape::model {

// Where a place is in the body's frame: R^T (r - o).
inline Vec3 pose_inward(const Body& body, const BodyContact& c, const Vec3& at) {
  using namespace math::vector3;
  if (!body.moves) return at;
  const Vec3 d = at - c.frame.position;
  Vec3 x{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) x[k] += c.turn[i][k] * d[i];
  return x;
}

// A direction of the body's frame in space: R n.
inline Vec3 pose_outward(const Body& body, const BodyContact& c, const Vec3& n) {
  using namespace math::vector3;
  if (!body.moves) return n;
  return {dot(c.turn[0], n), dot(c.turn[1], n), dot(c.turn[2], n)};
}

// The velocity of the body at a place r in space: V + w x (r - o).
inline Vec3 pose_velocity(const Body& body, const BodyContact& c, const Vec3& at) {
  using namespace math::vector3;
  if (!body.moves) return {0, 0, 0};
  return c.frame.velocity + cross(c.frame.spin, at - c.frame.position);
}

// Its acceleration there: V' + w' x (r - o) + w x (w x (r - o)).
inline Vec3 pose_acceleration(const Body& body, const BodyContact& c, const Vec3& at) {
  using namespace math::vector3;
  if (!body.moves) return {0, 0, 0};
  const Vec3 arm = at - c.frame.position;
  return c.frame.acceleration + cross(c.frame.spin_rate, arm) + cross(c.frame.spin, cross(c.frame.spin, arm));
}

}  // namespace drape::model
