// The forces that depend on velocity, alone and one by one: for the energy balance. core/README.md, sections
// 3 and 4.
#pragma once
#include "model/system.h"

namespace drape::forces {

// Damping along springs and air at v + lead (v - w) into fx, fy, fz [nodes], N; returns the air's total.
Vec3 rate_forces(const System& system, const State& state, double extrapolation, double* fx, double* fy,
                 double* fz);

}  // namespace drape::forces
