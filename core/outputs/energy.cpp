#include "outputs/energy.h"

#include <cmath>

#include "forces/bending_constants.h"
#include "outputs/links.h"

namespace drape {
namespace {

Vec3 edge_of(const State& s, std::size_t from, std::size_t to) {
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}
double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// theta^2/2 between two edges; from sine and cosine, exact for flat cloth too.
double hinge_between(const Vec3& a, const Vec3& c) {
  const double lengths = std::sqrt(dot(a, a) * dot(c, c)), y = dot(a, c) / lengths;
  if (y < kSharp) return hinge_energy(y);
  const Vec3 n = cross(a, c);
  const double theta = std::atan2(std::sqrt(dot(n, n)), dot(a, c));
  return theta * theta / 2;
}

double bending_of(const System& system, const Lattice& l, const State& s) {
  double sum = 0;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      const std::size_t n = l.node(i, j), row = std::size_t(l.stride);
      const double* here = &system.share[n];
      const double* below = here - l.stride;
      const double share = ((below[-1] + below[0]) + (here[-1] + here[0])) / 4;
      if (below[-1] + here[-1] > 0 && below[0] + here[0] > 0)
        sum += l.law.bending_weft * share * hinge_between(edge_of(s, n - 1, n), edge_of(s, n, n + 1));
      if (below[-1] + below[0] > 0 && here[-1] + here[0] > 0)
        sum += l.law.bending_warp * share * hinge_between(edge_of(s, n - row, n), edge_of(s, n, n + row));
    }
  return sum;
}

}  // namespace

double hinge_energy(double y) {
  if (y >= kSharp) return std::pow(std::acos(std::fmin(y, 1.0)), 2) / 2;
  const double d = kSharp - y, theta = std::acos(kSharp);
  return theta * theta / 2 + d * (kSharpPsi + d * (-kSharpPsi1 / 2 + d * kSharpPsi2 / 6));
}

drape_energy energy_potential(const System& system, const State& s) {
  drape_energy e{};
  for (const Lattice& l : system.lattices) {
    each_link(system, l, [&](const Link& link) {
      double& kind = link.law == &l.law.bias ? e.shear : e.stretch;
      kind += link.width * link.rest * curve_energy(*link.law, link_strain(s, link));
    });
    e.bending += bending_of(system, l, s);
  }
  const Vec3& g = system.gravity;
  for (std::size_t n : system.particle)
    e.gravity -= system.mass[n] * (g[0] * s.x[n] + g[1] * s.y[n] + g[2] * s.z[n]);
  return e;
}

double energy_kinetic(const System& system, const Array& vx, const Array& vy, const Array& vz) {
  double sum = 0;
  for (std::size_t n : system.particle)
    sum += system.mass[n] * (vx[n] * vx[n] + vy[n] * vy[n] + vz[n] * vz[n]);
  return sum / 2;
}

}  // namespace drape
