// The interpolant of all load-elongation diagrams, and the odd bias law. Equations: core/README.md, section 2
// (curve) and section 3 (odd bias law).
#pragma once
#include <vector>

namespace drape::reference {

// How a curve continues below zero. The bias model "tension" is a compression with ratio 0.
enum class Below { kCompression, kOdd };

// Points (e[k], f[k]) with slopes k[k]. Without points there is no law, and the curve is 0 everywhere.
struct Curve {
  std::vector<double> e, f, k;  // [n + 1]
  Below below = Below::kOdd;
  double ratio = 1, blend = 0;  // r and c of the compression
};

Curve curve_make(const std::vector<double>& e, const std::vector<double>& f, Below below, double ratio = 1,
                 double blend = 0);

double curve_value(const Curve& curve, double e);   // f(e)
double curve_slope(const Curve& curve, double e);   // f'(e)
double curve_energy(const Curve& curve, double e);  // integral of f from 0 to e

// The elongations of a diagram below the locking stretch 1 + e = sqrt(2) of a trellis.
std::vector<double> below_locking(const std::vector<double>& e);

// The function g of the odd bias law, from the strip's force per width P at the elongations e (both with the
// origin). At every L = e_i below locking, with l1 = 1 + L, l2 = sqrt(2 - l1^2), e2 = l2 - 1,
//     g(L) + g(|e2|) l1/l2 = P(L).
// Throws std::runtime_error where the iteration does not converge.
Curve odd_law(const std::vector<double>& e, const std::vector<double>& P);

}  // namespace drape::reference
