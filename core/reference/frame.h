// The frame of a pin, in which the held points are at rest, and its path within an advance. core/README.md,
// section 4, "Inputs".
#pragma once
#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "scene/scene.h"

namespace drape::reference {

// Position p, m, and rotation R since the start, with their first two time derivatives.
struct Frame {
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero(), a = Eigen::Vector3d::Zero();
  Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
  Eigen::Vector3d w = Eigen::Vector3d::Zero(), w_rate = Eigen::Vector3d::Zero();  // angular
};

// The motion of a held point whose start is d = X - p_0 relative to the frame.
struct Target {
  Eigen::Vector3d r, v, a;
};
Target target_of(const Frame& frame, const Eigen::Vector3d& d);

// A vector as a cubic c0 + c1 t + c2 t^2 + c3 t^3, where t is the time since the beginning of the advance.
struct Cubic {
  Eigen::Vector3d c[4] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                          Eigen::Vector3d::Zero()};
};

// p(t) and R(t) = exp(f(t)) R(0).
struct Path {
  Cubic p, f;
  Eigen::Quaterniond R0 = Eigen::Quaterniond::Identity();
};

// The path from a frame, in `length` seconds, to those values of `set` that the drive names: p and R, v and
// w, or all.
Path path_make(const Frame& from, scene::Drive drive, bool turns, const Frame& set, double length);
Frame path_frame(const Path& path, double time);  // time since the beginning, s

Eigen::Quaterniond rotation_exp(const Eigen::Vector3d& f);
Eigen::Vector3d rotation_log(const Eigen::Quaterniond& q);  // length at most pi

}  // namespace drape::reference
