// The positions of the particles of a seam on the outlines of its two sides [P section 5; core/README.md,
// section 5].
#pragma once
#include "scene/scene.h"

namespace drape::seam {

// The edges of a side in the order of the outline; empty where they are not consecutive or not valid.
std::vector<int> seam_chain(const scene::PieceSpec& piece, const scene::SeamSide& side);

// The outline of a side from its start to its end, in the plane of the piece, m.
std::vector<Vec2> seam_line(const scene::PieceSpec& piece, const scene::SeamSide& side);
double seam_length(const std::vector<Vec2>& line);  // m

struct SeamLayout {
  bool closed = false;           // both sides are closed loops
  double length[2], spacing[2];  // m, l and R of each side
  std::vector<Vec2> point[2];    // [pairs] m, in the planes of the pieces; both ends included
  std::vector<Vec2> inward[2];   // [pairs] unit vector across the outline there, towards the cloth
};
SeamLayout seam_layout(const Scene& scene, const scene::SeamSpec& seam);

}  // namespace drape::seam
