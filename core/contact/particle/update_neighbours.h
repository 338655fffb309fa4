// Looks at the surroundings of particles anew, and keeps what is near of them in blocks.
#pragma once
#include "body/distance_grid.h"
#include "model/contact.h"

namespace drape::contact {

// Surfaces within so many layers of a particle are kept in its block; up to kSeen layers away, triangles are
// listed.
inline constexpr double kKeptDistances = 3, kListedDistances = 4;

// How far around triangles are listed (m), for the thickest layer.
double search_reach(const body::BodySurface& surface, double contact_distance);

// How near nodes must be to a ridge to be noted, and for how far that is good at least.
struct SharpRange {
  const body::SharpFeatures& sharp;
  double within, margin;  // m
};

// Of kRowUnit nodes from `node` on, those at x (in the body's frame) that have used up most of their budgets,
// or will by the next step, which moves them by `step` (m).
void update_neighbours(const body::BodySurface& surface, body::DistanceGrid& voxels,
                       model::BodyContact& contact, std::size_t node, int lattice, double contact_distance,
                       const SharpRange& features, const Vec3* x, const Vec3* step);

}  // namespace drape::contact
