// The surface of all cloth, for self-contact. core/README.md, section 8.
#pragma once
#include <algorithm>

#include "model/system.h"

namespace drape::contact {

// Makes the cells, the edges, and the exclusions of what is too near along the cloth to touch. Needs the
// seams and pins of the system. Layers that start nearer to each other than their thickness get that distance
// as their contact distance.
model::SelfMesh self_mesh_make(const System& system, const State& start);

// True for two cells so near along the cloth across a seam that they are excluded from contact.
bool self_cells_sewn(const model::SelfMesh& mesh, const model::SelfCell& a, const model::SelfCell& b);

// False for two elements of one lattice so near along the cloth that they are excluded from contact.
inline bool self_apart(const model::SelfMesh& mesh, int lattice, const model::SelfBox& a,
                       const model::SelfBox& b) {
  const int columns = std::max(b.low[0] - a.high[0], a.low[0] - b.high[0]);
  const int rows = std::max(b.low[1] - a.high[1], a.low[1] - b.high[1]);
  return std::max(columns, rows) >= mesh.exclusion_cells[std::size_t(lattice)];
}

// The distance (m) of the middle surfaces at which two layers of cloth touch.
inline double self_contact_distance(const System& system, int lattice_a, int lattice_b) {
  return system.lattices[std::size_t(lattice_a)].contact_law.distance +
         system.lattices[std::size_t(lattice_b)].contact_law.distance;
}

}  // namespace drape::contact
