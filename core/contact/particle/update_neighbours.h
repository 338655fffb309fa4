// Finds the surfaces near particles and stores them in blocks of kRowUnit nodes.
#pragma once
#include <array>

#include "body/closest_features.h"
#include "body/distance_grid.h"
#include "model/contact.h"

namespace drape::contact {

// In contact distances: surfaces within kKeptDistances of a particle are stored in its block; triangles
// within kListedDistances are listed by the distance grid.
inline constexpr double kKeptDistances = 3, kListedDistances = 4;

// How far (m) from a surface the distance grid lists triangles. `contact_distance`: the largest, m.
double search_reach(const body::BodySurface& surface, double contact_distance);

// How near to a sharp feature of the body nodes are marked, and the travel that a mark is good for at least.
struct SharpRange {
  const body::SharpFeatures& sharp;
  double within, margin;  // m
};

// The body that neighbours are searched on.
struct NeighbourBody {
  const body::BodySurface& surface;
  body::DistanceGrid& distance_grid;
  SharpRange sharp;
};

// Vectors that the search for one particle works in: they keep what they have grown to.
struct NeighbourScratch {
  body::ClosestFeatures found;
  body::ClosestFeaturesScratch features;
  std::vector<std::uint32_t> sharp;
};

// kRowUnit nodes of a lattice from `node` on.
struct NeighbourNodes {
  std::size_t node;
  int lattice;
  double contact_distance;                       // m
  std::array<Vec3, math::kRowUnit> place, step;  // m, in the body's frame: at t_n; of the next step
};

// Updates the neighbours of those nodes that have used up most of their free distance, or will in the next
// step; writes their blocks, free distances and marks into `contact`.
void update_neighbours(const NeighbourBody& body, const NeighbourNodes& nodes, NeighbourScratch& scratch,
                       model::BodyContact& contact);

}  // namespace drape::contact
