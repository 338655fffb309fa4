// Which links and cells of the cloth may touch the sharp features of bodies. core/README.md, section 7.
#pragma once
#include "model/system.h"

namespace drape::contact {

// Finds the sharp features of all bodies; where there are any, makes the elements of the cloth.
void edge_elements_make(System& system);

double edge_sine(const model::Lattice& lattice);    // sine between cloth and face from which a feature counts
double edge_margin(const model::Lattice& lattice);  // m, of motion that a list of pairs is good for
double edge_near(const model::Lattice& lattice);  // m, from a feature: nodes whose elements may come near it

}  // namespace drape::contact
