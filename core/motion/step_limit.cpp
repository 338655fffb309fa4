#include "motion/step_limit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace drape {
namespace {

// A link by its ends, for the search below.
struct LinkKind {
  const char* name;
  int di, dj;  // to the other end
  const Curve* law;
  double rigidity;  // of the hinges across it, N m
};

double distance(const State& s, std::size_t a, std::size_t b) {
  return std::hypot(s.x[b] - s.x[a], s.y[b] - s.y[a], s.z[b] - s.z[a]);
}

// What a link adds to rho b^2 omega^2 of its cell, and its strain.
struct LinkTerm {
  double stretch, bend, strain;
};
LinkTerm link_term(const State& s, const LinkKind& kind, double rest, std::size_t a, std::size_t b) {
  const double ratio = distance(s, a, b) / rest, strain = ratio - 1;
  const double slope = curve_slope(*kind.law, strain),
               across = std::max(curve_value(*kind.law, strain) / ratio, 0.0);
  const bool diagonal = kind.di != 0 && kind.dj != 0;
  const double stretch =
      diagonal ? 4 * std::max(slope, across) : 4 * std::max(slope - across, 0.0) + 8 * across;
  return {stretch, 16 * kind.rigidity / std::pow(ratio * rest, 2), strain};
}

}  // namespace

double step_limit_omega2(const System& system, const Kernel& kernel, const State& state, double ahead) {
  double most = 0;
  for (const Lattice& l : system.lattices)
    for (int j = 0; j + 1 < l.rows; ++j) most = std::max(most, kernel.omega2(system, l, state, j, ahead));
  return most;
}

// Leapfrog with centred damping: h omega < 2. The paper's scheme: (h omega)^2 < 4 - 2 h c.
double step_limit_of(const System& system, double omega2) {
  const double c = system.integrator == Integrator::kPaper ? system.damping : 0;
  if (omega2 == 0) return c > 0 ? 2 / c : std::numeric_limits<double>::infinity();
  return (std::sqrt(c * c + 4 * omega2) - c) / omega2;
}

std::string step_limit_link(const System& system, const Scene& scene, const State& state) {
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
          const LinkTerm term = link_term(state, kind, l.cell * std::hypot(kind.di, kind.dj), a, b);
          if ((term.stretch + term.bend) / mass <= worst) continue;
          worst = (term.stretch + term.bend) / mass;
          char text[160];
          std::snprintf(text, sizeof text, "%s %s of piece '%s', column %d, row %d, at %.3g %% of strain",
                        kind.name, term.bend > term.stretch ? "hinge" : "link",
                        scene.pieces[std::size_t(l.piece)].name.c_str(), i + 1, j + 1, 100 * term.strain);
          words = text;
        }
  }
  return words;
}

}  // namespace drape
