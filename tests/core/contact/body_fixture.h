// Bodies as OBJ files in a folder that goes with the test.
#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "cloth_fixture.h"
#include "scene/scene_file.h"

namespace drape {

struct Mesh {
  std::vector<Vec3> point;
  std::vector<std::array<int, 3>> corner;
};

inline std::string obj_text(const Mesh& mesh) {
  std::string text;
  char line[120];
  for (const Vec3& p : mesh.point) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    text += line;
  }
  for (const auto& c : mesh.corner) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", c[0] + 1, c[1] + 1, c[2] + 1);
    text += line;
  }
  return text;
}

// A box about the origin.
inline Mesh box(double a, double b, double c) {
  Mesh m;
  for (int k = 0; k < 8; ++k)
    m.point.push_back({(k & 4 ? a : -a) / 2, (k & 2 ? b : -b) / 2, (k & 1 ? c : -c) / 2});
  const int side[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& q : side) {
    m.corner.push_back({q[0], q[1], q[2]});
    m.corner.push_back({q[0], q[2], q[3]});
  }
  return m;
}

// A ball about the origin: 2 n (n - 1) triangles.
inline Mesh ball(double radius, int n) {
  Mesh m;
  const double pi = std::numbers::pi;
  m.point.push_back({0, 0, radius});
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double t = pi * i / n, f = 2 * pi * j / n;
      m.point.push_back(
          {radius * std::sin(t) * std::cos(f), radius * std::sin(t) * std::sin(f), radius * std::cos(t)});
    }
  m.point.push_back({0, 0, -radius});
  const int last = int(m.point.size()) - 1;
  const auto at = [&](int i, int j) { return 1 + (i - 1) * n + j % n; };
  for (int j = 0; j < n; ++j) {
    m.corner.push_back({0, at(1, j), at(1, j + 1)});
    m.corner.push_back({last, at(n - 1, j + 1), at(n - 1, j)});
    for (int i = 1; i + 1 < n; ++i) {
      m.corner.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.corner.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return m;
}

// A cylinder about the y axis, with ends.
inline Mesh cylinder(double radius, double length, int n) {
  Mesh m;
  for (int j = 0; j < n; ++j) {
    const double f = 2 * std::numbers::pi * j / n;
    for (double y : {-length / 2, length / 2})
      m.point.push_back({radius * std::sin(f), y, radius * std::cos(f)});
  }
  m.point.push_back({0, -length / 2, 0});
  m.point.push_back({0, length / 2, 0});
  for (int j = 0; j < n; ++j) {
    const int a = 2 * j, b = 2 * ((j + 1) % n);
    m.corner.push_back({a, b, b + 1});
    m.corner.push_back({a, b + 1, a + 1});
    m.corner.push_back({2 * n, b, a});
    m.corner.push_back({2 * n + 1, a + 1, b + 1});
  }
  return m;
}

inline FabricSpec linen(double thickness = 1e-3) {
  FabricSpec fabric;
  fabric.name = "linen";
  fabric.areal_density = 0.2;
  fabric.thickness = thickness;
  fabric.warp = reference::straight(2000);
  fabric.weft = reference::straight(2000);
  fabric.bias = reference::diagram({0, 0.05, 0.1, 0.15}, {0, 1, 2, 3});
  fabric.bending_warp = fabric.bending_weft = 1e-5;
  return fabric;
}

// Adds a body to a scene.
inline BodySpec& body_add(Scene& scene, const SceneFolder& folder, const std::string& name,
                          const Mesh& mesh) {
  BodySpec body;
  body.name = name;
  body.mesh = folder.write(name + ".obj", obj_text(mesh)).string();
  scene.bodies.push_back(body);
  return scene.bodies.back();
}

}  // namespace drape
