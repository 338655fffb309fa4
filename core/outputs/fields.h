// What every particle feels: fields over the cloth, for pictures and reports.
#pragma once
#include "contact/particle/contact.h"

namespace drape::outputs {

// Strain and tension of a particle are the means over the links that end at it, by their widths.
struct Fields {
  std::vector<double> strain;    // [particles x 3] of warp, weft, bias
  std::vector<double> tension;   // [particles x 2] N/m, of warp, weft
  std::vector<double> pressure;  // [particles] Pa, of contact with bodies
  std::vector<double> area;      // [particles] m^2
};
void fields_fill(Fields& fields, const System& system, const State& state,
                 const contact::ContactStops& stops);

// The links of one direction of a piece.
struct Elongation {
  double min, max, mean;  // strain; mean by area
  double tension_max;     // N/m; 0 of the diagonals, which have none of their own
  double beyond;          // share of the area that is strained beyond the limit
};
Elongation elongation_of(const System& system, const State& state, const model::Lattice& lattice,
                         model::YarnDirection along, double limit);

}  // namespace drape::outputs
