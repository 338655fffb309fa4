// Panels as a pattern places them stand far off the body and often too low: pulled together from there, a
// shoulder seam would meet under the arm. Before they are sewn the panels are brought near and above.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace drape::command {

// Moves each panel that lies wholly beyond the body, or is a little cut by it, along its normal to `kNear`
// off it, panels that lay one over the other as far from each other, all panels up until no level seam has a
// top of the body (a shoulder) in its way, and lets seams that join panels one above the other wait until the
// others are closed. `body` [m]: the vertices of the body; up is y.
void garment_place_near(Scene& scene, const std::vector<Vec3>& body);

}  // namespace drape::command
