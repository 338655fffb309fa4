#include "reference/sewing.h"

#include <algorithm>
#include <cmath>

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

Vector3d middle_of(const std::array<Point, 2>& pair, const VectorXd& r) {
  return (point_value(pair[0], r) + point_value(pair[1], r)) / 2;
}

void add_at(const Point& point, const Vector3d& force, VectorXd& F) {
  for (std::size_t k = 0; k < point.node.size(); ++k)
    F.segment<3>(3 * point.node[k]) += point.weight[k] * force;
}
void add_middle(const std::array<Point, 2>& pair, const Vector3d& force, VectorXd& F) {
  for (const Point& point : pair) add_at(point, force / 2, F);
}

// Calls hinge(pair, inner, kappa) and link(seam, pair, next) for all welded pairs.
template <class Hinge, class Link>
void bonds_visit(const Lattice& lattice, const Sewing& sewing, Hinge hinge, Link link) {
  for (std::size_t s = 0; s < lattice.seams.size(); ++s) {
    const Seam& seam = lattice.seams[s];
    const std::size_t n = seam.pairs.size();
    for (std::size_t p = 0; p < n; ++p) {
      if (sewing[s][p] != Stage::kWelded) continue;
      if (seam.kappa[p] > 0) hinge(seam.pairs[p], seam.inner[p], seam.kappa[p]);
      const std::size_t next = (p + 1) % n;
      if (seam.linked && (next > 0 || seam.closed) && sewing[s][next] == Stage::kWelded)
        link(seam, seam.pairs[p], seam.pairs[next]);
    }
  }
}

}  // namespace

void add_bonds(const Lattice& lattice, const Sewing& sewing, const VectorXd& r, VectorXd& F) {
  bonds_visit(
      lattice, sewing,
      [&](const auto& pair, const auto& inner, double kappa) {
        const Vector3d x = middle_of(pair, r), a = x - point_value(inner[0], r),
                       c = point_value(inner[1], r) - x;
        const Fold fold = fold_of(a, c);
        const Vector3d u = a.normalized(), v = c.normalized();
        const Vector3d F2 = kappa * fold.psi / c.norm() * (u - fold.y * v);
        const Vector3d F0 = -kappa * fold.psi / a.norm() * (v - fold.y * u);
        add_at(inner[0], F0, F);
        add_at(inner[1], F2, F);
        add_middle(pair, -F0 - F2, F);
      },
      [&](const Seam& seam, const auto& pair, const auto& next) {
        const Vector3d d = middle_of(next, r) - middle_of(pair, r);
        const double e = d.norm() / seam.rest - 1;
        const double tension =
            seam.width * curve_value(lattice.laws[std::size_t(seam.law)].curve, e) + seam.tape * e;
        add_middle(pair, tension * d.normalized(), F);
        add_middle(next, -tension * d.normalized(), F);
      });
}

BondEnergy bond_energy(const Lattice& lattice, const Sewing& sewing, const VectorXd& r) {
  BondEnergy energy;
  bonds_visit(
      lattice, sewing,
      [&](const auto& pair, const auto& inner, double kappa) {
        const Vector3d x = middle_of(pair, r);
        energy.bending += kappa * fold_of(x - point_value(inner[0], r), point_value(inner[1], r) - x).energy;
      },
      [&](const Seam& seam, const auto& pair, const auto& next) {
        const double e = (middle_of(next, r) - middle_of(pair, r)).norm() / seam.rest - 1;
        energy.stretch +=
            seam.rest *
            (seam.width * curve_energy(lattice.laws[std::size_t(seam.law)].curve, e) + seam.tape * e * e / 2);
      });
  return energy;
}

Sewing sewing_start(const Lattice& lattice) {
  Sewing sewing;
  for (const Seam& seam : lattice.seams) sewing.emplace_back(seam.pairs.size(), Stage::kOpen);
  return sewing;
}

VectorXd integral_rates(const Motion& motion, double time, const VectorXd& r, const VectorXd& v) {
  const Lattice& lattice = motion.lattice;
  const Layout at = layout_of(lattice);
  VectorXd rates = VectorXd::Zero(at.time - at.integral);
  Eigen::Index k = 0;
  for (std::size_t s = 0; s < lattice.seams.size(); ++s) {
    const Seam& seam = lattice.seams[s];
    for (std::size_t p = 0; p < seam.pairs.size(); ++p, ++k) {
      const double w = seam.pull;
      if (motion.sewing[s][p] != Stage::kPulled || time - motion.closing_since[s][p] < 20 / w) continue;
      const Vector3d d = gap_of(seam.pairs[p], r), rate = gap_of(seam.pairs[p], v);
      const double length = d.norm();
      if (-rate.dot(d) < length * std::min(w * length, 2 * seam.speed) / 10)
        rates[k] = w * std::min(length, 2 * seam.speed / w);
    }
  }
  return rates;
}

double add_closing(const Lattice& lattice, const Sewing& sewing, const VectorXd& integral, const VectorXd& r,
                   const VectorXd& v, VectorXd& F) {
  double power = 0;
  Eigen::Index number = -1;
  for (std::size_t s = 0; s < lattice.seams.size(); ++s) {
    const Seam& seam = lattice.seams[s];
    for (std::size_t p = 0; p < seam.pairs.size(); ++p) {
      ++number;
      if (sewing[s][p] != Stage::kPulled) continue;
      const auto& pair = seam.pairs[p];
      const Vector3d d = gap_of(pair, r), rate = gap_of(pair, v);
      const double length = d.norm(), w = seam.pull;
      if (length == 0) continue;
      const Vector3d n = d / length;
      const double added =
          std::min(integral[number], 4000 * seam.speed / w) * length / std::hypot(length, seam.gap_tolerance);
      const double reach = std::min(length, 2 * seam.speed / w) + added;
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
  motion.begun = time;
  for (std::size_t s = 0; s < lattice.seams.size(); ++s) {
    const Seam& seam = lattice.seams[s];
    for (std::size_t p = 0; p < seam.pairs.size(); ++p) {
      Stage& stage = motion.sewing[s][p];
      if (stage == Stage::kOpen && time >= seam.closed_at * (1 - 1e-12)) {
        stage = Stage::kPulled;
        motion.closing_since[s][p] = time;
      }
      if (stage != Stage::kPulled || gap_of(seam.pairs[p], r).norm() > seam.gap_tolerance) continue;
      stage = Stage::kWelded;
      welds = true;
    }
  }
  if (!welds) return false;
  const double before = motion_energy(motion, turns_of(outside), y).total(), input = y[at.input];
  motion.held = held_make(lattice, motion.sewing);
  motion_begin(motion, course_make(lattice, outside, outside, 1), y);
  y[at.input] = input + motion_energy(motion, turns_of(outside), y).total() - before;
  return true;
}

}  // namespace drape::reference
