// The common suite of every law: force = -grad E, no net force or torque, zero at rest, rotates with the
// cloth. Also the lattice's masses, widths and laws against their own equations.
#include "reference/forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/test_cloth.h"

namespace drape::reference {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kPi = std::numbers::pi;

struct NamedLaw {
  const char* name;
  void (*add)(const Lattice&, const VectorXd&, VectorXd&);
  double (*energy)(const Lattice&, const VectorXd&);
};
constexpr NamedLaw kLaws[] = {{"stretch", add_stretch, stretch_energy},
                              {"shear", add_shear, shear_energy},
                              {"bending", add_bending, bending_energy}};

VectorXd law_force(const NamedLaw& law, const Lattice& lattice, const VectorXd& r) {
  VectorXd F = VectorXd::Zero(r.size());
  law.add(lattice, r, F);
  return F;
}

// 4 x 3 cells, the last column and row cut.
Lattice cut_lattice(scene::BiasModel model = scene::BiasModel::kOdd) {
  Scene scene = rectangle(curved_fabric(), 0.0345, 0.0272, 0.01);
  scene.bias_model = model;
  return lattice_make(scene);
}

int sharp_folds(const Lattice& lattice, const VectorXd& r) {
  int count = 0;
  for (const Hinge& h : lattice.hinges) {
    const Vector3d a = r.segment<3>(3 * h.j) - r.segment<3>(3 * h.i);
    const Vector3d c = r.segment<3>(3 * h.k) - r.segment<3>(3 * h.j);
    if (a.normalized().dot(c.normalized()) < -0.5) ++count;
  }
  return count;
}

// Central differences at h and h/2, combined to fourth order. The error is O((h/L)^4) of the force, with L
// the length over which the laws curve (at least 0.05 b), and rounding epsilon E/(h F), E/F about b: 1e-11
// and 1e-12 for h = 1e-4 b.
TEST(ReferenceForces, AreMinusTheGradientOfTheirEnergy) {
  for (scene::BiasModel model :
       {scene::BiasModel::kOdd, scene::BiasModel::kTension, scene::BiasModel::kPaper}) {
    const Lattice lattice = cut_lattice(model);
    const VectorXd r = crumpled(lattice, 0.012, 11);
    ASSERT_GT(sharp_folds(lattice, r), 0);
    for (const NamedLaw& law : kLaws) {
      const VectorXd F = law_force(law, lattice, r);
      const auto difference = [&](Eigen::Index k, double h) {
        VectorXd up = r, down = r;
        up[k] += h;
        down[k] -= h;
        return -(law.energy(lattice, up) - law.energy(lattice, down)) / (up[k] - down[k]);
      };
      const double h = 1e-6, largest = F.lpNorm<Eigen::Infinity>();
      ASSERT_GT(largest, 0) << law.name;
      for (Eigen::Index k = 0; k < r.size(); ++k) {
        const double numeric = (4 * difference(k, h / 2) - difference(k, h)) / 3;
        EXPECT_NEAR(F[k], numeric, 1e-9 * largest) << law.name << ", coordinate " << k;
      }
    }
  }
}

TEST(ReferenceForces, HaveNoNetForceOrTorque) {
  const Lattice lattice = cut_lattice();
  for (unsigned seed = 0; seed < 20; ++seed) {
    const VectorXd r = crumpled(lattice, 0.012, seed);
    for (const NamedLaw& law : kLaws) {
      const VectorXd F = law_force(law, lattice, r);
      Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
      double force_sum = 0, torque_sum = 0;
      for (int n = 0; n < lattice.count; ++n) {
        const Vector3d x = r.segment<3>(3 * n), f = F.segment<3>(3 * n);
        force += f;
        torque += x.cross(f);
        force_sum += f.norm();
        torque_sum += x.norm() * f.norm();
      }
      EXPECT_LE(force.norm(), 1e-14 * force_sum) << law.name;
      EXPECT_LE(torque.norm(), 1e-13 * torque_sum) << law.name;
    }
  }
}

TEST(ReferenceForces, TurnWithTheCloth) {
  const Lattice lattice = cut_lattice();
  const VectorXd r = crumpled(lattice, 0.004, 5);
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  VectorXd turned(r.size());
  for (int n = 0; n < lattice.count; ++n) turned.segment<3>(3 * n) = Q * r.segment<3>(3 * n);
  for (const NamedLaw& law : kLaws) {
    const VectorXd F = law_force(law, lattice, r), G = law_force(law, lattice, turned);
    for (int n = 0; n < lattice.count; ++n) {
      EXPECT_LE((Q * F.segment<3>(3 * n) - G.segment<3>(3 * n)).norm(), 1e-12 * F.lpNorm<Eigen::Infinity>())
          << law.name;
    }
  }
}

// At rest a link's strain is rounding, a few epsilon |r|/b, and its force is k w times that.
TEST(ReferenceForces, VanishAtRest) {
  const Lattice lattice = cut_lattice();
  const double k = 400, b = 0.01, reach = 0.05;
  const VectorXd F = forces(lattice, lattice.position);
  EXPECT_LE(F.lpNorm<Eigen::Infinity>(), 16 * kEpsilon * k * b * reach / b);
}

TEST(ReferenceForces, StretchedLinkPullsWithItsDiagram) {
  const Scene whole = rectangle(curved_fabric(), 0.04, 0.04, 0.01);
  Scene paper = whole;
  paper.scaling = scene::Scaling::kPaperArea;
  paper.bias_model = scene::BiasModel::kTension;
  paper.clamp_correction = false;
  const double b = 0.01, e = 0.25, F_strip = 18;
  for (const Scene& scene : {whole, paper}) {
    const Lattice lattice = lattice_make(scene);
    // One inner warp column is stretched to the diagram's point 2, and only one of its links pulls.
    const int middle = 2 * 5 + 2, above = middle + 5;
    VectorXd r = lattice.position;
    for (int row = 0; row < 5; ++row) r[3 * (5 * row + 2) + 1] *= 1 + e;
    Lattice warp_only = lattice;
    warp_only.weft.clear();
    VectorXd F = VectorXd::Zero(r.size());
    for (auto& link : warp_only.warp) {
      if (link.i != middle || link.j != above) link.width = 0;
    }
    add_stretch(warp_only, r, F);
    const double asked =
        scene.scaling == scene::Scaling::kWidth ? F_strip * b / 0.05 : F_strip * b * b / (0.05 * 0.2);
    EXPECT_NEAR(F[3 * middle + 1], asked, 1e-13 * asked);
    EXPECT_NEAR(F[3 * above + 1], -asked, 1e-13 * asked);
  }
}

// F S_cell/S_pr on a whole link, S_pr = H w_p: for yarns and diagonals alike.
TEST(ReferenceForces, PaperAreaGivesTheDiagonalsTheCellsShare) {
  Scene scene = rectangle(curved_fabric(), 0.04, 0.04, 0.01);
  scene.scaling = scene::Scaling::kPaperArea;
  scene.bias_model = scene::BiasModel::kPaper;
  scene.clamp_correction = false;
  const Lattice lattice = lattice_make(scene);
  const double asked = 2.5 * 0.01 * 0.01 / (0.05 * 0.2), e = 0.15;
  EXPECT_NEAR(lattice.bias[0].width * curve_value(lattice.laws[2].curve, e), asked, 1e-13 * asked);
}

// Rolled along one yarn direction with every hinge at the angle a: E = sum B w/b a^2/2. The hinges' widths,
// halves at the two rims, add up to the width of the cloth on each of the inner rows.
TEST(ReferenceForces, RolledClothHoldsTheBendingEnergy) {
  const double b = 0.01, a = 0.3, nu = 0.2, width = 0.04;
  const int cells = 4;
  const Lattice lattice = lattice_make(rectangle(curved_fabric(), width, width, b));
  for (bool warp : {true, false}) {
    const double B = (warp ? 4e-6 : 7e-6) / (1 - nu * nu);
    VectorXd r = lattice.position;
    for (int n = 0; n < lattice.count; ++n) {
      double along = 0, up = 0;
      for (int k = 0; k < (warp ? n / 5 : n % 5); ++k) {
        along += b * std::cos(k * a);
        up += b * std::sin(k * a);
      }
      r[3 * n + (warp ? 1 : 0)] = along;
      r[3 * n + 2] = up;
    }
    const double asked = (cells - 1) * B * width / b * a * a / 2;
    EXPECT_NEAR(bending_energy(lattice, r), asked, 1e-12 * asked);
  }
}

TEST(ReferenceLattice, WeighsAndMeasuresWhatTheOutlineHolds) {
  const Lattice lattice = cut_lattice();
  const double area = 0.0345 * 0.0272;
  double mass = 0, warp = 0, weft = 0, bias = 0;
  for (double m : lattice.mass) mass += m;
  for (const Link& l : lattice.warp) warp += l.width * l.rest;
  for (const Link& l : lattice.weft) weft += l.width * l.rest;
  for (const Link& l : lattice.bias) bias += l.width * l.rest;
  EXPECT_NEAR(mass, 0.15 * area, 1e-13 * 0.15 * area);
  EXPECT_NEAR(warp, area, 1e-13 * area);
  EXPECT_NEAR(weft, area, 1e-13 * area);
  EXPECT_NEAR(bias, 2 * area, 1e-13 * area);
}

// Particles piece by piece, three laws a piece, pins and probes on their own piece.
TEST(ReferenceLattice, PiecesFollowOneAnother) {
  Scene scene = rectangle(curved_fabric(), 0.03, 0.02, 0.01);
  scene.pieces.push_back(scene.pieces[0]);
  scene.pieces[1].cell = 0.005;
  scene.pieces[1].place.origin = {0, 0, 1};
  scene.pins = {{"corner", 1, {{0, 0}}, {}}};
  scene.probes = {{"corner", 1, {0.03, 0.02}}};
  const Lattice lattice = lattice_make(scene);
  EXPECT_EQ(lattice.count, 4 * 3 + 7 * 5);
  EXPECT_EQ(lattice.laws.size(), 6u);
  EXPECT_EQ(lattice.warp.back().law, 3);
  EXPECT_EQ(lattice.cell, 0.005);
  EXPECT_EQ(lattice.rows[0].point.node, std::vector<int>{12});
  EXPECT_EQ(point_value(lattice.probes[0], lattice.position), Vector3d(0.03, 0.02, 1));
  EXPECT_EQ(lattice.position[3 * 12 + 2], 1);
}

TEST(ReferenceLattice, StoredCorrectionReplacesTheClampCorrection) {
  scene::FabricSpec fabric = curved_fabric();
  const double r = 4, K = r * (r - 1.25) / ((r - 1) * (r - 1));
  Scene scene = rectangle(fabric, 0.04, 0.04, 0.01);
  scene.bias_model = scene::BiasModel::kTension;
  EXPECT_NEAR(lattice_make(scene).laws[2].curve.f[3], 2.5 / 0.05 / K, 1e-13);
  scene.fabrics[0].bias.correction = {1, 0.9, 0.8, 0.7};
  EXPECT_NEAR(lattice_make(scene).laws[2].curve.f[3], 2.5 / 0.05 / K, 1e-13);  // made for another law
  scene.bias_model = scene::BiasModel::kOdd;
  EXPECT_NEAR(lattice_make(scene).laws[2].curve.f[3], 2.5 / 0.05 * 0.7, 1e-13);
}

TEST(ReferenceLattice, ZeroForcesSwitchALawOff) {
  scene::FabricSpec fabric = curved_fabric();
  fabric.warp.force.assign(4, 0);
  fabric.bias = {};
  fabric.bending_weft = 0;
  const Lattice lattice = lattice_make(rectangle(fabric, 0.04, 0.04, 0.01));
  EXPECT_TRUE(lattice.laws[0].curve.e.empty());
  EXPECT_FALSE(lattice.laws[1].curve.e.empty());
  EXPECT_TRUE(lattice.laws[2].curve.e.empty());
  EXPECT_EQ(lattice.hinges.size(), 15u);  // 5 columns of 3, along the warp only
  const VectorXd r = crumpled(lattice, 0.002, 1);
  EXPECT_EQ(law_force(kLaws[1], lattice, r).norm(), 0);
}

Fold fold_at(double theta) {
  return fold_of(Vector3d(0.7, 0, 0), Vector3d(std::cos(theta), std::sin(theta), 0) * 1.3);
}

TEST(ReferenceFold, IsAngleOverSineToBeyondARightAngle) {
  for (double theta : {1e-9, 1e-4, 0.0099, 0.0101, 0.5, 1.5, 2.0, 2.094}) {
    const long double exact = (long double)theta / std::sin((long double)theta);
    EXPECT_NEAR(fold_at(theta).psi, double(exact), 8 * kEpsilon * double(exact)) << theta;
    EXPECT_NEAR(fold_at(theta).energy, theta * theta / 2, 8 * kEpsilon * theta * theta) << theta;
  }
}

// Beyond 120 degrees psi departs from theta/sin(theta) by psi_3 x^3/6 (1 + O(x)), so value, slope and
// curvature are those of the angle. psi_3 = (5 y psi_2 + 4 psi_1)/(1 - y^2) at y = -1/2: differentiate (1 -
// y^2) psi' = y psi - 1 three times.
TEST(ReferenceFold, ContinuationAgreesToThirdOrder) {
  const double psi_0 = 4 * kPi / (3 * std::numbers::sqrt3), psi_1 = (-psi_0 / 2 - 1) / 0.75;
  const double psi_2 = (psi_0 - 1.5 * psi_1) / 0.75, psi_3 = (-2.5 * psi_2 + 4 * psi_1) / 0.75;
  for (double d : {1e-3, 2e-3, 4e-3}) {
    const double theta = std::acos(-0.5 - d), gap = fold_at(theta).psi - theta / std::sin(theta);
    EXPECT_NEAR(gap / (psi_3 * d * d * d / 6), 1, 4 * d) << d;
    // The difference in energy is the integral of that in psi: psi_3 d^4/24, beyond rounding.
    const double lost = fold_at(theta).energy - theta * theta / 2;
    EXPECT_NEAR(lost, psi_3 * d * d * d * d / 24, 4 * d * std::abs(psi_3) * d * d * d * d / 24 + 8 * kEpsilon)
        << d;
  }
}

TEST(ReferenceFold, FullFoldIsFinite) {
  const Fold full = fold_at(kPi);
  EXPECT_NEAR(full.y, -1, kEpsilon);
  const double psi_0 = 4 * kPi / (3 * std::numbers::sqrt3), psi_1 = (-psi_0 / 2 - 1) / 0.75;
  const double psi_2 = (psi_0 - 1.5 * psi_1) / 0.75;
  EXPECT_NEAR(full.psi, psi_0 - psi_1 / 2 + psi_2 / 8, 1e-14);
  EXPECT_GT(full.energy, fold_at(2.9).energy);
}

}  // namespace
}  // namespace drape::reference
