// Equations: core/README.md, section 3.
//
//   link   x_i o----o x_j    d = x_j - x_i,  l = |d|,  e = l/rest - 1,  T = w p(e)
//                            F_i = T d/l = -F_j,   E = w rest * (integral of p from 0 to e)
//
//   hinge  x0 o-a-o x1       u = a/|a|,  v = c/|c|,  y = u.v = cos(theta),  psi = theta/sin(theta)
//                  \c        F_2 = kappa psi (u - y v)/|c|,  F_0 = -kappa psi (v - y u)/|a|
//                   o x2     F_1 = -F_0 - F_2,   E = kappa theta^2/2
//
//   clamp  R D ~~~> x0 o--o x1   the same with u = R D and v along the link x1 - x0:
//                            F_1 = kappa psi (u - y v)/|c| = -F_0,  couple on the clamp -(x1 - x0) x F_1
//
// Beyond 120 degrees psi is its Taylor polynomial of degree 2 in y, and E follows from dE = -kappa psi dy.
#include "reference/forces.h"

#include <cmath>
#include <numbers>

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSeriesAngle = 1e-2;  // the first neglected term, 127 theta^8/604800, is below 1e-19

Vector3d at(const VectorXd& r, int i) { return r.segment<3>(3 * i); }

void add_links(const Lattice& lattice, const std::vector<Link>& links, const VectorXd& r, VectorXd& F) {
  for (const Link& link : links) {
    const Vector3d d = at(r, link.j) - at(r, link.i);
    const double length = d.norm();
    const double tension =
        link.width * curve_value(lattice.laws[std::size_t(link.law)].curve, length / link.rest - 1);
    const Vector3d pull = tension / length * d;
    F.segment<3>(3 * link.i) += pull;
    F.segment<3>(3 * link.j) -= pull;
  }
}

double links_energy(const Lattice& lattice, const std::vector<Link>& links, const VectorXd& r) {
  double energy = 0;
  for (const Link& link : links) {
    const Curve& curve = lattice.laws[std::size_t(link.law)].curve;
    energy += link.width * link.rest * curve_energy(curve, link_strain(link, r));
  }
  return energy;
}

double angle_over_sine(double theta) {
  if (theta > kSeriesAngle) return theta / std::sin(theta);
  const double q = theta * theta;
  return 1 + q / 6 + 7 * q * q / 360 + 31 * q * q * q / 15120;
}

}  // namespace

double link_strain(const Link& link, const VectorXd& r) {
  return (at(r, link.j) - at(r, link.i)).norm() / link.rest - 1;
}

Fold fold_of(const Vector3d& a, const Vector3d& c) {
  constexpr double pi = std::numbers::pi;
  const double theta = std::atan2(a.cross(c).norm(), a.dot(c));
  const double y = a.normalized().dot(c.normalized());
  if (theta <= 2 * pi / 3) return {y, angle_over_sine(theta), theta * theta / 2};

  // Taylor coefficients at y_0 = -1/2, where 1 - y_0^2 = 3/4
  const double psi_0 = 4 * pi / (3 * std::numbers::sqrt3);
  const double psi_1 = (-0.5 * psi_0 - 1) / 0.75;
  const double psi_2 = (psi_0 + 3 * -0.5 * psi_1) / 0.75;
  const double x = y + 0.5, d = -x;
  const double psi = psi_0 + psi_1 * x + psi_2 * x * x / 2;
  const double energy =
      (2 * pi / 3) * (2 * pi / 3) / 2 + psi_0 * d - psi_1 * d * d / 2 + psi_2 * d * d * d / 6;
  return {y, psi, energy};
}

void add_stretch(const Lattice& lattice, const VectorXd& r, VectorXd& F) {
  add_links(lattice, lattice.warp, r, F);
  add_links(lattice, lattice.weft, r, F);
}

void add_shear(const Lattice& lattice, const VectorXd& r, VectorXd& F) {
  add_links(lattice, lattice.bias, r, F);
}

void add_bending(const Lattice& lattice, const VectorXd& r, VectorXd& F) {
  for (const Hinge& hinge : lattice.hinges) {
    const Vector3d a = at(r, hinge.j) - at(r, hinge.i), c = at(r, hinge.k) - at(r, hinge.j);
    const Vector3d u = a.normalized(), v = c.normalized();
    const Fold fold = fold_of(a, c);
    const Vector3d F2 = hinge.kappa * fold.psi / c.norm() * (u - fold.y * v);
    const Vector3d F0 = -hinge.kappa * fold.psi / a.norm() * (v - fold.y * u);
    F.segment<3>(3 * hinge.k) += F2;
    F.segment<3>(3 * hinge.i) += F0;
    F.segment<3>(3 * hinge.j) -= F0 + F2;
  }
}

Turns unturned(const Lattice& lattice) { return Turns(lattice.pins.size(), Eigen::Matrix3d::Identity()); }

VectorXd add_clamps(const Lattice& lattice, const Turns& turns, const VectorXd& r, VectorXd& F) {
  VectorXd couple = VectorXd::Zero(3 * Eigen::Index(lattice.pins.size()));
  for (const ClampHinge& clamp : lattice.clamps) {
    const Vector3d u = turns[std::size_t(clamp.pin)] * clamp.direction;
    const Vector3d c = at(r, clamp.j) - at(r, clamp.i);
    const Fold fold = fold_of(u, c);
    const Vector3d pull = clamp.kappa * fold.psi / c.norm() * (u - fold.y * c.normalized());
    F.segment<3>(3 * clamp.j) += pull;
    F.segment<3>(3 * clamp.i) -= pull;
    couple.segment<3>(3 * clamp.pin) -= c.cross(pull);
  }
  return couple;
}

VectorXd forces(const Lattice& lattice, const VectorXd& r, const Turns& turns) {
  VectorXd F = VectorXd::Zero(3 * lattice.count);
  add_stretch(lattice, r, F);
  add_shear(lattice, r, F);
  add_bending(lattice, r, F);
  add_clamps(lattice, turns, r, F);
  return F;
}

VectorXd forces(const Lattice& lattice, const VectorXd& r) { return forces(lattice, r, unturned(lattice)); }

double stretch_energy(const Lattice& lattice, const VectorXd& r) {
  return links_energy(lattice, lattice.warp, r) + links_energy(lattice, lattice.weft, r);
}

double shear_energy(const Lattice& lattice, const VectorXd& r) {
  return links_energy(lattice, lattice.bias, r);
}

double bending_energy(const Lattice& lattice, const VectorXd& r) {
  double energy = 0;
  for (const Hinge& hinge : lattice.hinges) {
    energy += hinge.kappa * fold_of(at(r, hinge.j) - at(r, hinge.i), at(r, hinge.k) - at(r, hinge.j)).energy;
  }
  return energy;
}

double clamp_energy(const Lattice& lattice, const Turns& turns, const VectorXd& r) {
  double energy = 0;
  for (const ClampHinge& clamp : lattice.clamps) {
    const Vector3d c = at(r, clamp.j) - at(r, clamp.i);
    energy += clamp.kappa * fold_of(turns[std::size_t(clamp.pin)] * clamp.direction, c).energy;
  }
  return energy;
}

}  // namespace drape::reference
