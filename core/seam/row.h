// Sums over nodes, and what acts on them.
#pragma once
#include "constraint/vector3.h"
#include "forces/side.h"
#include "system/system.h"

namespace drape {

// sum_k weight[k] f(node[k])
inline Vec3 row_value(const SeamRow& row, const Array& x, const Array& y, const Array& z) {
  using namespace vector3;
  Vec3 sum{0, 0, 0};
  for (int k = 0; k < row.count; ++k)
    sum += row.weight[k] * Vec3{x[row.node[k]], y[row.node[k]], z[row.node[k]]};
  return sum;
}
inline Vec3 row_value(const SeamRow& row, const State& s) { return row_value(row, s.x, s.y, s.z); }

inline Vec3 point_now(const SeamPoint& point, const State& s) {
  using namespace vector3;
  Vec3 sum{0, 0, 0};
  for (int k = 0; k < 4; ++k)
    sum += point.weight[k] * Vec3{s.x[point.node[k]], s.y[point.node[k]], s.z[point.node[k]]};
  return sum;
}

// A force on the sum is its nodes' by their weights.
inline void row_force(const SeamRow& row, const Vec3& force, SideForces to) {
  for (int k = 0; k < row.count; ++k) {
    const auto slot = std::size_t(row.slot[k]);
    to.x[slot] += row.weight[k] * force[0];
    to.y[slot] += row.weight[k] * force[1];
    to.z[slot] += row.weight[k] * force[2];
  }
}

inline Vec3 arm_value(const SeamArm& arm, const State& s) {
  Vec3 sum{0, 0, 0};
  for (int k = 0; k < arm.count; ++k) {
    const auto [node, slot, weight] = arm.term[k];
    sum[0] += weight * s.x[node];
    sum[1] += weight * s.y[node];
    sum[2] += weight * s.z[node];
  }
  return sum;
}

inline void arm_force(const SeamArm& arm, const Vec3& force, SideForces to) {
  for (int k = 0; k < arm.count; ++k) {
    const auto [node, slot, weight] = arm.term[k];
    to.x[slot] += weight * force[0];
    to.y[slot] += weight * force[1];
    to.z[slot] += weight * force[2];
  }
}

// A point more.
inline void row_add(SeamRow& row, const SeamPoint& point, double factor) {
  for (int k = 0; k < 4; ++k) {
    if (point.weight[k] == 0) continue;
    int at = 0;
    while (at < row.count && row.node[at] != point.node[k]) ++at;
    if (at == row.count) {
      row.node[at] = point.node[k];
      row.weight[at] = 0;
      ++row.count;
    }
    row.weight[at] += factor * point.weight[k];
  }
}

}  // namespace drape
