// The laws on single nodes, as lanes of one double: for irregular elements and the energy balance.
#pragma once
#include "forces/air.h"
#include "model/system.h"
#include "simd/lane_scalar.h"

namespace drape::forces {
namespace {

using NodeLane = simd::ScalarLane<false>;
using NodeVec = simd::Vec<NodeLane>;

// Force accumulators by node or by slot.
struct NodeForces {
  double *x, *y, *z;
};

inline void force_add(NodeForces f, std::size_t k, NodeVec force) {
  f.x[k] += force.x.v;
  f.y[k] += force.y.v;
  f.z[k] += force.z.v;
}
inline void force_subtract(NodeForces f, std::size_t k, NodeVec force) {
  f.x[k] -= force.x.v;
  f.y[k] -= force.y.v;
  f.z[k] -= force.z.v;
}

inline NodeVec node_at(const State& s, std::size_t n) { return {s.x[n], s.y[n], s.z[n]}; }

// v + extrapolation (v - w), m/s
inline NodeVec node_speed(const State& s, std::size_t n, double extrapolation) {
  const NodeVec v{s.vx[n], s.vy[n], s.vz[n]}, w{s.wx[n], s.wy[n], s.wz[n]};
  return v + (v - w) * NodeLane(extrapolation);
}

struct NodeEdge {
  NodeVec unit;
  NodeLane inverse, length;
};
inline NodeEdge node_edge(const State& s, std::size_t from, std::size_t to) {
  const NodeVec d = node_at(s, to) - node_at(s, from);
  const NodeLane length = sqrt(dot(d, d)), inverse = NodeLane(1.0) / length;
  return {d * inverse, inverse, length};
}

inline NodeVec node_air_quarter(const System& system, const State& s, const std::size_t* corner, double share,
                                double extrapolation) {
  NodeVec r[4], u[4];
  for (int k = 0; k < 4; ++k) {
    r[k] = node_at(s, corner[k]);
    u[k] = node_speed(s, corner[k], extrapolation);
  }
  const NodeVec speed = ((u[0] + u[1]) + (u[2] + u[3])) * NodeLane(0.25);
  return air_quarter(system.air, s.wind, r[3] - r[0], r[2] - r[1], speed, NodeLane(share));
}

}  // namespace
}  // namespace drape::forces
