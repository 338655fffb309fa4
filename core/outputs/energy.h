// Energies by kind, J.
#pragma once
#include "drape.h"
#include "system/system.h"

namespace drape {

// theta^2/2 of a hinge from y = cos theta; beyond 120 degrees the continuation of core/README.md, section 3.
double hinge_energy(double y);

// Potential energies of the present positions; kinetic is left 0.
drape_energy energy_potential(const System& system, const State& state);

// sum m v^2/2
double energy_kinetic(const System& system, const Array& vx, const Array& vy, const Array& vz);

}  // namespace drape
