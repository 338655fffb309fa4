// Seam closing and welding. Equations: core/README.md, section 6.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "forces/seam_bending.h"
#include "forces/seam_closing.h"
#include "model/elements.h"
#include "model/node_sums.h"
#include "reference/run.h"
#include "reference/sewing.h"
#include "seam_fixture.h"

namespace drape::dynamics {

using namespace tests;
namespace {

using reference::curved_fabric;
using reference::rectangle;

// Two rectangles side by side, the right one displaced by `gap`, each on cells of its own.
Scene pair_of(const scene::FabricSpec& fabric, double side, double cell, double ratio, Vec3 gap) {
  Scene scene = rectangle(fabric, side, side, cell);
  scene.gravity = {0, 0, 0};
  scene.pieces.push_back(scene.pieces[0]);
  scene.pieces[1].name = "right";
  scene.pieces[1].cell = cell * ratio;
  scene.pieces[1].place.origin = {side + gap[0], gap[1], gap[2]};
  scene.seams = {seam_join()};
  return scene;
}

scene::FabricSpec loose() {  // no forces act between its nodes
  scene::FabricSpec fabric;
  fabric.name = "loose";
  fabric.areal_density = 0.15;
  return fabric;
}

double gap_norm(const Assembled& a, std::size_t pair) {
  return math::vector3::norm(model::sum_value(a.system.seams.pair[pair].gap, a.state));
}

// Single cells without laws: the nodes of the sewn edges are free particles, and close as
// |d| = d0 (1 + w t) e^{-w t}. Order 2 in the step.
TEST(SeamWelding, FreeParticlesCloseCritically) {
  std::vector<double> errors;
  for (double h : {1e-3, 5e-4, 2.5e-4, 1.25e-4}) {
    Scene scene = pair_of(loose(), 0.01, 0.01, 1, {0.01, 0.002, 0.005});
    scene.seams[0].pull = 100;
    scene.seams[0].speed = 100;
    scene.step = h;
    Assembled a = assemble(scene);
    const double d0 = gap_norm(a, 0), t = 0.02, w = 100;
    for (int k = 0; k < 20; ++k) sewn_advance(a, 1e-3);
    errors.push_back(std::abs(gap_norm(a, 0) - d0 * (1 + w * t) * std::exp(-w * t)) / d0);
    EXPECT_NEAR(gap_norm(a, 1), gap_norm(a, 0), 1e-14);
  }
  std::printf("closing, relative errors: %.2e %.2e %.2e %.2e\n", errors[0], errors[1], errors[2], errors[3]);
  // The rate extrapolated to t_n is off by (3/8) h^2 of its second derivative, and the closing force by 2 w
  // times that: 3/4 (h w)^2.
  EXPECT_LE(errors[0], 0.75 * 0.1 * 0.1);
  for (std::size_t k = 0; k + 1 < errors.size(); ++k) {
    const double order = std::log2(errors[k] / errors[k + 1]);
    EXPECT_NEAR(order, 2, 0.15) << k;
  }
}

// From afar the sides approach at the seam's speed.
TEST(SeamWelding, ComesAtItsSpeed) {
  Scene scene = pair_of(loose(), 0.01, 0.01, 1, {1, 0, 0});
  scene.seams[0].pull = 200;
  scene.seams[0].speed = 0.5;
  Assembled a = assemble(scene);
  for (int k = 0; k < 100; ++k) sewn_advance(a, 1e-3);
  const double before = gap_norm(a, 0);
  for (int k = 0; k < 100; ++k) sewn_advance(a, 1e-3);
  EXPECT_NEAR((before - gap_norm(a, 0)) / 0.1, 0.5, 1e-6);
}

struct Momentum {
  Vec3 linear{0, 0, 0}, angular{0, 0, 0};
};
Momentum momentum_of(Assembled& a) {
  using namespace math::vector3;
  std::vector<math::Wrench> pins;
  Array vx(a.system.nodes), vy(a.system.nodes), vz(a.system.nodes);
  leapfrog_synchronous(a.system, a.motion, a.state, {vx.data(), vy.data(), vz.data()}, pins);
  Momentum sum;
  for (std::size_t n : a.system.particle) {
    const Vec3 p = a.system.mass[n] * Vec3{vx[n], vy[n], vz[n]};
    sum.linear += p;
    sum.angular += cross(Vec3{a.state.x[n], a.state.y[n], a.state.z[n]}, p);
  }
  return sum;
}

// Closing and welding conserve linear momentum; closing conserves angular momentum too.
TEST(SeamWelding, KeepsMomentum) {
  for (double ratio : {1.0, std::numbers::sqrt2, 2.0}) {
    Scene scene = pair_of(curved_fabric(), 0.05, 0.01, ratio, {0.004, 0.001, 0.003});
    scene.pieces[0].velocity = {0.3, -0.2, 0.1};
    Assembled a = assemble(scene);
    const Momentum start = momentum_of(a);
    double scale = 0;
    for (std::size_t n : a.system.particle) scale += a.system.mass[n] * 1.0;  // kg at 1 m/s
    bool welded = false;
    for (int k = 0; k < 300; ++k) {
      sewn_advance(a, 1e-3);
      welded = welded || a.state.sewn[0] == model::Sewn::kWelded;
      const Momentum now = momentum_of(a);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(now.linear[i], start.linear[i], 1e-12 * scale);
        if (!welded) {  // to the truncation of the steps
          EXPECT_NEAR(now.angular[i], start.angular[i], 1e-6 * scale);
        }
      }
    }
    EXPECT_EQ(std::count(a.state.sewn.begin(), a.state.sewn.end(), model::Sewn::kWelded),
              std::ptrdiff_t(a.state.sewn.size()));
    for (std::size_t p = 0; p < a.state.sewn.size(); ++p) EXPECT_LE(gap_norm(a, p), 1e-15);
  }
}

// A weld projects with the masses. With d the gap and v' the gap's velocity before it, the angular momentum
// jumps only by that of the displacement and of the impulse; on two free particles by mu d x v'.
TEST(SeamWelding, JumpsAtAWeldByWhatTheGapCarries) {
  Scene scene = pair_of(loose(), 0.01, 0.01, 1, {5e-5, 3e-5, 2e-5});
  scene.seams[0].pull = 100;
  Assembled a = assemble(scene);
  seams_pull_begin(a.system, a.state);
  for (std::size_t n : a.system.particle)
    a.state.vx[n] = 0.1 * double(n % 7), a.state.vy[n] = 0.05 * double(n % 5);
  Vec3 expected{0, 0, 0};
  for (const model::SeamPair& pair : a.system.seams.pair) {
    const Vec3 d = model::sum_value(pair.gap, a.state),
               v = model::sum_value(pair.gap, a.state.vx, a.state.vy, a.state.vz);
    using namespace math::vector3;
    expected -= forces::seam_mass(a.system, pair) * cross(d, v);
  }
  const Momentum before = momentum_of(a);
  seams_weld(a.system, a.motion, a.state, seams_within_tolerance(a.system, a.state));
  const Momentum after = momentum_of(a);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(after.linear[i], before.linear[i], 1e-18);
    EXPECT_NEAR(after.angular[i] - before.angular[i], expected[i], 1e-18);
  }
}

// The reference solver sews the same system: order 2 before the weld and after it.
TEST(SeamWelding, AgreesWithTheReference) {
  for (double until : {0.012, 0.06}) {
    std::vector<double> errors;
    for (double h : {2e-5, 1e-5, 5e-6}) {
      Scene scene = pair_of(curved_fabric(), 0.04, 0.01, std::numbers::sqrt2, {0.001, 0, 0.0005});
      scene.seams[0].pull = 400;
      scene.seams[0].speed = 10;
      if (until < 0.02) scene.seams[0].gap_tolerance = 1e-9;
      scene.step = h;
      scene.damping = 1;
      Assembled a = assemble(scene);
      for (int k = 0; k < int(std::lround(until / 1e-3)); ++k) sewn_advance(a, 1e-3);
      const reference::ReferenceState exact = reference::reference_state_at(scene, {}, until, 1e-11);
      errors.push_back((positions(a) - exact.r).cwiseAbs().maxCoeff());
      EXPECT_EQ(a.state.sewn[0], until < 0.02 ? model::Sewn::kPulled : model::Sewn::kWelded);
    }
    std::printf("sewing against the judge at %g s: %.3e %.3e %.3e m\n", until, errors[0], errors[1],
                errors[2]);
    for (std::size_t k = 0; k + 1 < errors.size(); ++k)
      EXPECT_NEAR(std::log2(errors[k] / errors[k + 1]), 2, 0.2) << until;
  }
}

// Accelerations F/m as the welds leave them.
Eigen::VectorXd welded(Assembled& a, const Eigen::VectorXd& force) {
  Array f[3];
  for (std::size_t k = 0; k < 3; ++k) {
    f[k].assign(a.system.nodes, 0.0);
    for (std::size_t n = 0; n < a.system.particle.size(); ++n)
      f[k][a.system.particle[n]] =
          force[Eigen::Index(3 * n + k)] * a.system.inverse_mass[a.system.particle[n]];
  }
  held_rates(a.motion.constraints, a.state, model::Pass::kAcceleration, a.motion.held);
  constraints_project(a.system, a.motion.constraints, a.motion.held, {f[0].data(), f[1].data(), f[2].data()},
                      nullptr);
  Eigen::VectorXd left(force.size());
  for (std::size_t n = 0; n < a.system.particle.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) left[Eigen::Index(3 * n + k)] = f[k][a.system.particle[n]];
  return left;
}

// Hinges across a seam and links along it, at a crumpled state that is sewn. After the projection by the
// welds, the kernel's forces equal those of the reference solver, which gives both sides half of what the
// kernel gives one. There is no net force or torque.
TEST(SeamWelding, BendsAsTheReference) {
  Scene scene = pair_of(curved_fabric(), 0.05, 0.01, 1.3, {0, 0, 0});
  scene.pieces[1].outline = {
      {0, -0.003}, {0.05, 0}, {0.05, 0.05}, {0.004, 0.058}};  // longer by a fifth, oblique
  scene.pieces[1].grain = 0.3;
  scene.seams[0].tape = 3;
  Assembled a = assemble(scene);
  a.state.sewn.assign(a.state.sewn.size(), model::Sewn::kWelded);
  crumple(a, 5e-4, 7);
  seams_restore(a.system, a.motion, a.state);
  constraints_place(a.system, a.motion.constraints, a.motion.held,
                    {a.state.x.data(), a.state.y.data(), a.state.z.data()});
  const Eigen::VectorXd r = positions(a);
  reference::Motion motion = reference::motion_make(scene);
  motion.sewing[0].assign(a.state.sewn.size(), reference::Stage::kWelded);
  Eigen::VectorXd bonds = Eigen::VectorXd::Zero(r.size());
  reference::add_bonds(motion.lattice, motion.sewing, r, bonds);
  const Eigen::VectorXd exact = reference::forces(motion.lattice, r) + bonds;
  const Eigen::VectorXd fast = forces_by(*a.motion.kernel, a);
  const Eigen::VectorXd left = welded(a, exact), cloth = welded(a, exact - bonds);
  EXPECT_LE((welded(a, fast) - left).cwiseAbs().maxCoeff(), 1e-12 * left.cwiseAbs().maxCoeff());
  EXPECT_GT((left - cloth).cwiseAbs().maxCoeff(), 1e-3 * left.cwiseAbs().maxCoeff());
  for (const Eigen::VectorXd& all : {bonds, Eigen::VectorXd(fast - (exact - bonds))}) {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = force;
    for (Eigen::Index n = 0; n < r.size(); n += 3) {
      force += all.segment<3>(n);
      torque += r.segment<3>(n).cross(all.segment<3>(n));
    }
    EXPECT_LE(force.norm(), 1e-12 * exact.norm());
    EXPECT_LE(torque.norm(), 1e-12 * exact.norm());
  }

  // dE = -F dr, by central differences over a micrometre
  Eigen::VectorXd step = Eigen::VectorXd::Random(r.size()) * 1e-6;
  const auto energy = [&](double sign) {
    const reference::BondEnergy e = reference::bond_energy(motion.lattice, motion.sewing, r + sign * step);
    return e.bending + e.stretch;
  };
  EXPECT_NEAR(energy(1) - energy(-1), -2 * bonds.dot(step), 1e-5 * bonds.norm() * step.norm());
  const forces::SeamEnergy reported = forces::seams_energy(a.system, a.state);
  const reference::BondEnergy expected = reference::bond_energy(motion.lattice, motion.sewing, r);
  EXPECT_NEAR(reported.bending, expected.bending, 1e-12 * expected.bending);
  EXPECT_NEAR(reported.stretch, expected.stretch, 1e-12 * expected.stretch);
}

// Pins hold both edges 5e-5 m apart, off the grid: their rows leave almost nothing to the welds, which must
// not close the gap with that remainder. The cloth stays as it is.
TEST(SeamWelding, LeavesToPinsWhatTheyHold) {
  Scene scene = pair_of(curved_fabric(), 0.1, 0.02, 1, {5e-5, 0, 0});
  scene.pieces[0].grain = 0.02;
  scene.pieces[1].grain = -0.02;
  scene.pins = {{"a", 0, {}, {1}}, {"b", 1, {}, {3}}};
  Assembled a = assemble(scene);
  for (int k = 0; k < 20; ++k) sewn_advance(a, 1e-3);
  for (const model::Lattice& l : a.system.lattices)
    model::links_visit(a.system, l, [&](const model::Link& link) {
      EXPECT_LE(std::abs(model::link_strain(a.state, link)), 5e-3);
    });
}

// Sewing does not distort the outlines. Once pieces are joined, free and unloaded, their edges have the
// length and their corners the angle of the pattern, within 0.5 %; a whole corner has pi/2.
TEST(SeamWelding, KeepsTheShapeOfOutlines) {
  for (double ratio : {1.0, std::numbers::sqrt2, 3.0}) {
    Scene scene = pair_of(curved_fabric(), 0.06, 0.006, ratio, {0.004, 0.001, 0.003});
    scene.damping = 20;
    scene.pieces[1].grain = 0.3;
    Assembled a = assemble(scene);
    double worst_length = 0, worst_angle = 0, first = 0, second = 0;
    for (int k = 0; k < 1000; ++k) {
      sewn_advance(a, 1e-3);
      worst_length = worst_angle = 0;
      for (std::size_t p = 0; p < 2; ++p) {
        const piece::Grid grid = piece::grid_make(scene, int(p));
        const auto place = [&](std::size_t corner) {
          const piece::GridPoint at = piece::grid_locate(grid, scene.pieces[p].outline[corner % 4]);
          Vec3 sum{0, 0, 0};
          for (int n = 0; n < 4; ++n) {
            const std::size_t node = a.system.lattices[p].node_of(at.node[n]);
            using namespace math::vector3;
            sum += at.weight[n] * Vec3{a.state.x[node], a.state.y[node], a.state.z[node]};
          }
          return sum;
        };
        using namespace math::vector3;
        for (std::size_t e = 0; e < 4; ++e) {
          const Vec3 edge = place(e + 1) - place(e), next = place(e + 2) - place(e + 1);
          worst_length = std::max(worst_length, std::abs(norm(edge) / 0.06 - 1));
          worst_angle = std::max(worst_angle,
                                 std::abs(std::acos(dot(edge, next) / (norm(edge) * norm(next))) - M_PI / 2));
        }
      }
      first = std::max(first, worst_length);
      second = std::max(second, worst_angle);
    }
    std::printf("outlines, ratio %.2f: length within %.1e, angle within %.1e; on the way %.1e, %.1e\n", ratio,
                worst_length, worst_angle / (M_PI / 2), first, second / (M_PI / 2));
    EXPECT_LE(worst_length, 5e-3);
    EXPECT_LE(worst_angle, 5e-3 * M_PI / 2);
  }
}

// A fit does not rest while a seam waits for its time or is being closed.
TEST(SeamWelding, KeepsARelaxationFromResting) {
  Scene scene = pair_of(curved_fabric(), 0.05, 0.01, 1, {0.002, 0, 0});
  scene.mode = scene::Mode::kFit;
  scene.seams[0].closed_at = 0.3;
  Assembled a = assemble(scene);
  for (int k = 0; k < 300; ++k) sewn_advance(a, 1e-3);
  EXPECT_FALSE(a.state.relaxation.at_rest);
  for (int k = 0; k < 1500 && !a.state.relaxation.at_rest; ++k) sewn_advance(a, 1e-3);
  EXPECT_TRUE(a.state.relaxation.at_rest);
  EXPECT_EQ(std::count(a.state.sewn.begin(), a.state.sewn.end(), model::Sewn::kWelded),
            std::ptrdiff_t(a.state.sewn.size()));
}

// Pairs under the closing force are bounded at 0.99 of the limit and grow at 1.01. The nodes of single cells
// share nothing, so the bound is exact.
TEST(SeamWelding, ReportsTheLimitOfItsPull) {
  for (double share : {0.99, 1.01}) {
    Scene scene = pair_of(loose(), 0.01, 0.01, 1, {0.01, 0, 0});
    scene.seams[0].pull = 1000;
    scene.seams[0].speed = 1e3;
    Assembled a = assemble(scene);
    seams_pull_begin(a.system, a.state);
    const double limit = step_limit_of(a.system, step_limit_omega2(a.system, *a.motion.kernel, a.state));
    EXPECT_EQ(step_limit_link(a.system, scene, a.state), "pull of seam 'join'");
    const double start = gap_norm(a, 0);
    for (int k = 0; k < 4000; ++k) leapfrog_step(a.system, a.motion, a.state, share * limit);
    if (share < 1) {
      EXPECT_LE(gap_norm(a, 0), start);
    } else {
      EXPECT_GT(gap_norm(a, 0), 10 * start);
    }
  }
}

}  // namespace
}  // namespace drape::dynamics
