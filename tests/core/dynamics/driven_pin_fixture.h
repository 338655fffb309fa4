// Pieces whose pins follow prescribed motions, and vectors and rotations as Eigen has them.
#pragma once
#include <Eigen/Geometry>
#include <numbers>

#include "cloth_fixture.h"

namespace drape::tests {

using V = Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

inline V vec(const Vec3& v) { return {v[0], v[1], v[2]}; }
inline Vec3 arr(const V& v) { return {v[0], v[1], v[2]}; }
inline Eigen::Quaterniond quat(const math::Quaternion& q) { return {q[0], q[1], q[2], q[3]}; }
inline math::Quaternion turn_about(const V& axis, double angle) {
  const V u = axis.normalized() * std::sin(angle / 2);
  return {std::cos(angle / 2), u[0], u[1], u[2]};
}

// A sheet, 4.4 by 3.7 cells, whose left edge (inside cut cells where `cut`) a clamp may turn.
inline Scene sheet(scene::Drive drive, bool cut = true,
                   scene::Integrator integrator = scene::Integrator::kLeapfrog) {
  Scene scene = reference::rectangle(reference::curved_fabric(), cut ? 0.044 : 0.04, 0.037, 0.01, true);
  scene.pins = {reference::pin_edges("right", {1})};
  if (cut)
    scene.pins.push_back(
        reference::pin_edges("left", {3}));  // takes the grid line: "right" lies in cut cells
  scene.pins[0].drive = drive;
  scene.pins[0].clamp = true;
  scene.integrator = integrator;
  return scene;
}

// Every node held by one clamp.
inline Scene rigid(scene::Drive drive) {
  Scene scene = reference::rectangle(reference::curved_fabric(), 0.03, 0.02, 0.01, true);
  scene::PinSpec pin = reference::pin_at("all", {});
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i <= 3; ++i) pin.at.push_back({0.01 * i, 0.01 * j});
  pin.clamp = true;
  pin.drive = drive;
  scene.pins = {pin};
  return scene;
}

}  // namespace drape::tests
