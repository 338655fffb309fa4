// Looks at the surroundings of particles anew, and keeps what is near of them in blocks.
#pragma once
#include <array>

#include "body/closest_features.h"
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

// A body as neighbours are searched on it.
struct NeighbourBody {
  const body::BodySurface& surface;
  body::DistanceGrid& distance_grid;
  SharpRange sharp;
};

// kRowUnit nodes of a lattice from `node` on.
struct NeighbourNodes {
  std::size_t node;
  int lattice;
  double contact_distance;                       // m
  std::array<Vec3, math::kRowUnit> place, step;  // m, in the body's frame: at t_n; of the next step
};

// Of the nodes, those that have used up most of their budgets, or will by the next step.
void update_neighbours(const NeighbourBody& body, const NeighbourNodes& nodes, body::ClosestFeatures& found,
                       model::BodyContact& contact);

}  // namespace drape::contact
