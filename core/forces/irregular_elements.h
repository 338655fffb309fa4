// Forces of irregular elements, one by one. core/README.md, sections 1, 3 and 4.
#pragma once
#include "forces/hinge_batch.h"
#include "model/system.h"

namespace drape::forces {

// Sets all slots [slots] N: irregular elements and seams. `rates`: includes the forces that depend on
// velocity, evaluated at v + extrapolation (v - w).
void irregular_forces(const System& system, const State& state, bool rates, double extrapolation,
                      HingeKernel hinges, model::SlotForces force);

// Sets torque [pins], N m: the torque of every clamp's hinges on the outside world: kappa_c psi (R D x v).
// The torque of the forces on the clamp's points is not part of it.
void clamp_torques(const System& system, const State& state, std::vector<Vec3>& torque);

// The present direction R D that a clamp prescribes for its link.
Vec3 clamp_direction(const model::ClampHinge& clamp, const State& state);

}  // namespace drape::forces
