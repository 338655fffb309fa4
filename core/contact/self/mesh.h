// The surface of all cloth, for self-contact. core/README.md, section 8.
#pragma once
#include "model/system.h"

namespace drape::contact {

// Makes the cells, the edges, and the exclusions of what is too near along the cloth to touch. Needs the
// seams and pins of the system. Layers that start nearer to each other than their thickness get that distance
// as their contact distance.
model::SelfMesh self_mesh_make(const System& system, const State& start);

// True for two cells so near along the cloth across a seam that they are excluded from contact.
bool self_cells_sewn(const model::SelfMesh& mesh, const model::SelfCell& a, const model::SelfCell& b);

// The distance (m) of the middle surfaces at which two layers of cloth touch.
inline double self_contact_distance(const System& system, int lattice_a, int lattice_b) {
  return system.lattices[std::size_t(lattice_a)].contact_law.distance +
         system.lattices[std::size_t(lattice_b)].contact_law.distance;
}

}  // namespace drape::contact
