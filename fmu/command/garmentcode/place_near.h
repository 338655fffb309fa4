// A pattern places its panels far off the body and often too low: closed from there, a shoulder seam would
// meet under the arm. This moves the panels near the body and above its shoulders before they are sewn.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace drape::command {

// Moves each panel that lies wholly beyond the body, or is cut by it a little, along its normal, to `kNear`
// off the body. Panels that lay one over the other are placed as far from each other. Then all panels rise
// until no top of the body (a shoulder) obstructs a level seam. Seams that join panels one above the other
// wait until the others are closed. `body` [vertices, m]: the vertices of the body; up is y.
void garment_place_near(Scene& scene, const std::vector<Vec3>& body);

}  // namespace drape::command
