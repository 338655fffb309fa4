// The energy of a hinge divided by its stiffness kappa: core/README.md, section 3.
#pragma once
#include "scene/scene.h"

namespace drape::forces {

// theta^2/2 from y = cos theta; beyond 120 degrees the continuation that belongs to psi.
double hinge_energy(double y);

// The same between two edges a and c. Computed from sine and cosine, so exact for flat cloth too.
double hinge_energy_between(const Vec3& a, const Vec3& c);

}  // namespace drape::forces
