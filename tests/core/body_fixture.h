// Bodies as OBJ files in a folder that is deleted with the test.
#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "cloth_fixture.h"
#include "scene_file.h"

namespace drape::tests {

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

// A prism along y. Its edge at x = z = 0 falls by the angle on both sides, 0.2 m to either side.
inline Mesh roof(double angle) {
  const double x = 0.2 * std::cos(angle), z = -0.2 * std::sin(angle);
  Mesh m;
  m.point = {{0, -0.3, 0}, {0, 0.3, 0}, {x, 0.3, z}, {x, -0.3, z}, {-x, 0.3, z}, {-x, -0.3, z}};
  m.corner = {{0, 3, 2}, {0, 2, 1}, {1, 4, 5}, {1, 5, 0}, {5, 4, 2}, {5, 2, 3}, {0, 5, 3}, {1, 2, 4}};
  return m;
}

// A pyramid with its tip at the origin, whose sides fall by the angle.
inline Mesh pyramid(double angle) {
  const double a = 0.2 * std::cos(angle), z = -0.2 * std::sin(angle);
  Mesh m;
  m.point = {{0, 0, 0}, {a, a, z}, {-a, a, z}, {-a, -a, z}, {a, -a, z}};
  m.corner = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}};
  return m;
}

// Adds a body to a scene.
inline scene::BodySpec& body_add(Scene& scene, const SceneFolder& folder, const std::string& name,
                                 const Mesh& mesh) {
  scene::BodySpec body;
  body.name = name;
  body.mesh = folder.write(name + ".obj", obj_text(mesh)).string();
  scene.bodies.push_back(body);
  return scene.bodies.back();
}

inline Vec3 momentum(const Assembled& a, const Array (&v)[3]) {
  Vec3 sum{0, 0, 0};
  for (std::size_t n : a.system.particle)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += a.system.mass[n] * v[k][n];
  return sum;
}

// The force of the cloth on the first body at the present time (N), as the last half kick gives it.
inline Vec3 body_force(Assembled& a) {
  std::vector<math::Wrench> pins;
  Array v[3];
  for (Array& of : v) of.assign(a.system.nodes, 0.0);
  dynamics::leapfrog_synchronous(a.system, a.motion, a.state, {v[0].data(), v[1].data(), v[2].data()}, pins);
  return a.motion.contact.load[0].force;
}

// For a cloth at rest on the first body: the body bears the weight, up to the residual of a fit.
inline void expect_weight(Assembled& a) {
  double weight = 0;
  for (std::size_t n : a.system.particle) weight += 9.81 * a.system.mass[n];
  const Vec3 load = body_force(a);
  EXPECT_NEAR(load[0], 0, 2e-5 * weight);
  EXPECT_NEAR(load[1], 0, 2e-5 * weight);
  EXPECT_NEAR(load[2], -weight, 2e-5 * weight);
}

}  // namespace drape::tests
