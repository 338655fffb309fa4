// The energy of a hinge over its kappa: core/README.md, section 3.
#pragma once
#include "scene/scene.h"

namespace drape::forces {

// theta^2/2 from y = cos theta; beyond 120 degrees its continuation.
double hinge_energy(double y);

// The same between two edges; from sine and cosine, exact for flat cloth too.
double hinge_energy_between(const Vec3& a, const Vec3& c);

}  // namespace drape::forces
