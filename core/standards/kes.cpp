#include "standards/kes.h"

#include <cmath>

#include "math/bisection.h"
#include "math/monotone_curve.h"

namespace drape::standards {

namespace {

constexpr int kSegments = 10;
constexpr double kBend = 12;  // bound of |a|; LT is then from 0.17 to 1.83

// (exp(a x) - 1)/(exp(a) - 1)
double share(double a, double x) { return a == 0 ? x : std::expm1(a * x) / std::expm1(a); }

Diagram diagram_of(double a, double emt, double force) {
  Diagram d;
  for (int i = 0; i <= kSegments; ++i) {
    d.percent.push_back(emt * i / kSegments);
    d.force_per_width.push_back(force * share(a, double(i) / kSegments));
  }
  return d;
}

// The area under the monotone curve through the points, N/m.
double energy_of(const Diagram& d) {
  std::vector<double> e;
  for (const double percent : d.percent) e.push_back(percent / 100);
  return math::curve_energy(math::curve_make(e, d.force_per_width, {}), e.back());
}

}  // namespace

double kes_linearity(double emt, double wt, double fm) { return wt / (fm * emt / 100 / 2); }

double kes_energy(double emt, double lt, double fm) { return lt * fm * emt / 100 / 2; }

Diagram kes_tension(double emt, double wt, double fm) {
  const double force = fm * kGramForcePerCm, energy = wt * kGramForcePerCm;
  // The area decreases as a increases, so it increases with -a.
  const auto energy_at = [&](double minus_a) { return energy_of(diagram_of(-minus_a, emt, force)); };
  return diagram_of(-math::bisect_rising(energy_at, energy, -kBend, kBend), emt, force);
}

}  // namespace drape::standards
