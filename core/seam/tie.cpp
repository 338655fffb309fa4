// The pull on a pair is a spring mu w^2 and a damper 2 mu w (forces/pull.h). On its own it adds w^2 to omega^2
// and 2 w to d of the step limit; pairs that share nodes add more, at most (Gershgorin, on the Gram matrix of
// the gaps)
//
//     max_i sum_j sqrt(k_i k_j) |A_i M^-1 A_j^T|,      k = mu w^2, for d 2 mu w,   1/mu_i = A_i M^-1 A_i^T
//
// w is automatically a tenth of the omega of the stiffest piece at rest, so that pulling hardly shortens the
// step.
#include "seam/tie.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "forces/pull.h"
#include "seam/layout.h"

namespace drape {
namespace {

constexpr double kPullShare = 0.1;  // of omega at rest
constexpr double kInside = 1e-6;    // cells: how far off the outline the cell of a point is looked up

SeamPoint point_tie(const Grid& grid, const Lattice& l, Vec2 p, Vec2 inward) {
  const double d = kInside * grid.cell;
  const int cell = grid_cell_of(grid, {p[0] + d * inward[0], p[1] + d * inward[1]});
  const GridPoint at = grid_point(grid, cell, grid_coordinates(grid, p));
  SeamPoint point;
  for (int k = 0; k < 4; ++k) {
    point.node[k] = l.node_of(at.node[k]);
    point.weight[k] = at.weight[k];
  }
  return point;
}

void gap_add(SeamPair& pair, const SeamPoint& point, double sign) {
  for (int k = 0; k < 4; ++k) {
    if (point.weight[k] == 0) continue;
    int at = 0;
    while (at < pair.count && pair.node[at] != point.node[k]) ++at;
    if (at == pair.count) {
      pair.node[at] = point.node[k];
      pair.weight[at] = 0;
      ++pair.count;
    }
    pair.weight[at] += sign * point.weight[k];
  }
}

// omega^2 of a piece at rest: core/README.md, section 4.
double omega2_at_rest(const Lattice& l) {
  const Law& law = l.law;
  const double b = l.cell, k = std::max(curve_slope(law.warp, 0), curve_slope(law.weft, 0));
  return (4 * k + 4 * curve_slope(law.bias, 0) + 16 * (law.bending_warp + law.bending_weft) / (b * b)) /
         (law.areal_density * b * b);
}

// What springs or dampers of `strength` (k) along the gaps add, at most.
double gram_bound(const System& system, const std::vector<double>& strength) {
  const std::vector<SeamPair>& pairs = system.seams.pair;
  std::unordered_map<std::size_t, std::vector<std::pair<std::size_t, double>>> by_node;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    for (int k = 0; k < pairs[p].count; ++k) by_node[pairs[p].node[k]].push_back({p, pairs[p].weight[k]});
  double most = 0;
  std::map<std::size_t, double> row;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    row.clear();
    for (int k = 0; k < pairs[p].count; ++k)
      for (const auto& [q, weight] : by_node[pairs[p].node[k]])
        row[q] += pairs[p].weight[k] * weight * system.inverse_mass[pairs[p].node[k]];
    double sum = 0;
    for (const auto& [q, value] : row) sum += std::sqrt(strength[p] * strength[q]) * std::abs(value);
    most = std::max(most, sum);
  }
  return most;
}

}  // namespace

void seams_tie(const Scene& scene, const std::vector<Grid>& grids, System& system) {
  for (const SeamSpec& spec : scene.seams) {
    const SeamLayout layout = seam_layout(scene, spec);
    Seam seam;
    seam.first = int(system.seams.pair.size());
    seam.count = int(layout.point[0].size());
    std::copy_n(layout.length, 2, seam.length);
    std::copy_n(layout.spacing, 2, seam.spacing);
    seam.closed_at = spec.closed_at;
    seam.gap_tolerance = spec.gap_tolerance;
    seam.speed = spec.speed;
    seam.pull_given = spec.pull;
    for (int n = 0; n < seam.count; ++n) {
      SeamPair pair;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto p = std::size_t(spec.side[k].piece);
        pair.side[k] = point_tie(grids[p], system.lattices[p], layout.point[k][std::size_t(n)],
                                 layout.inward[k][std::size_t(n)]);
        gap_add(pair, pair.side[k], k == 0 ? -1 : 1);
      }
      system.seams.pair.push_back(pair);
    }
    system.seams.seam.push_back(seam);
  }
}

void seams_retune(System& system) {
  Seams& seams = system.seams;
  if (seams.seam.empty()) return;
  double stiffest = 0;
  for (const Lattice& l : system.lattices) stiffest = std::max(stiffest, omega2_at_rest(l));
  std::vector<double> spring(seams.pair.size()), damper(seams.pair.size());
  for (Seam& seam : seams.seam) {
    seam.pull = seam.pull_given > 0 ? seam.pull_given : kPullShare * std::sqrt(stiffest);
    for (auto p = std::size_t(seam.first); p < std::size_t(seam.first + seam.count); ++p) {
      const double mass = seam_mass(system, seams.pair[p]);
      spring[p] = mass * seam.pull * seam.pull;
      damper[p] = 2 * mass * seam.pull;
    }
  }
  seams.omega2 = gram_bound(system, spring);
  seams.damping = gram_bound(system, damper);
}

}  // namespace drape
