// Broad phase of self-contact: a hash grid of buckets over the cells. core/README.md, section 8.
#pragma once
#include "model/system.h"

namespace drape::contact {

// All pairs of a particle and a triangle, and of two edges, that do not adjoin and are nearer than their
// contact distance and `margin` (m). They are sorted, so that they depend on the positions of the particles
// only.
model::SelfPairs self_search(const System& system, const model::SelfMesh& mesh, const State& state,
                             double margin);

// An edge of cloth that goes through cloth.
struct SelfCut {
  int lattice[2];  // of the edge; of the cell that it goes through
  Vec3 at;         // m, the middle of the edge
};
std::vector<SelfCut> self_cuts(const model::SelfMesh& mesh, const State& state);

}  // namespace drape::contact
