#include "forces/rates.h"

#include "forces/air.h"
#include "forces/node_lane.h"
#include "forces/tension.h"
#include "model/elements.h"

namespace drape::forces {
namespace {

void damping_add(const model::Lattice& l, const model::Link& link, const State& s, double extrapolation,
                 NodeForces f) {
  const math::Curve& curve = model::law_curve(l.law, link.along);
  if (curve.segments == 0 || !(l.law.damping > 0)) return;
  const NodeEdge edge = node_edge(s, link.from, link.to);
  const NodeLane inverse_rest = 1 / link.rest, e = fma(edge.length, inverse_rest, NodeLane(-1.0));
  const NodeLane rate =
      dot(node_speed(s, link.to, extrapolation) - node_speed(s, link.from, extrapolation), edge.unit) *
      inverse_rest;
  const NodeLane slope = CurveTension{&curve}.slope(e);
  const NodeVec force = edge.unit * (NodeLane(link.width * l.law.damping) * (slope * rate));
  force_add(f, link.from, force);
  force_subtract(f, link.to, force);
}

}  // namespace

Vec3 rate_forces(const System& system, const State& s, double extrapolation, double* fx, double* fy,
                 double* fz) {
  const NodeForces f{fx, fy, fz};
  for (double* to : {fx, fy, fz})
    for (std::size_t n = 0; n < system.nodes; ++n) to[n] = 0;
  NodeVec air{0.0, 0.0, 0.0};
  for (const model::Lattice& l : system.lattices) {
    model::links_visit(system, l,
                       [&](const model::Link& link) { damping_add(l, link, s, extrapolation, f); });
    if (!model::system_has_air(system)) continue;
    model::cells_visit(system, l, [&](const std::size_t* corner, double share) {
      const NodeVec quarter = node_air_quarter(system, s, corner, share, extrapolation);
      for (int k = 0; k < 4; ++k) force_add(f, corner[k], quarter);
      air = air + quarter * NodeLane(4.0);
    });
  }
  return {air.x.v, air.y.v, air.z.v};
}

}  // namespace drape::forces
