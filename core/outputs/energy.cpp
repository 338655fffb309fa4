#include "outputs/energy.h"

#include <cmath>

#include "forces/bending_constants.h"
#include "forces/side.h"
#include "system/links.h"

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
  each_hinge(system, l, [&](std::size_t n0, std::size_t n1, std::size_t n2, bool warp, double share) {
    const double rigidity = law_bending(l.law, warp);
    if (rigidity > 0) sum += rigidity * share * hinge_between(edge_of(s, n0, n1), edge_of(s, n1, n2));
  });
  for (const SideClamp& c : system.side.clamps)
    if (c.lattice == l.piece)
      sum += law_bending(l.law, c.warp) * c.share *
             hinge_between(clamp_direction(c, s), edge_of(s, c.node[0], c.node[1]));
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
      double& kind = link.along == Thread::kBias ? e.shear : e.stretch;
      kind += link.width * link.rest * curve_energy(law_curve(l.law, link.along), link_strain(s, link));
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
