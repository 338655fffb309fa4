// A clamp's hinge lies between R D, turned by its pin, and the link v = (x1 - x0)/l:
//
//   x0 o------o x1     y = R D.v;   force on x1: kappa_c psi (R D - y v)/l, on x0 its opposite;
//        v             torque on the pin: kappa_c psi (R D x v), as (x1 - x0) x F = kappa_c psi v x R D
#include "forces/side.h"

#include "forces/air.h"
#include "forces/bending.h"
#include "forces/damping.h"
#include "forces/lane_scalar.h"
#include "forces/tension.h"
#include "system/links.h"

namespace drape {
namespace {

using L = ScalarLane<false>;
using V = Vec<L>;

V node_at(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

// Velocity extrapolated to t_n.
V node_speed(const State& s, std::size_t n, double lead) {
  const V v{s.vx[n], s.vy[n], s.vz[n]}, w{s.wx[n], s.wy[n], s.wz[n]};
  return v + (v - w) * L(lead);
}

void slot_add(SideForces f, int slot, V force) {
  f.x[slot] += force.x.v;
  f.y[slot] += force.y.v;
  f.z[slot] += force.z.v;
}
void slot_take(SideForces f, int slot, V force) {
  f.x[slot] -= force.x.v;
  f.y[slot] -= force.y.v;
  f.z[slot] -= force.z.v;
}

struct Edge {
  V unit;
  L inverse, length;
};
Edge edge_of(const State& s, std::size_t from, std::size_t to) {
  const V d = node_at(s, to) - node_at(s, from);
  const L length = sqrt(dot(d, d)), inverse = L(1.0) / length;
  return {d * inverse, inverse, length};
}

void links_add(const System& system, const State& s, bool rates, double lead, SideForces f) {
  for (const SideLink& link : system.side.links) {
    const Law& law = system.lattices[std::size_t(link.lattice)].law;
    const Curve& curve = law_curve(law, link.along);
    if (curve.segments == 0) continue;
    const Edge edge = edge_of(s, link.node[0], link.node[1]);
    const L inverse_rest = 1 / link.rest, e = fma(edge.length, inverse_rest, L(-1.0));
    const AnyTension tension{&curve};
    L pull = tension(e);
    if (rates && law.damping > 0) {
      const V du = node_speed(s, link.node[1], lead) - node_speed(s, link.node[0], lead);
      pull = damped_tension(tension, e, dot(du, edge.unit) * inverse_rest, law.damping);
    }
    const V force = edge.unit * (L(link.width) * pull);
    slot_add(f, link.slot[0], force);
    slot_take(f, link.slot[1], force);
  }
}

void hinges_add(const System& system, const State& s, SideForces f) {
  for (const SideHinge& h : system.side.hinges) {
    const double rigidity = law_bending(system.lattices[std::size_t(h.lattice)].law, h.warp);
    if (!(rigidity > 0)) continue;
    const Edge a = edge_of(s, h.node[0], h.node[1]), c = edge_of(s, h.node[1], h.node[2]);
    const auto ends = bending_hinge(a.unit, a.inverse, c.unit, c.inverse, L(rigidity * h.share));
    slot_add(f, h.slot[0], ends.first);
    slot_add(f, h.slot[2], ends.last);
    slot_take(f, h.slot[1], ends.first + ends.last);
  }
}

V clamp_turned(const SideClamp& c, const State& s) {
  const Vec3 d = clamp_direction(c, s);
  return {d[0], d[1], d[2]};
}

void clamps_add(const System& system, const State& s, SideForces f) {
  for (const SideClamp& c : system.side.clamps) {
    const double rigidity = law_bending(system.lattices[std::size_t(c.lattice)].law, c.warp);
    if (!(rigidity > 0)) continue;
    const Edge edge = edge_of(s, c.node[0], c.node[1]);
    const V force =
        bending_hinge(clamp_turned(c, s), L(0.0), edge.unit, edge.inverse, L(rigidity * c.share)).last;
    slot_take(f, c.slot[0], force);
    slot_add(f, c.slot[1], force);
  }
}

void air_add(const System& system, const State& s, double lead, SideForces f) {
  for (const SideCell& cell : system.side.cells) {
    V r[4], u[4];
    for (int k = 0; k < 4; ++k) {
      r[k] = node_at(s, cell.node[k]);
      u[k] = node_speed(s, cell.node[k], lead);
    }
    const V quarter = air_quarter(system.air, s.wind, r[3] - r[0], r[2] - r[1],
                                  ((u[0] + u[1]) + (u[2] + u[3])) * L(0.25), L(cell.share));
    for (int slot : cell.slot) slot_add(f, slot, quarter);
  }
}

}  // namespace

Vec3 clamp_direction(const SideClamp& c, const State& s) {
  const Mat3& turn = s.pin_turn[std::size_t(c.pin)];
  Vec3 d;
  for (std::size_t k = 0; k < 3; ++k)
    d[k] = turn[k][0] * c.direction[0] + turn[k][1] * c.direction[1] + turn[k][2] * c.direction[2];
  return d;
}

void side_forces(const System& system, const State& s, bool rates, double lead, SideForces f) {
  for (double* to : {f.x, f.y, f.z})
    for (std::size_t k = 0; k < system.side.node.size(); ++k) to[k] = 0;
  links_add(system, s, rates, lead, f);
  hinges_add(system, s, f);
  clamps_add(system, s, f);
  if (rates && system_has_air(system)) air_add(system, s, lead, f);
}

void side_clamp_torques(const System& system, const State& s, std::vector<Vec3>& torque) {
  for (const SideClamp& c : system.side.clamps) {
    const double rigidity = law_bending(system.lattices[std::size_t(c.lattice)].law, c.warp);
    const V held = clamp_turned(c, s), v = edge_of(s, c.node[0], c.node[1]).unit;
    const V moment = cross(held, v) * (L(rigidity * c.share) * bending_psi(dot(held, v)));
    Vec3& sum = torque[std::size_t(c.pin)];
    sum[0] += moment.x.v;
    sum[1] += moment.y.v;
    sum[2] += moment.z.v;
  }
}

}  // namespace drape
