// Fields over the cloth, particle by particle, for pictures and reports.
#pragma once
#include "contact/particle/contact.h"

namespace drape::outputs {

// Strain and tension of a particle are means over the links that end at it, weighted by link width.
struct Fields {
  std::vector<double> strain;    // [particles x 3] 1; warp, weft, bias
  std::vector<double> tension;   // [particles x 2] N/m; warp, weft
  std::vector<double> pressure;  // [particles] Pa, of contact with bodies
  std::vector<double> area;      // [particles] m^2
};
void fields_fill(Fields& fields, const System& system, const State& state,
                 const contact::ContactStops& stops);

// A summary of the links of one direction of a piece.
struct Elongation {
  double min, max, mean;  // 1, strain; the mean is weighted by area
  double tension_max;     // N/m; 0 for the bias direction, which has no tension of its own
  double beyond;          // 1, share of the area whose strain exceeds the limit
};
Elongation elongation_of(const System& system, const State& state, const model::Lattice& lattice,
                         model::YarnDirection along, double limit);

}  // namespace drape::outputs
