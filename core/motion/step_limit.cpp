#include "motion/step_limit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace drape {
namespace {

// A link by its ends, for the search below.
struct LinkKind {
  const char* name;
  int di, dj;  // to the other end
  const Curve* law;
  double rigidity;  // of the hinges across it, N m
};

// Where the present velocities lead in `ahead` s.
double distance(const State& s, std::size_t a, std::size_t b, double ahead) {
  return std::hypot(s.x[b] - s.x[a] + ahead * (s.vx[b] - s.vx[a]),
                    s.y[b] - s.y[a] + ahead * (s.vy[b] - s.vy[a]),
                    s.z[b] - s.z[a] + ahead * (s.vz[b] - s.vz[a]));
}

// What a link adds to rho b^2 omega^2 of its cell, and its strain.
struct LinkTerm {
  double stretch, bend, strain;
};
LinkTerm link_term(const State& s, const LinkKind& kind, double rest, std::size_t a, std::size_t b,
                   double ahead) {
  const double ratio = distance(s, a, b, ahead) / rest, strain = ratio - 1;
  const double slope = curve_slope(*kind.law, strain),
               across = std::max(curve_value(*kind.law, strain) / ratio, 0.0);
  const bool diagonal = kind.di != 0 && kind.dj != 0;
  const double stretch =
      diagonal ? 4 * std::max(slope, across) : 4 * std::max(slope - across, 0.0) + 8 * across;
  return {stretch, 16 * kind.rigidity / std::pow(ratio * rest, 2), strain};
}

}  // namespace

double step_limit_omega2(const System& system, const Kernel& kernel, const State& state, double ahead) {
  double most = 0;  // what is no number stays
  for (const Lattice& l : system.lattices)
    for (int j = 0; j + 1 < l.rows; ++j)
      if (const double omega2 = kernel.omega2(system, l, state, j, ahead);
          omega2 > most || std::isnan(omega2))
        most = omega2;
  return most;
}

// Leapfrog with centred damping: h omega < 2. The paper's scheme: (h omega)^2 < 4 - 2 h c. Infinite where
// nothing acts.
double step_limit_of(const System& system, double omega2) {
  const double c = system.integrator == Integrator::kPaper ? system.damping : 0;
  return 4 / (c + std::sqrt(c * c + 4 * omega2));
}

std::string step_limit_link(const System& system, const Scene& scene, const State& state, double ahead) {
  double worst = 0;
  std::string words = "nothing: no law acts";
  for (const Lattice& l : system.lattices) {
    const Law& law = l.law;
    const LinkKind kinds[] = {{"weft", 1, 0, &law.weft, law.bending_weft},
                              {"warp", 0, 1, &law.warp, law.bending_warp},
                              {"bias", 1, 1, &law.bias, 0},
                              {"bias", -1, 1, &law.bias, 0}};
    const double mass = law.areal_density * l.cell * l.cell;
    for (int j = 0; j < l.rows; ++j)
      for (int i = 0; i < l.columns; ++i)
        for (const LinkKind& kind : kinds) {
          const int i2 = i + kind.di, j2 = j + kind.dj;
          if (i2 < 0 || i2 >= l.columns || j2 >= l.rows) continue;
          const std::size_t a = l.node(i, j), b = l.node(i2, j2);
          if (system.mass[a] == 0 || system.mass[b] == 0) continue;
          const LinkTerm term = link_term(state, kind, l.cell * std::hypot(kind.di, kind.dj), a, b, ahead);
          if ((term.stretch + term.bend) / mass <= worst) continue;
          worst = (term.stretch + term.bend) / mass;
          char text[160];
          std::snprintf(text, sizeof text, "%s %s of piece '%s', column %d, row %d, strain %.3g", kind.name,
                        term.bend > term.stretch ? "hinge" : "link",
                        scene.pieces[std::size_t(l.piece)].name.c_str(), i + 1, j + 1,
                        std::abs(term.strain) < 1e-12 ? 0.0 : term.strain);
          words = text;
        }
  }
  return words;
}

}  // namespace drape
