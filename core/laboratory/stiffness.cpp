// Link with rest length R, width w, law p, strain e = l/R - 1, tension T = w p(e), direction u:
//
//     K = (w p'/R - T/l) u u^T + (T/l) 1          acts on the difference of its ends.
//
// Hinge between edges a and c, y = u.v = cos theta, E(y) = kappa theta^2/2, dE/dy = -kappa psi:
//
//     K = -kappa [psi' y' y'^T + psi y''],        psi' = (y psi - 1)/(1 - y^2),
//     dy/da = (v - y u)/|a|,     d2y/da2 = -[u p^T + p u^T + y (1 - u u^T)]/|a|^2,  p = v - y u,
//     d2y/da dc = (1 - u u^T)(1 - v v^T)/(|a||c|),
//
// and the same with a, u and c, v exchanged.
#include "laboratory/stiffness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "forces/bending_constants.h"
#include "forces/irregular_elements.h"
#include "model/elements.h"

namespace drape::laboratory {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Psi {
  double value, slope;
};

// psi = theta/sin theta and its slope in y, continued beyond 120 degrees: core/README.md, section 3.
Psi psi_at(double y, double sine) {
  if (y < forces::kSharp) {
    const double d = y - forces::kSharp;
    return {forces::kSharpPsi + forces::kSharpPsi1 * d + forces::kSharpPsi2 * d * d / 2,
            forces::kSharpPsi1 + forces::kSharpPsi2 * d};
  }
  const double s2 = sine * sine, angle = std::atan2(sine, y);
  if (s2 < 1e-6) return {1 + s2 / 6, -1.0 / 3 - 2 * s2 / 15};  // the next terms: 3 s^4/40, s^4/12
  const double psi = angle / sine;
  return {psi, (y * psi - 1) / s2};
}

// Second derivatives of a hinge's energy with respect to its two edges, N/m.
struct HingeStiffness {
  Matrix3d aa, ac, cc;
};
HingeStiffness hinge_stiffness(const Vector3d& a, const Vector3d& c, double kappa) {
  const double la = a.norm(), lc = c.norm();
  const Vector3d u = a / la, v = c / lc;
  const double y = u.dot(v);
  const Psi psi = psi_at(y, u.cross(v).norm());
  const Vector3d p = v - y * u, q = u - y * v;
  const Matrix3d one = Matrix3d::Identity(), across_a = one - u * u.transpose(),
                 across_c = one - v * v.transpose();
  const auto bent = [&](const Matrix3d& outer, const Matrix3d& second, double lengths) {
    return Matrix3d(-kappa / lengths * (psi.slope * outer + psi.value * second));
  };
  return {bent(p * p.transpose(), -(u * p.transpose() + p * u.transpose() + y * across_a), la * la),
          bent(p * q.transpose(), across_a * across_c, la * lc),
          bent(q * q.transpose(), -(v * q.transpose() + q * v.transpose() + y * across_c), lc * lc)};
}

Vector3d edge_of(const State& s, std::size_t from, std::size_t to) {
  return {s.x[to] - s.x[from], s.y[to] - s.y[from], s.z[to] - s.z[from]};
}

void block_add(const Unknowns& unknowns, std::size_t row, std::size_t column, const Matrix3d& k,
               Triplets& to) {
  const Eigen::Index r = unknowns.first[row], c = unknowns.first[column];
  for (int i = 0; i < unknowns.dimension; ++i)
    for (int j = 0; j < unknowns.dimension; ++j) to.emplace_back(r + i, c + j, k(i, j));
}

// Adds K that acts on the difference x1 - x0.
void difference_add(const Unknowns& unknowns, std::size_t n0, std::size_t n1, const Matrix3d& k,
                    Triplets& to) {
  block_add(unknowns, n0, n0, k, to);
  block_add(unknowns, n0, n1, -k, to);
  block_add(unknowns, n1, n0, -k, to);
  block_add(unknowns, n1, n1, k, to);
}

void link_add(const model::Lattice& l, const State& s, Stiffness which, const Unknowns& unknowns,
              const model::Link& link, Triplets& to) {
  const math::Curve& law = model::law_curve(l.law, link.along);
  if (law.segments == 0) return;
  const Vector3d edge = edge_of(s, link.from, link.to);
  const double length = edge.norm(), strain = model::link_strain(s, link);
  double geometric = link.width * math::curve_value(law, strain) / length,
         material = link.width * math::curve_slope(law, strain) / link.rest;
  if (which == Stiffness::kNonNegative)
    geometric = std::max(geometric, 0.0), material = std::max(material, 0.0);
  const Vector3d u = edge / length;
  difference_add(unknowns, link.from, link.to,
                 (material - geometric) * u * u.transpose() + geometric * Matrix3d::Identity(), to);
}

void hinge_add(const State& s, const Unknowns& unknowns, const std::array<std::size_t, 3>& n, double kappa,
               Triplets& to) {
  const HingeStiffness h = hinge_stiffness(edge_of(s, n[0], n[1]), edge_of(s, n[1], n[2]), kappa);
  // a = x1 - x0, c = x2 - x1
  const double da[3] = {-1, 1, 0}, dc[3] = {0, -1, 1};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      block_add(unknowns, n[std::size_t(i)], n[std::size_t(j)],
                da[i] * da[j] * h.aa + da[i] * dc[j] * h.ac + dc[i] * da[j] * h.ac.transpose() +
                    dc[i] * dc[j] * h.cc,
                to);
}

}  // namespace

Unknowns unknowns_make(const System& system, int dimension) {
  Unknowns unknowns;
  unknowns.dimension = dimension;
  unknowns.first.assign(system.nodes, -1);
  for (std::size_t n : system.particle) {
    unknowns.first[n] = unknowns.count;
    unknowns.count += dimension;
  }
  return unknowns;
}

void stiffness_add(const System& system, const State& s, Stiffness which, const Unknowns& unknowns,
                   Triplets& to) {
  for (const model::Lattice& l : system.lattices) {
    model::links_visit(system, l,
                       [&](const model::Link& link) { link_add(l, s, which, unknowns, link, to); });
    model::hinges_visit(system, l,
                        [&](std::size_t n0, std::size_t n1, std::size_t n2, bool warp, double share) {
                          const double kappa = model::law_bending(l.law, warp) * share;
                          if (kappa > 0) hinge_add(s, unknowns, {n0, n1, n2}, kappa, to);
                        });
    for (const model::ClampHinge& c : system.irregular.clamps) {
      const double kappa = model::law_bending(l.law, c.warp) * c.share;
      if (c.lattice != l.piece || kappa == 0) continue;
      const Vec3 held = forces::clamp_direction(c, s);
      const Vector3d direction(held[0], held[1], held[2]);
      difference_add(unknowns, c.node[0], c.node[1],
                     hinge_stiffness(direction, edge_of(s, c.node[0], c.node[1]), kappa).cc, to);
    }
  }
}

}  // namespace drape::laboratory
