// Which links and cells of the cloth meet the ridges of bodies. core/README.md, section 7.
#pragma once
#include "model/system.h"

namespace drape::contact {

// Finds the ridges of all bodies, and lays the parts where there are any.
void edge_elements_make(System& system);

double edge_sine(const model::Lattice& lattice);    // from which a ridge counts for a lattice
double edge_margin(const model::Lattice& lattice);  // m, that a listing is good for
double edge_near(const model::Lattice& lattice);    // m, from a ridge: nodes whose parts may come near it

}  // namespace drape::contact
