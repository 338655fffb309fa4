// The forces that depend on velocity, one by one and without any others: for the energy balance.
// core/README.md, sections 3 and 4.
#pragma once
#include "model/system.h"

namespace drape::forces {

// Sets fx, fy, fz [nodes], N, to the forces of damping along links and of air at v + extrapolation (v - w).
// Returns the total force of the air, N.
Vec3 rate_forces(const System& system, const State& state, double extrapolation, double* fx, double* fy,
                 double* fz);

}  // namespace drape::forces
