// Cloth that bends under its own weight: the heavy elastica and the two bending tests based on it.
//
// A strip of length l is clamped horizontally at s = 0. Its weight per length is q and its rigidity EI. At
// s = arc/l it points down by the angle th:
//
//   th'' = -beta (1 - s) cos th,     th(0) = 0,     th'(1) = 0,     beta = q l^3/EI.
//
// Counted from the free end, with phi = pi/2 - th and z = beta^(1/3) (1 - s), this becomes one initial value
// problem for all beta:
//
//   phi'' = z sin phi,   phi'(0) = 0,   up to phi(Z) = pi/2:
//
//   beta = Z^3,   f/l = integral of cos phi dz/Z,   x/l = integral of sin phi dz/Z,
//
// where f is the drop of the free end and x its horizontal distance from the clamp. Each angle phi(0) of the
// free end gives one beta.
//
// GOST 10550, PT-2. Strips of 160 mm x 30 mm lie on a support in the middle and overhang by l = 70 mm on
// either side. m is the mass of five strips, f the drop of the ends:
//
//   EI = q l^3/A(f/l),     q = m g/(5 x 0.16 m):     EI [uN cm^2] = 42046 m [g]/A,
//
// where A is the beta of the elastica with that f/l.
//
// ASTM D1388 option A, ISO 9073-7 (F. T. Peirce, J. Text. Inst. 21, T377, 1930). A strip is pushed over an
// edge until the line from the edge to its end falls by 41.5 degrees. The bending length c is half that
// overhang O. The rigidity per width is B = W c^3 g, since beta = W g O^3/B = 8.004 there, nearly 8.
#pragma once
#include <array>
#include <vector>

namespace drape::standards {

struct Cantilever {
  double beta, drop, reach;  // q l^3/EI, f/l, x/l
};

// The cantilever with one given quantity:
Cantilever cantilever_of(double end);          // phi(0), rad, above 0, below pi/2
Cantilever cantilever_with(double drop);       // f/l, above 0, below 1
Cantilever cantilever_of_load(double beta);    // beta, above 0, below 1e5
Cantilever cantilever_of_slope(double angle);  // angle of the line from the edge to the end, rad

// The shape of the strip: (x/l, f/l) at n + 1 points at equal distances along it, from the clamp on.
std::vector<std::array<double, 2>> cantilever_shape(double beta, int n);

inline constexpr double kGostOverhang = 0.07, kGostLength = 0.16, kGostWidth = 0.03;  // m

double gost_10550_rigidity(double mass, double drop);          // kg of five strips, m -> EI, N m^2
double bending_length_rigidity(double weight, double length);  // kg/m^2, m -> B, N m

}  // namespace drape::standards
