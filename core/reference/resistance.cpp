// Equations: core/README.md, section 3.
//
//   link   x_i o----o x_j    u = (x_j - x_i)/l,  e' = (v_j - v_i).u/rest,  T = w beta p'(e) e'
//                            dissipated power: T rest e'
//
//   cell   c o---o d         d1 = r_d - r_a,  d2 = r_c - r_b,  s = d1 x d2,  n = s/|s|
//            |   |           u = (v_a + v_b + v_c + v_d)/4 - wind,  u_n = (u.n) n,  u_t = u - u_n
//          a o---o b         F = -(rho/2) (phi |s|/2) (C_n |u_n| u_n + C_t |u_t| u_t)
//                            a quarter on each corner
#include "reference/resistance.h"

#include "reference/forces.h"

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d at(const VectorXd& x, int i) { return x.segment<3>(3 * i); }

}  // namespace

double add_link_damping(const Lattice& lattice, const VectorXd& r, const VectorXd& v, VectorXd& F) {
  double dissipated = 0;
  for (const std::vector<Link>* links : {&lattice.warp, &lattice.weft, &lattice.bias})
    for (const Link& link : *links) {
      const Law& law = lattice.laws[std::size_t(link.law)];
      if (law.damping == 0) continue;
      const Vector3d u = (at(r, link.j) - at(r, link.i)).normalized();
      const double rate = (at(v, link.j) - at(v, link.i)).dot(u) / link.rest;
      const double tension = link.width * law.damping * curve_slope(law.curve, link_strain(link, r)) * rate;
      F.segment<3>(3 * link.i) += tension * u;
      F.segment<3>(3 * link.j) -= tension * u;
      dissipated += tension * link.rest * rate;
    }
  return dissipated;
}

AirPower add_air(const Lattice& lattice, const Air& air, const Vector3d& wind, const VectorXd& r,
                 const VectorXd& v, VectorXd& F) {
  AirPower power{0, 0};
  if (air.density == 0) return power;
  for (const Cell& cell : lattice.cells) {
    const auto [a, b, c, d] = cell.node;
    const Vector3d s = (at(r, d) - at(r, a)).cross(at(r, c) - at(r, b));
    if (s.squaredNorm() == 0) continue;
    const Vector3d u = (at(v, a) + at(v, b) + at(v, c) + at(v, d)) / 4 - wind;
    const Vector3d n = s.normalized(), across = u.dot(n) * n, along = u - across;
    const Vector3d push = -air.density / 2 * cell.share * s.norm() / 2 *
                          (air.normal * across.norm() * across + air.tangential * along.norm() * along);
    for (int corner : cell.node) F.segment<3>(3 * corner) += push / 4;
    power.dissipated -= push.dot(u);
    power.input += push.dot(wind);
  }
  return power;
}

}  // namespace drape::reference
