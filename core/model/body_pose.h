// Maps between space and the frame of a body, and the body's velocity field.
#pragma once
#include "math/vector3.h"
#include "model/contact.h"

namespace drape::model {

// The point r of space in the body's frame: R^T (r - o).
inline Vec3 pose_inward(const Body& body, const BodyContact& c, const Vec3& at) {
  using namespace math::vector3;
  if (!body.moves) return at;
  const Vec3 d = at - c.motion.position;
  Vec3 x{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) x[k] += c.rotation[i][k] * d[i];
  return x;
}

// A direction n of the body's frame, in space: R n.
inline Vec3 pose_outward(const Body& body, const BodyContact& c, const Vec3& n) {
  using namespace math::vector3;
  if (!body.moves) return n;
  return {dot(c.rotation[0], n), dot(c.rotation[1], n), dot(c.rotation[2], n)};
}

// The velocity of the body at a point r of space, m/s: V + w x (r - o).
inline Vec3 pose_velocity(const Body& body, const BodyContact& c, const Vec3& at) {
  using namespace math::vector3;
  if (!body.moves) return {0, 0, 0};
  return c.motion.velocity + cross(c.motion.angular_velocity, at - c.motion.position);
}

// The acceleration of the body there, m/s^2: V' + w' x (r - o) + w x (w x (r - o)).
inline Vec3 pose_acceleration(const Body& body, const BodyContact& c, const Vec3& at) {
  using namespace math::vector3;
  if (!body.moves) return {0, 0, 0};
  const Vec3 arm = at - c.motion.position;
  return c.motion.acceleration + cross(c.motion.angular_acceleration, arm) +
         cross(c.motion.angular_velocity, cross(c.motion.angular_velocity, arm));
}

}  // namespace drape::model
