// Forces of the links, hinges and cells that lie beside the rows, one by one. core/README.md, sections 1, 3
// and 4.
#pragma once
#include "forces/hinge_batch.h"
#include "model/system.h"

namespace drape::forces {

// Sets all slots. `rates`: with the forces that depend on velocity, at v + lead (v - w).
void irregular_forces(const System& system, const State& state, bool rates, double extrapolation,
                      HingeKernel hinges, model::SlotForces force);

// The torque of every clamp on the outside world beyond that of its points' forces, kappa_c psi (R D x v),
// added to torque [pins].
void clamp_torques(const System& system, const State& state, std::vector<Vec3>& torque);

// The direction R D of a clamped link now.
Vec3 clamp_direction(const model::ClampHinge& clamp, const State& state);

}  // namespace drape::forces
