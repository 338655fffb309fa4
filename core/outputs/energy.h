// Energies by kind, J.
#pragma once
#include "drape/drape.h"
#include "model/system.h"

namespace drape::outputs {

// Potential energies of the present positions; kinetic is left 0.
drape_energy energy_potential(const System& system, const State& state);

// sum m v^2/2
double energy_kinetic(const System& system, const Array& vx, const Array& vy, const Array& vz);

// Of all kinds.
double energy_sum(const drape_energy& energy);

// The balance begins at a start state, whose velocities are v_0.
void energy_begin(const System& system, State& start);

}  // namespace drape::outputs
