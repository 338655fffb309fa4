// The step limit with forces that depend on velocity. omega^2 is the largest of a lattice, and
// d = beta omega^2 + (rho_air/rho) max(C_n, C_t) max|u|. The limit of leapfrog is then that of a lattice
// without these forces and with omega' = sqrt(omega^2 + d^2) + d:
//
//   h < 2 [sqrt(omega^2 + d^2) - d]/omega^2 = 2/omega'
//
// In the scheme of the paper d adds to c: (h omega)^2 + 2 h (c + d) < 4.
#include "dynamics/step_size/step_limit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "contact/particle/contact.h"
#include "dynamics/step_size/cell_defect.h"
#include "forces/seam_closing.h"
#include "model/composition.h"
#include "model/elements.h"
#include "simd/lane_scalar.h"

namespace drape::dynamics {
namespace {

// The larger of a and b; NaN if either is.
double max_of(double a, double b) { return a > b || std::isnan(a) ? a : b; }

using Lane = simd::ScalarLane<false>;

simd::Vec<Lane> node_ahead(const State& s, std::size_t n, double ahead) {
  return {s.x[n] + ahead * s.vx[n], s.y[n] + ahead * s.vy[n], s.z[n] + ahead * s.vz[n]};
}

double distance(const State& s, std::size_t a, std::size_t b, double ahead) {
  const simd::Vec<Lane> d = node_ahead(s, b, ahead) - node_ahead(s, a, ahead);
  return std::sqrt(dot(d, d).v);
}

CellCorners<Lane> corners_ahead(const State& s, const std::size_t* corner, double ahead) {
  return {node_ahead(s, corner[0], ahead), node_ahead(s, corner[1], ahead), node_ahead(s, corner[2], ahead),
          node_ahead(s, corner[3], ahead)};
}

// The largest of the irregular cells, times rho b^2.
double irregular_bound(const System& system, const model::Lattice& l, const State& s, double ahead) {
  double largest = 0;
  for (const model::IrregularCell& cell : system.irregular.cells)
    if (cell.lattice == l.piece)
      largest = max_of(cell_bound(corners_ahead(s, cell.node, ahead), l).v, largest);
  return largest;
}

void defects_join(StepDefect& to, const StepDefect& other) {
  to.energy += other.energy;
  to.omega2 = max_of(other.omega2, to.omega2);
}

StepDefect lattice_defect(const System& system, const Kernel& kernel, const model::Lattice& l, const State& s,
                          double step) {
  StepDefect all;
  for (int j = 0; j + 1 < l.rows; ++j) defects_join(all, kernel.defect(system, l, s, j, step));
  for (const model::IrregularCell& cell : system.irregular.cells) {
    if (cell.lattice != l.piece) continue;
    const LinkDefect<Lane> defect =
        cell_defect(corners_ahead(s, cell.node, -step), corners_ahead(s, cell.node, 0), l);
    defects_join(all, {cell.share * defect.sum.v * defect_unit(l), defect.change.v * defect_change(l)});
  }
  return all;
}

// What a clamp, and all clamps of a lattice, add to rho b^2 omega^2.
double clamp_term(const model::ClampHinge& c, const fabric::Law& law, const State& s, double ahead) {
  return 16 * model::law_bending(law, c.warp) * c.excess /
         std::pow(distance(s, c.node[0], c.node[1], ahead), 2);
}
double clamps_bound(const System& system, const model::Lattice& l, const State& s, double ahead) {
  double largest[2] = {0, 0};
  for (const model::ClampHinge& c : system.irregular.clamps)
    if (c.lattice == l.piece && c.excess > 0)
      largest[c.warp] = max_of(clamp_term(c, l.law, s, ahead), largest[c.warp]);
  return largest[0] + largest[1];
}

// The largest speed (m/s) of a particle relative to the wind.
double speed_against_wind(const System& system, const State& s) {
  double largest = 0;
  for (std::size_t n : system.particle) {
    const double x = s.vx[n] - s.wind[0], y = s.vy[n] - s.wind[1], z = s.vz[n] - s.wind[2];
    largest = max_of(x * x + y * y + z * z, largest);
  }
  return std::sqrt(largest);
}

// The equivalent omega^2: without forces that depend on velocity, it gives the limit of omega2 and d.
double omega2_with(const System& system, double omega2, double d) {
  if (d == 0) return omega2;
  if (system.integrator != scene::Integrator::kPaper) return std::pow(std::sqrt(omega2 + d * d) + d, 2);
  const double c = system.damping, twice = c + d + std::sqrt((c + d) * (c + d) + 4 * omega2);  // 4/h
  return twice * (twice - 2 * c) / 4;
}

// What has the largest omega^2 so far.
struct WorstPart {
  double bound = 0;  // 1/s^2
  std::string words = "nothing: no law acts";
};

struct Part {
  double bound;  // rho b^2 omega^2, N/m
  const char *name, *kind;
  std::size_t node;
  double strain;
};

void part_offer(WorstPart& worst, const Scene& scene, const model::Lattice& l, const Part& part) {
  const double bound = part.bound / (l.law.areal_density * l.cell * l.cell);
  if (bound <= worst.bound) return;
  worst.bound = bound;
  const auto [column, row] = l.place_of(part.node);
  char text[160];
  std::snprintf(text, sizeof text, "%s %s of piece '%s', column %d, row %d, strain %.3g", part.name,
                part.kind, scene.pieces[std::size_t(l.piece)].name.c_str(), column + 1, row + 1,
                std::abs(part.strain) < 1e-12 ? 0.0 : part.strain);
  worst.words = text;
}

// Offers a link with the hinges across it: what they add to rho b^2 omega^2 of its cell.
void link_offer(WorstPart& worst, const Scene& scene, const model::Lattice& l, const State& s,
                const model::Link& link, double ahead) {
  const char* name = link.along == model::YarnDirection::kWarp   ? "warp"
                     : link.along == model::YarnDirection::kWeft ? "weft"
                                                                 : "bias";
  const math::Curve& curve = model::law_curve(l.law, link.along);
  const double ratio = distance(s, link.from, link.to, ahead) / link.rest, strain = ratio - 1;
  const double slope = math::curve_slope(curve, strain),
               across = std::max(math::curve_value(curve, strain) / ratio, 0.0);
  const bool diagonal = link.along == model::YarnDirection::kBias;
  const double stretch =
      diagonal ? 4 * std::max(slope, across) : 4 * std::max(slope - across, 0.0) + 8 * across;
  const double rigidity = diagonal ? 0 : model::law_bending(l.law, link.along == model::YarnDirection::kWarp);
  const double bend = 16 * rigidity / std::pow(ratio * link.rest, 2);
  part_offer(worst, scene, l, {stretch + bend, name, bend > stretch ? "hinge" : "link", link.from, strain});
}

// The seam in the state `sewn` with the largest `stiffness` of its pairs.
template <class Stiffness>
std::string seam_words(const System& system, const Scene& scene, const State& s, model::Sewn sewn,
                       Stiffness stiffness) {
  double largest = -1;
  std::string name;
  for (std::size_t k = 0; k < system.seams.seam.size(); ++k) {
    const model::Seam& seam = system.seams.seam[k];
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p)
      if (s.sewn[p] == sewn && stiffness(seam, p) > largest)
        largest = stiffness(seam, p), name = scene.seams[k].name;
  }
  return "seam '" + name + "'";
}

void seams_offer(WorstPart& worst, const System& system, const Scene& scene, const State& s) {
  const SeamsBound bound = step_limit_seams(system, s);
  const bool pulls = bound.d > 0;
  const double welded =
      bound.omega2 - (pulls ? system.seams.omega2_pull * (1 + forces::seams_integral_bound(system, s)) : 0);
  const double pulled = omega2_with(system, bound.omega2 - welded, bound.d);
  if (pulls && pulled > worst.bound) {
    worst.bound = pulled;
    worst.words =
        "pull of " +
        seam_words(system, scene, s, model::Sewn::kPulled, [&](const model::Seam& seam, std::size_t p) {
          return seam.pull * seam.pull * (1 + s.closing_integral[p] / seam.gap_tolerance);
        });
  }
  if (welded > worst.bound) {
    worst.bound = welded;
    worst.words = "hinges and links of " + seam_words(system, scene, s, model::Sewn::kWelded,
                                                      [](const model::Seam& seam, std::size_t) {
                                                        return double(seam.link_count) + seam.tape;
                                                      });
  }
}

}  // namespace

double step_limit_cell(const model::Lattice& l, const State& s, const std::size_t* corner, double ahead) {
  return cell_bound(corners_ahead(s, corner, ahead), l).v /
         (l.mass_kept * l.law.areal_density * l.cell * l.cell);
}

double step_limit_clamps(const System& system, const model::Lattice& l, const State& s, double ahead) {
  return clamps_bound(system, l, s, ahead) / (l.mass_kept * l.law.areal_density * l.cell * l.cell);
}

double step_limit_lattice(const System& system, const Kernel& kernel, const model::Lattice& l,
                          const State& state, double ahead) {
  double largest = 0;
  for (int j = 0; j + 1 < l.rows; ++j) largest = max_of(kernel.omega2(system, l, state, j, ahead), largest);
  largest =
      max_of(irregular_bound(system, l, state, ahead) / (l.law.areal_density * l.cell * l.cell), largest);
  return largest / l.mass_kept + step_limit_clamps(system, l, state, ahead);
}

StepDefect step_defect(const System& system, const Kernel& kernel, const State& s, double step) {
  StepDefect all;
  for (const model::Lattice& l : system.lattices)
    defects_join(all, lattice_defect(system, kernel, l, s, step));
  return all;
}

double step_limit_drag(const System& system, const State& state) {
  if (!model::system_has_air(system)) return 0;
  const model::Air& air = system.air;
  return air.density * std::max(air.normal, air.tangential) * speed_against_wind(system, state);
}

SeamsBound step_limit_seams(const System& system, const State& s) {
  const auto any = [&](model::Sewn state) {
    return std::find(s.sewn.begin(), s.sewn.end(), state) != s.sewn.end();
  };
  SeamsBound bound;
  if (any(model::Sewn::kWelded)) bound.omega2 = system.seams.omega2_welded;
  if (!any(model::Sewn::kPulled)) return bound;
  bound.omega2 += system.seams.omega2_pull * (1 + forces::seams_integral_bound(system, s));
  bound.d = system.seams.damping;
  return bound;
}

double step_limit_rated(const System& system, const model::Lattice& l, double omega2, double drag,
                        const SeamsBound& seams, double contact) {
  omega2 += contact;
  const double d = l.law.damping * omega2 + drag / l.law.areal_density;
  return omega2_with(system, omega2 + seams.omega2, d + seams.d);
}

double step_limit_omega2(const System& system, const Kernel& kernel, const State& state, double ahead) {
  const double drag = step_limit_drag(system, state);
  const SeamsBound seams = step_limit_seams(system, state);
  double largest = 0;
  for (const model::Lattice& l : system.lattices) {
    const double omega2 = step_limit_lattice(system, kernel, l, state, ahead);
    largest = max_of(
        step_limit_rated(system, l, omega2, drag, seams, contact::added_omega2(system, state, l.piece)),
        largest);
  }
  return largest;
}

double step_limit_angle(const System& system) { return system.composition ? system.composition->limit : 2; }

// Leapfrog with centred damping: h omega < 2. Above order 2: h omega < the limit of the method, and c h < 10.
// The scheme of the paper: (h omega)^2 < 4 - 2 h c. Infinite where nothing acts.
double step_limit_of(const System& system, double omega2) {
  if (system.composition)
    return std::min(system.composition->limit / std::sqrt(omega2), model::kDampedStep / system.damping);
  const double c = system.integrator == scene::Integrator::kPaper ? system.damping : 0;
  return 4 / (c + std::sqrt(c * c + 4 * omega2));
}

double step_automatic(const System& system, double omega2, const MotionBound& motion) {
  const double limit = step_limit_of(system, omega2), c = system.damping;
  const double flutter = kFlutter * (1 + 2 * c * kFlutterTime), drift = kDrift * (1 + 2 * c * kDriftTime);
  double step = kSafety * limit;
  if (motion.flutter > 0)
    step = std::clamp(std::cbrt(4 * flutter / motion.flutter), kSafetyNonlinear * limit, step);
  if (motion.drift > 0) step = std::clamp(std::sqrt(drift / motion.drift), kSafetyLeast * limit, step);
  return step;
}

double flutter_unknown(const System& system, double omega2) {
  const bool damped = system.damping >= kDampedShare * std::sqrt(omega2);
  return damped ? 0 : std::numeric_limits<double>::infinity();
}

std::string step_limit_link(const System& system, const Scene& scene, const State& state, double ahead) {
  WorstPart worst;
  for (const model::Lattice& l : system.lattices)
    model::links_visit(system, l,
                       [&](const model::Link& link) { link_offer(worst, scene, l, state, link, ahead); });
  for (const model::ClampHinge& c : system.irregular.clamps) {
    const model::Lattice& l = system.lattices[std::size_t(c.lattice)];
    const double strain = distance(state, c.node[0], c.node[1], ahead) / l.cell - 1;
    part_offer(worst, scene, l,
               {clamp_term(c, l.law, state, ahead), c.warp ? "warp" : "weft", "clamp", c.node[1], strain});
  }
  seams_offer(worst, system, scene, state);
  return worst.words;
}

}  // namespace drape::dynamics
