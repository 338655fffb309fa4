// A vector field over the nodes.
#pragma once

namespace drape::model {

// Its three components, [nodes] each: positions, velocities, accelerations or forces.
struct Field {
  double *x, *y, *z;
};

}  // namespace drape::model
