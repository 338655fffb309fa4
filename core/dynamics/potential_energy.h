// Energies by kind, J, and the start of the energy balance.
#pragma once
#include "drape/drape.h"
#include "model/system.h"

namespace drape::dynamics {

struct Kernel;

// The potential energies at the present positions, J. The kinetic energy and the balance are left at 0.
drape_energy potential_energy(const System& system, const Kernel& kernel, const State& state);
drape_energy potential_energy(const System& system, const State& state);  // by the kernel of this processor

// That of gravity alone, J.
double gravity_energy(const System& system, const State& state);

// The sum of the kinetic and all potential energies, J.
double energy_sum(const drape_energy& energy);

// Starts the energy balance at a start state, whose velocities are v_0.
void energy_begin(const System& system, State& start);

}  // namespace drape::dynamics
