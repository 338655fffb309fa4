// Cloth that bends under its own weight: the heavy elastica and the two tests that rest on it.
//
// A strip of length l, clamped level at s = 0, with the weight q per length and the rigidity EI, turned down
// by th at s = arc/l:
//
//   th'' = -beta (1 - s) cos th,     th(0) = 0,     th'(1) = 0,     beta = q l^3/EI.
//
// From the free end, with phi = pi/2 - th and z = beta^(1/3) (1 - s), this is one initial value problem for
// every beta:
//
//   phi'' = z sin phi,     phi'(0) = 0,     up to phi(Z) = pi/2:     beta = Z^3,   f/l = integral of cos phi
//   dz/Z, x/l = integral of sin phi dz/Z,
//
// f the drop of the free end, x its distance from the clamp. The angle phi(0) of the free end stands for
// beta.
//
// GOST 10550, PT-2. Strips of 160 mm x 30 mm lie on a middle support, l = 70 mm of them overhang on either
// side. m is the mass of five strips, f the drop of the ends:
//
//   EI = q l^3/A(f/l),     q = m g/(5 x 0.16 m):     EI [uN cm^2] = 42046 m [g]/A,
//
// and A is beta of the elastica.
//
// ASTM D1388 option A, ISO 9073-7 (F. T. Peirce, J. Text. Inst. 21, T377, 1930). A strip is pushed out until
// the line from the edge to its end falls by 41.5 degrees; c is half that overhang O, and B = W c^3 g per
// width, since there beta = W g O^3/B = 8.004, nearly 8.
#pragma once
#include <array>
#include <vector>

namespace drape::standards {

struct Cantilever {
  double beta, drop, reach;  // q l^3/EI, f/l, x/l
};

Cantilever cantilever_of(double end);          // end = phi(0), above 0, below pi/2
Cantilever cantilever_with(double drop);       // f/l, above 0, below 1
Cantilever cantilever_of_load(double beta);    // above 0, below 1e5
Cantilever cantilever_of_slope(double angle);  // of the line from the edge to the end, rad

// x and f over l at n + 1 equal steps from the clamp on.
std::vector<std::array<double, 2>> cantilever_shape(double beta, int n);

inline constexpr double kGostOverhang = 0.07, kGostLength = 0.16, kGostWidth = 0.03;  // m

double gost_10550_rigidity(double mass, double drop);          // kg of five strips, m -> EI, N m^2
double bending_length_rigidity(double weight, double length);  // kg/m^2, m -> B, N m

}  // namespace drape::standards
