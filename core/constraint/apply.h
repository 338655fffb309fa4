// Constraints at work: after each step, and on accelerations and velocities for output.
#pragma once
#include "system/system.h"

namespace drape {

// Puts constrained nodes back after the free step r <- r + h v, v <- keep v + kick a, and adds force x weight
// (s) to the impulses of the pins.
void constraints_apply(const Constraints& constraints, const Array& mass, double h, double kick,
                       double weight, double* scratch, State& state);

// Three components of a nodal field, [nodes] each.
struct Field {
  double *x, *y, *z;
};

// Projects a field of accelerations or velocities onto those that the constraints allow; `force` [pins],
// where it is not null, receives m times what was taken out: for accelerations, the pins' forces on the
// outside world.
void constraints_project(const Constraints& constraints, const Array& mass, double* scratch, Field field,
                         std::vector<Vec3>* force);

}  // namespace drape
