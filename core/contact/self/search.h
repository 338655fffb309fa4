// Which parts of the cloth are near each other: a grid of buckets over the cells. core/README.md, section 8.
#pragma once
#include "model/system.h"

namespace drape::contact {

// All particles and triangles, and all pairs of edges, that do not adjoin and are nearer than their layer and
// `margin` (m); sorted, so that they depend on nothing but the places of the particles.
model::SelfPairs self_search(const System& system, const model::SelfMesh& mesh, const State& state,
                             double margin);

// Edges of cloth that go through cloth.
struct SelfCut {
  int lattice[2];
  Vec3 at;  // m
};
std::vector<SelfCut> self_cuts(const model::SelfMesh& mesh, const State& state);

}  // namespace drape::contact
