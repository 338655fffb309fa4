// With R = exp(f) and theta = |f|, the left Jacobian of the rotations gives the angular velocity (Chirikjian
// 2011):
//
//     w  = f' + A f x f' + B f x (f x f')
//     w' = f'' + A f x f'' + B [f x (f x f'') + f' x (f x f')] + A' f x f' + B' f x (f x f')
//     A  = (1 - cos theta)/theta^2,       A' = (f.f') A_1,   A_1 = (sin theta/theta - 2 A)/theta^2
//     B  = (theta - sin theta)/theta^3,   B' = (f.f') B_1,   B_1 = (A - 3 B)/theta^2
//
// with A_1 = (dA/dtheta)/theta, and B_1 likewise. For theta below 1 the power series are used:
//
//     A = sum (-1)^k theta^2k/(2k + 2)!,  B = sum (-1)^k theta^2k/(2k + 3)!
//
// If the angular velocity changes linearly from w_0 to w_1 within H, then R = exp(f_1) R(0) with
// f_1 = H (w_0 + w_1)/2 + H^2 w_1 x w_0/12, to the fourth order in H (Magnus 1954).
#include "reference/frame.h"

#include <cmath>

namespace drape::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Jacobian {
  double A, B, A_1, B_1;
};

Jacobian jacobian_series(double square) {  // square: theta^2
  Jacobian J{0, 0, 0, 0};
  double term = 1, lower = 0;  // (-1)^k theta^2k/(2k)!, and that over theta^2
  for (int k = 0; k < 12; ++k) {
    const double a = 1.0 / ((2 * k + 1) * (2 * k + 2)), b = a / (2 * k + 3);
    J.A += term * a;
    J.B += term * b;
    J.A_1 += 2 * k * lower * a;
    J.B_1 += 2 * k * lower * b;
    lower = -term * a;
    term = lower * square;
  }
  return J;
}

Jacobian jacobian_of(const Vector3d& f) {
  const double square = f.squaredNorm(), theta = std::sqrt(square);
  if (theta < 1) return jacobian_series(square);
  const double half = std::sin(theta / 2);
  Jacobian J;
  J.A = 2 * half * half / square;
  J.B = (1 - std::sin(theta) / theta) / square;
  J.A_1 = (std::sin(theta) / theta - 2 * J.A) / square;
  J.B_1 = (J.A - 3 * J.B) / square;
  return J;
}

// The rate f' at f for the angular velocity w.
Vector3d turn_rate(const Vector3d& f, const Vector3d& w) {
  Matrix3d cross;
  cross << 0, -f[2], f[1], f[2], 0, -f[0], -f[1], f[0], 0;
  const Jacobian J = jacobian_of(f);
  return (Matrix3d::Identity() + J.A * cross + J.B * cross * cross).partialPivLu().solve(w);
}

Cubic line(const Vector3d& from, const Vector3d& to, double H) {
  return {{from, (to - from) / H, Vector3d::Zero(), Vector3d::Zero()}};
}

// The cubic through both ends, with the slopes u and w there.
Cubic hermite(const Vector3d& from, const Vector3d& to, const Vector3d& u, const Vector3d& w, double H) {
  const Vector3d reach = (to - from) / H;
  return {{from, u, (3 * reach - 2 * u - w) / H, (u + w - 2 * reach) / (H * H)}};
}

Vector3d at(const Cubic& q, double t) { return q.c[0] + t * (q.c[1] + t * (q.c[2] + t * q.c[3])); }
Vector3d slope(const Cubic& q, double t) { return q.c[1] + t * (2 * q.c[2] + 3 * t * q.c[3]); }
Vector3d bend(const Cubic& q, double t) { return 2 * q.c[2] + 6 * t * q.c[3]; }

}  // namespace

Target target_of(const Frame& frame, const Vector3d& d) {
  const Vector3d arm = frame.R * d;
  return {frame.p + arm, frame.v + frame.w.cross(arm),
          frame.a + frame.w_rate.cross(arm) + frame.w.cross(frame.w.cross(arm))};
}

Quaterniond rotation_exp(const Vector3d& f) {
  const double half = f.norm() / 2;
  const double s = half < 1e-4 ? 0.5 - half * half / 12 : std::sin(half) / (2 * half);
  return {std::cos(half), s * f[0], s * f[1], s * f[2]};
}

Vector3d rotation_log(const Quaterniond& q) {
  const double sign = q.w() < 0 ? -1 : 1, length = q.vec().norm();
  if (length == 0) return Vector3d::Zero();
  return sign * 2 * std::atan2(length, std::abs(q.w())) / length * q.vec();
}

Path path_make(const Frame& from, scene::Drive drive, bool turns, const Frame& set, double H) {
  const Vector3d zero = Vector3d::Zero();
  Path path;
  path.R0 = from.R;
  path.p.c[0] = from.p;
  const Vector3d f = turns ? rotation_log(set.R.normalized() * from.R.conjugate()) : zero;
  if (drive == scene::Drive::kPosition) {
    path.p = line(from.p, set.p, H);
    path.f = line(zero, f, H);
  } else if (drive == scene::Drive::kVelocity) {
    path.p = {{from.p, from.v, (set.v - from.v) / (2 * H), zero}};
    if (!turns) return path;
    const Vector3d turn = H * (from.w + set.w) / 2 + H * H / 12 * set.w.cross(from.w);
    path.f = hermite(zero, turn, from.w, turn_rate(turn, set.w), H);
  } else if (drive == scene::Drive::kBoth) {
    path.p = hermite(from.p, set.p, from.v, set.v, H);
    if (turns) path.f = hermite(zero, f, from.w, turn_rate(f, set.w), H);
  }
  return path;
}

Frame path_frame(const Path& path, double t) {
  const Vector3d f = at(path.f, t), f1 = slope(path.f, t), f2 = bend(path.f, t);
  const Jacobian J = jacobian_of(f);
  const double growth = f.dot(f1);
  Frame frame;
  frame.p = at(path.p, t);
  frame.v = slope(path.p, t);
  frame.a = bend(path.p, t);
  frame.R = (rotation_exp(f) * path.R0).normalized();
  frame.w = f1 + J.A * f.cross(f1) + J.B * f.cross(f.cross(f1));
  frame.w_rate = f2 + J.A * f.cross(f2) + J.B * (f.cross(f.cross(f2)) + f1.cross(f.cross(f1))) +
                 growth * (J.A_1 * f.cross(f1) + J.B_1 * f.cross(f.cross(f1)));
  return frame;
}

}  // namespace drape::reference
