// The closing force of a pair is a spring mu w^2 and a damper 2 mu w (forces/seam_closing.h). Alone it adds
// w^2 to omega^2 and 2 w to d of the step limit. Pairs that share nodes add more, but at most (Gershgorin's
// theorem on the Gram matrix of the gaps)
//
//     max_i sum_j sqrt(k_i k_j) |A_i M^-1 A_j^T|,      k = mu w^2, for d 2 mu w,   1/mu_i = A_i M^-1 A_i^T
//
// The same bound holds for the hinges and links of sewn pairs: k = kappa with A = a/|a| - c/|c| across flat
// cloth, k = T'/R with A the link. By default w is a tenth of the omega of the stiffest piece at rest, so
// that closing hardly shortens the step.
#include "assembly/seam_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "forces/seam_bending.h"
#include "forces/seam_closing.h"
#include "model/node_sums.h"
#include "seam/layout.h"
#include "seam/particles.h"

namespace drape::assembly {
namespace {

constexpr double kPullShare = 0.1;  // 1, default w over omega at rest
constexpr double kInside = 1e-6;    // cell sizes from the outline to where the cell of a point is searched
constexpr double kEase = 1e-6;      // relative difference of the spacings above which a seam is gathered

// A point that is a particle on the outline.
model::SeamPoint particle_lay(const piece::Grid& grid, const model::Lattice& l, Vec2 p) {
  const std::size_t n = l.node_of(seam::seam_particle(grid, p));
  return {{n, n, n, n}, {1, 0, 0, 0}};
}

// The point p as a weighted sum over the corners of the cell that contains `looked_up`.
model::SeamPoint point_lay(const piece::Grid& grid, const model::Lattice& l, Vec2 p, Vec2 looked_up) {
  const piece::GridPoint at =
      piece::grid_point(grid, piece::grid_cell_of(grid, looked_up), piece::grid_coordinates(grid, p));
  model::SeamPoint point;
  for (int k = 0; k < 4; ++k) {
    point.node[k] = l.node_of(at.node[k]);
    point.weight[k] = at.weight[k];
  }
  return point;
}

Vec2 inside(Vec2 p, Vec2 inward, double d) { return {p[0] + d * inward[0], p[1] + d * inward[1]}; }

// The pairs of a seam and the hinges across them.
void pairs_lay(const std::vector<piece::Grid>& grids, const seam::SeamLayout& layout, const model::Seam& seam,
               System& system) {
  for (std::size_t n = 0; n < seam.count; ++n) {
    model::SeamPair pair;
    model::SeamPoint inner[2];
    model::SeamHinge hinge;
    const bool end = n == 0 || n + 1 == seam.count;
    hinge.width = seam.rest * (end && !seam.closed ? 0.5 : 1);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto piece = std::size_t(seam.piece[k]);
      const piece::Grid& grid = grids[piece];
      const Vec2 p = layout.point[k][n], in = layout.inward[k][n], deep = inside(p, in, grid.cell);
      pair.side[k] = grid.paper
                         ? particle_lay(grid, system.lattices[piece], p)
                         : point_lay(grid, system.lattices[piece], p, inside(p, in, kInside * grid.cell));
      inner[k] = point_lay(grid, system.lattices[piece], deep, deep);
      model::sum_add(pair.gap, pair.side[k], k == 0 ? -1 : 1);
      const double warp = in[1] * grid.cosine - in[0] * grid.sine,
                   weft = in[0] * grid.cosine + in[1] * grid.sine;
      hinge.reach[k] = grid.cell;
      hinge.yarn_shares[k][0] = std::pow(warp, 4);
      hinge.yarn_shares[k][1] = std::pow(weft, 4);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const double sign = k == 0 ? 1 : -1;
      for (const model::SeamPoint& x : pair.side) model::sum_add(hinge.arm[k], x, sign / 2);
      model::sum_add(hinge.arm[k], inner[k], -sign);
    }
    if (std::all_of(pair.gap.begin(), pair.gap.end(), [](const model::NodeTerm& t) { return t.weight == 0; }))
      hinge.width = 0;  // a corner that is sewn to itself
    system.seams.pair.push_back(pair);
    system.seams.hinge.push_back(hinge);
  }
}

void links_lay(bool paper, model::Seam& seam, System& system) {
  seam.link_first = system.seams.link.size();
  const bool gathered = std::abs(seam.spacing[0] - seam.spacing[1]) > kEase * seam.rest;
  if (!paper && !gathered && seam.tape == 0) return;
  const std::size_t steps = seam.closed ? seam.count : seam.count - 1;
  for (std::size_t n = 0; n < steps; ++n) {
    model::SeamLink link{{seam.first + n, seam.first + (n + 1) % seam.count}, {}};
    for (std::size_t side : {0u, 1u}) {
      model::sum_add(link.edge, system.seams.pair[link.pair[1]].side[side], 0.5);
      model::sum_add(link.edge, system.seams.pair[link.pair[0]].side[side], -0.5);
    }
    system.seams.link.push_back(link);
  }
  seam.link_count = steps;
}

// omega^2 of a piece at rest, 1/s^2: core/README.md, section 4.
double omega2_at_rest(const model::Lattice& l) {
  const fabric::Law& law = l.law;
  const double b = l.cell, k = std::max(math::curve_slope(law.warp, 0), math::curve_slope(law.weft, 0));
  return (4 * k + 4 * math::curve_slope(law.bias, 0) + 16 * (law.bending_warp + law.bending_weft) / (b * b)) /
         (law.areal_density * b * b);
}

struct Bond {
  const model::NodeSum* row;
  double strength;  // k; N/m where the row is a length
};

// Upper bound of what springs or dampers along rows add to omega^2 or d.
double gram_bound(const System& system, const std::vector<Bond>& bonds) {
  std::unordered_map<std::size_t, std::vector<std::pair<std::size_t, double>>> by_node;
  for (std::size_t p = 0; p < bonds.size(); ++p)
    for (const model::NodeTerm& t : *bonds[p].row) by_node[t.node].push_back({p, t.weight});
  double largest = 0;
  std::map<std::size_t, double> gram;
  for (std::size_t p = 0; p < bonds.size(); ++p) {
    const model::NodeSum& row = *bonds[p].row;
    gram.clear();
    for (const model::NodeTerm& t : row)
      for (const auto& [q, weight] : by_node[t.node])
        gram[q] += t.weight * weight * system.inverse_mass[t.node];
    double sum = 0;
    for (const auto& [q, value] : gram)
      sum += std::sqrt(bonds[p].strength * bonds[q].strength) * std::abs(value);
    largest = std::max(largest, sum);
  }
  return largest;
}

// c/|c| - a/|a| of a hinge as a row: in flat cloth, the change of its angle.
model::NodeSum angle_row(const model::SeamHinge& hinge) {
  model::NodeSum row;
  for (std::size_t k = 0; k < 2; ++k)
    for (const model::NodeTerm& t : hinge.arm[k])
      model::sum_add(row, {{t.node, 0, 0, 0}, {t.weight, 0, 0, 0}}, (k == 0 ? -1 : 1) / hinge.reach[k]);
  return row;
}

void welded_bound(System& system) {
  model::Seams& seams = system.seams;
  std::vector<model::NodeSum> angles;
  std::vector<Bond> bonds;
  angles.reserve(seams.hinge.size());
  for (const model::Seam& seam : seams.seam) {
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      const double kappa = seams.hinge[p].stiffness =
          forces::seam_hinge_stiffness(system, seam, seams.hinge[p]);
      if (kappa == 0) continue;
      angles.push_back(angle_row(seams.hinge[p]));
      bonds.push_back({&angles.back(), kappa});
    }
    for (std::size_t k = seam.link_first; k < seam.link_first + seam.link_count; ++k)
      bonds.push_back({&seams.link[k].edge, forces::seam_link_slope(system, seam) / seam.rest});
  }
  seams.omega2_welded = gram_bound(system, bonds);
}

}  // namespace

void seams_lay(const Scene& scene, const std::vector<piece::Grid>& grids, System& system) {
  for (const scene::SeamSpec& spec : scene.seams) {
    const seam::SeamLayout layout = seam::seam_layout(scene, spec);
    model::Seam seam;
    seam.first = system.seams.pair.size();
    seam.count = layout.point[0].size();
    seam.closed = layout.closed;
    seam.shorter = layout.length[1] < layout.length[0];
    for (std::size_t k = 0; k < 2; ++k) {
      seam.piece[k] = spec.side[k].piece;
      seam.length[k] = layout.length[k];
      seam.spacing[k] = layout.spacing[k];
    }
    seam.rest = std::min(seam.spacing[0], seam.spacing[1]);
    seam.closed_at = spec.closed_at;
    seam.gap_tolerance = spec.gap_tolerance;
    seam.speed = spec.speed;
    seam.pull_given = spec.pull;
    seam.tape = spec.tape;
    const piece::Grid& grid = grids[std::size_t(seam.piece[seam.shorter])];
    const std::vector<Vec2>& line = layout.point[seam.shorter];
    const Vec2 chord{line.back()[0] - line.front()[0], line.back()[1] - line.front()[1]};
    seam.along_warp = std::abs(chord[1] * grid.cosine - chord[0] * grid.sine) >=
                      std::abs(chord[0] * grid.cosine + chord[1] * grid.sine);
    seam.link_width = grid.cell;
    pairs_lay(grids, layout, seam, system);
    links_lay(grid.paper, seam, system);
    system.seams.seam.push_back(seam);
  }
}

void seams_retune(System& system) {
  model::Seams& seams = system.seams;
  if (seams.seam.empty()) return;
  double stiffest = 0;
  for (const model::Lattice& l : system.lattices) stiffest = std::max(stiffest, omega2_at_rest(l));
  std::vector<Bond> springs, dampers;
  for (model::Seam& seam : seams.seam) {
    seam.pull = seam.pull_given > 0 ? seam.pull_given : kPullShare * std::sqrt(stiffest);
    for (std::size_t p = seam.first; p < seam.first + seam.count; ++p) {
      const double mass = forces::seam_mass(system, seams.pair[p]);
      springs.push_back({&seams.pair[p].gap, mass * seam.pull * seam.pull});
      dampers.push_back({&seams.pair[p].gap, 2 * mass * seam.pull});
    }
  }
  seams.omega2_pull = gram_bound(system, springs);
  seams.damping = gram_bound(system, dampers);
  welded_bound(system);
}

}  // namespace drape::assembly
