// A clamp's hinge lies between the direction R D, with the pin's rotation R, and the link v = (x1 - x0)/l:
//
//   x0 o------o x1     y = R D.v;   force on x1: kappa_c psi (R D - y v)/l, on x0 its opposite;
//        v             torque on the pin: kappa_c psi (R D x v), as (x1 - x0) x F = kappa_c psi v x R D
#include "forces/irregular_elements.h"

#include "forces/bending.h"
#include "forces/damping.h"
#include "forces/node_lane.h"
#include "forces/seam_bending.h"
#include "forces/seam_closing.h"
#include "forces/tension.h"
#include "model/elements.h"

namespace drape::forces {
namespace {

void links_add(const System& system, const State& s, bool rates, double extrapolation, NodeForces f) {
  for (const model::IrregularLink& link : system.irregular.links) {
    const fabric::Law& law = system.lattices[std::size_t(link.lattice)].law;
    const math::Curve& curve = model::law_curve(law, link.along);
    if (curve.segments == 0) continue;
    const NodeEdge edge = node_edge(s, link.node[0], link.node[1]);
    const NodeLane inverse_rest = 1 / link.rest, e = fma(edge.length, inverse_rest, NodeLane(-1.0));
    const CurveTension tension{&curve};
    NodeLane pull = tension(e);
    if (rates && law.damping > 0) {
      const NodeVec du =
          node_speed(s, link.node[1], extrapolation) - node_speed(s, link.node[0], extrapolation);
      pull = damped_tension(tension, e, dot(du, edge.unit) * inverse_rest, law.damping);
    }
    const NodeVec force = edge.unit * (NodeLane(link.width) * pull);
    force_add(f, std::size_t(link.slot[0]), force);
    force_subtract(f, std::size_t(link.slot[1]), force);
  }
}

void hinges_add(const System& system, const State& s, NodeForces f) {
  for (const model::IrregularHinge& h : system.irregular.hinges) {
    const double rigidity = model::law_bending(system.lattices[std::size_t(h.lattice)].law, h.warp);
    if (!(rigidity > 0)) continue;
    const NodeEdge a = node_edge(s, h.node[0], h.node[1]), c = node_edge(s, h.node[1], h.node[2]);
    const auto ends = bending_hinge(a.unit, a.inverse, c.unit, c.inverse, NodeLane(rigidity * h.share));
    force_add(f, std::size_t(h.slot[0]), ends.first);
    force_add(f, std::size_t(h.slot[2]), ends.last);
    force_subtract(f, std::size_t(h.slot[1]), ends.first + ends.last);
  }
}

NodeVec clamp_turned(const model::ClampHinge& c, const State& s) {
  const Vec3 d = clamp_direction(c, s);
  return {d[0], d[1], d[2]};
}

void clamps_add(const System& system, const State& s, NodeForces f) {
  for (const model::ClampHinge& c : system.irregular.clamps) {
    const double rigidity = model::law_bending(system.lattices[std::size_t(c.lattice)].law, c.warp);
    if (!(rigidity > 0)) continue;
    const NodeEdge edge = node_edge(s, c.node[0], c.node[1]);
    const NodeVec force = bending_hinge(clamp_turned(c, s), NodeLane(0.0), edge.unit, edge.inverse,
                                        NodeLane(rigidity * c.share))
                              .last;
    force_subtract(f, std::size_t(c.slot[0]), force);
    force_add(f, std::size_t(c.slot[1]), force);
  }
}

void air_add(const System& system, const State& s, double extrapolation, NodeForces f) {
  for (const model::IrregularCell& cell : system.irregular.cells) {
    const NodeVec quarter = node_air_quarter(system, s, cell.node, cell.share, extrapolation);
    for (int slot : cell.slot) force_add(f, std::size_t(slot), quarter);
  }
}

}  // namespace

Vec3 clamp_direction(const model::ClampHinge& c, const State& s) {
  const model::Mat3& turn = s.pin_rotation[std::size_t(c.pin)];
  Vec3 d;
  for (std::size_t k = 0; k < 3; ++k)
    d[k] = turn[k][0] * c.direction[0] + turn[k][1] * c.direction[1] + turn[k][2] * c.direction[2];
  return d;
}

void irregular_forces(const System& system, const State& s, bool rates, double extrapolation,
                      HingeKernel hinges, model::SlotForces force) {
  const NodeForces f{force.x, force.y, force.z};
  for (double* to : {f.x, f.y, f.z})
    for (std::size_t k = 0; k < system.irregular.node.size(); ++k) to[k] = 0;
  links_add(system, s, rates, extrapolation, f);
  hinges_add(system, s, f);
  clamps_add(system, s, f);
  if (rates && model::system_has_air(system)) air_add(system, s, extrapolation, f);
  seams_closing_forces(system, s, extrapolation, force);
  seams_bending_forces(system, s, hinges, force);
}

void clamp_torques(const System& system, const State& s, std::vector<Vec3>& torque) {
  torque.assign(s.pin_impulse.size(), Vec3{0, 0, 0});
  for (const model::ClampHinge& c : system.irregular.clamps) {
    const double rigidity = model::law_bending(system.lattices[std::size_t(c.lattice)].law, c.warp);
    const NodeVec held = clamp_turned(c, s), v = node_edge(s, c.node[0], c.node[1]).unit;
    const NodeVec moment = cross(held, v) * (NodeLane(rigidity * c.share) * bending_psi(dot(held, v)));
    Vec3& sum = torque[std::size_t(c.pin)];
    sum[0] += moment.x.v;
    sum[1] += moment.y.v;
    sum[2] += moment.z.v;
  }
}

}  // namespace drape::forces
