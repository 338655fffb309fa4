#include "reference/sewing.h"

#include <algorithm>

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d gap_of(const std::array<Point, 2>& pair, const VectorXd& x) {
  return point_value(pair[1], x) - point_value(pair[0], x);
}

// 1/(A M^-1 A^T)
double closing_mass(const Lattice& lattice, const std::array<Point, 2>& pair) {
  VectorXd row = VectorXd::Zero(lattice.count);
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < pair[side].node.size(); ++k)
      row[pair[side].node[k]] += side == 0 ? -pair[side].weight[k] : pair[side].weight[k];
  double sum = 0;
  for (int n = 0; n < lattice.count; ++n) sum += row[n] * row[n] / lattice.mass[std::size_t(n)];
  return 1 / sum;
}

}  // namespace

Sewing sewing_start(const Lattice& lattice) {
  Sewing sewing;
  for (const Seam& seam : lattice.seams) sewing.emplace_back(seam.pairs.size(), Stage::kOpen);
  return sewing;
}

double add_pulls(const Lattice& lattice, const Sewing& sewing, const VectorXd& r, const VectorXd& v,
                 VectorXd& F) {
  double power = 0;
  for (std::size_t s = 0; s < lattice.seams.size(); ++s) {
    const Seam& seam = lattice.seams[s];
    for (std::size_t p = 0; p < seam.pairs.size(); ++p) {
      if (sewing[s][p] != Stage::kPulled) continue;
      const auto& pair = seam.pairs[p];
      const Vector3d d = gap_of(pair, r), rate = gap_of(pair, v);
      const double length = d.norm(), w = seam.pull;
      if (length == 0) continue;
      const Vector3d n = d / length;
      const double reach = std::min(length, 2 * seam.speed / w);
      const Vector3d on_a = closing_mass(lattice, pair) * (w * w * reach + 2 * w * rate.dot(n)) * n;
      for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t k = 0; k < pair[side].node.size(); ++k)
          F.segment<3>(3 * pair[side].node[k]) += (side == 0 ? 1 : -1) * pair[side].weight[k] * on_a;
      power -= on_a.dot(rate);
    }
  }
  return power;
}

bool motion_sew(Motion& motion, double time, const Outside& outside, VectorXd& y) {
  const Lattice& lattice = motion.lattice;
  const Layout at = layout_of(lattice);
  const VectorXd r = y.head(at.velocity);
  bool welds = false;
  for (std::size_t s = 0; s < lattice.seams.size(); ++s) {
    const Seam& seam = lattice.seams[s];
    for (std::size_t p = 0; p < seam.pairs.size(); ++p) {
      Stage& stage = motion.sewing[s][p];
      if (stage == Stage::kOpen && time >= seam.closed_at * (1 - 1e-12)) stage = Stage::kPulled;
      if (stage != Stage::kPulled || gap_of(seam.pairs[p], r).norm() > seam.gap_tolerance) continue;
      stage = Stage::kWelded;
      welds = true;
    }
  }
  if (!welds) return false;
  const double before = motion_energy(motion, turns_of(outside), y).total(), given = y[at.given];
  motion.held = held_make(lattice, motion.sewing);
  motion_begin(motion, course_make(lattice, outside, outside, 1), y);
  y[at.given] = given + motion_energy(motion, turns_of(outside), y).total() - before;
  return true;
}

}  // namespace drape::reference
