// The gap between an element of the cloth and a sharp feature of a body, at the positions of a state.
#pragma once
#include "contact/edge/edge_contact.h"
#include "math/vector3.h"
#include "model/body_pose.h"

namespace drape::contact {

// Positions x [element.nodes] of the nodes of an element, m, in the frame of body b.
inline void edge_element_places(const System& system, const State& s, std::size_t b,
                                const model::EdgeElement& element, Vec3* x) {
  for (int k = 0; k < element.nodes; ++k) {
    const std::size_t n = element.node[k];
    x[k] = model::pose_inward(system.bodies[b], s.body[b], {s.x[n], s.y[n], s.z[n]});
  }
}

inline EdgeGap edge_gap(const model::EdgeElement& element, const body::SharpFeature& feature, const Vec3* x,
                        double sine) {
  if (element.cell) return feature.tip ? gap_cell_tip(feature, x, sine) : gap_cell_edge(feature, x, sine);
  if (!feature.tip) return gap_link_edge(feature, x, sine);
  const Vec3 beyond[2][2] = {{x[2], x[3]}, {x[4], x[5]}};
  return gap_link_tip(feature, x, beyond, element.nodes == 6 ? 2 : 1, sine);
}

}  // namespace drape::contact
