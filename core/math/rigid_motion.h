// The motion of a rigid body, such as a pin, and rotations as unit quaternions (w, x, y, z).
//
// exp(f) is the rotation by the angle |f| about f:   exp(f) = (cos(|f|/2), f sin(|f|/2)/|f|).
//
// With R(z) = exp(f(z)) R_0, A = (1 - cos|f|)/|f|^2 and B = (|f| - sin|f|)/|f|^3, the angular velocity is
//
//     w = f' + A f x f' + B f x (f x f').
#pragma once
#include <array>

#include "math/vector3.h"

namespace drape::math {

using Quaternion = std::array<double, 4>;

struct RigidMotion {
  Vec3 position{0, 0, 0};              // p, m
  Quaternion orientation{1, 0, 0, 0};  // R, rotation since the start
  Vec3 velocity{0, 0, 0};              // m/s
  Vec3 angular_velocity{0, 0, 0};      // rad/s
  Vec3 acceleration{0, 0, 0};          // m/s^2
  Vec3 angular_acceleration{0, 0, 0};  // rad/s^2
};

// A force and a torque (N, N m), or their impulses (N s, N m s), of a pin or body on the outside world.
struct Wrench {
  Vec3 force{0, 0, 0}, torque{0, 0, 0};  // the torque about the present position
};

Quaternion quaternion_product(const Quaternion& a, const Quaternion& b);
Quaternion quaternion_normalised(const Quaternion& q);  // q must have a length above 0

std::array<Vec3, 3> rotation_matrix(const Quaternion& q);  // row by row

// R x - x; exactly 0 where R is the identity.
Vec3 rotation_displacement(const Quaternion& q, const Vec3& x);

Quaternion rotation_exp(const Vec3& f);
// The rotation vector (rad, length at most pi) from one orientation to another; exactly 0 where they are
// equal.
Vec3 rotation_vector_between(const Quaternion& from, const Quaternion& to);

// The angular velocity and angular acceleration of exp(f), from f and its derivatives f1 = f' and f2 = f''.
Vec3 rotation_angular_velocity(const Vec3& f, const Vec3& f1);
Vec3 rotation_angular_acceleration(const Vec3& f, const Vec3& f1, const Vec3& f2);
// The f' that gives this angular velocity: the inverse of rotation_angular_velocity, for |f| at most pi.
Vec3 rotation_vector_rate(const Vec3& f, const Vec3& angular_velocity);

}  // namespace drape::math
