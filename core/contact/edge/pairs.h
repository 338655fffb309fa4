// A part of the cloth and a ridge of a body at the places of a state.
#pragma once
#include "contact/edge/edge_contact.h"
#include "math/vector3.h"
#include "model/body_pose.h"

namespace drape::contact {

// The nodes of a part in the frame of body b.
inline void ridge_places(const System& system, const State& s, std::size_t b, const model::RidgePart& part,
                         Vec3* x) {
  for (int k = 0; k < part.nodes; ++k) {
    const std::size_t n = part.node[k];
    x[k] = model::pose_inward(system.bodies[b], s.body[b], {s.x[n], s.y[n], s.z[n]});
  }
}

inline RidgeGap ridge_gap(const model::RidgePart& part, const body::Ridge& ridge, const Vec3* x,
                          double sine) {
  if (part.cell) return gap_cell_tip(ridge, x, sine);
  if (!ridge.tip) return gap_link_edge(ridge, x, sine);
  const Vec3 beyond[2][2] = {{x[2], x[3]}, {x[4], x[5]}};
  return gap_link_tip(ridge, x, beyond, part.nodes == 6 ? 2 : 1, sine);
}

}  // namespace drape::contact
