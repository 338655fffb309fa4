// Weighted sums over nodes: their values, and the forces on them.
#pragma once
#include "math/vector3.h"
#include "model/system.h"

namespace drape::model {

// sum_k weight[k] f(node[k])
inline Vec3 sum_value(const NodeSum& nodes, const double* x, const double* y, const double* z) {
  Vec3 sum{0, 0, 0};
  for (const auto& [node, slot, weight] : nodes) {
    sum[0] += weight * x[node];
    sum[1] += weight * y[node];
    sum[2] += weight * z[node];
  }
  return sum;
}
inline Vec3 sum_value(const NodeSum& nodes, const Array& x, const Array& y, const Array& z) {
  return sum_value(nodes, x.data(), y.data(), z.data());
}
inline Vec3 sum_value(const NodeSum& nodes, const State& s) { return sum_value(nodes, s.x, s.y, s.z); }

// The present position of a point, m.
inline Vec3 point_now(const SeamPoint& point, const State& s) {
  using namespace math::vector3;
  Vec3 sum{0, 0, 0};
  for (int k = 0; k < 4; ++k)
    sum += point.weight[k] * Vec3{s.x[point.node[k]], s.y[point.node[k]], s.z[point.node[k]]};
  return sum;
}

// A force on the sum acts on each of its nodes, times the node's weight.
inline void sum_force(const NodeSum& nodes, const Vec3& force, SlotForces to) {
  for (const auto& [node, slot, weight] : nodes) {
    to.x[slot] += weight * force[0];
    to.y[slot] += weight * force[1];
    to.z[slot] += weight * force[2];
  }
}

// Adds factor times a point to the sum.
inline void sum_add(NodeSum& nodes, const SeamPoint& point, double factor) {
  for (int k = 0; k < 4; ++k) {
    if (point.weight[k] == 0) continue;
    NodeTerm* at = nodes.begin();
    while (at != nodes.end() && at->node != point.node[k]) ++at;
    if (at == nodes.end()) {
      *at = {std::uint32_t(point.node[k]), 0, 0};
      ++nodes.count;
    }
    at->weight += factor * point.weight[k];
  }
}

}  // namespace drape::model
