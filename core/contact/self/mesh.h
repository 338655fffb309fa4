// The surface of all cloth for contact with itself. core/README.md, section 8.
#pragma once
#include "model/system.h"

namespace drape::contact {

// After the seams are tied and the pins laid: cells, edges, and what lies too near along the cloth to touch.
// Layers that start nearer to each other than their thickness keep that distance as theirs.
model::SelfMesh self_mesh_make(const System& system, const State& start);

// True where two cells are so near along the cloth, across seams too, that they do not touch.
bool self_cells_adjoin(const model::SelfMesh& mesh, const model::SelfCell& a, const model::SelfCell& b);

// m, at which the middles of two layers touch.
inline double self_contact_distance(const System& system, int lattice_a, int lattice_b) {
  return system.lattices[std::size_t(lattice_a)].contact_law.distance +
         system.lattices[std::size_t(lattice_b)].contact_law.distance;
}

}  // namespace drape::contact
